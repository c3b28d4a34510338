//! The phase of solvers: roots of polynomials that have no closed form become steps that find them.

pub mod monotone_newton;

use super::builder::Builder;
use crate::algebra::{Polynomial, Var};
use crate::field::TowerError;
use crate::program::Node;
use thiserror::Error;

/// Makes the steps of the one positive root of an equation.
pub type Solver = fn(&mut Builder, &Equation) -> Result<Node, RootError>;

/// That a polynomial is zero.
pub struct Equation {
    /// The polynomial.
    pub polynomial: Polynomial,
    /// The variable that is looked for.
    pub unknown: Var,
}

/// Why a solver cannot be used.
#[derive(Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum RootError {
    /// The signs of the coefficients do not show one root.
    #[error(
        "the coefficients of the polynomial must change sign exactly once, from negative (low powers) to positive (high \
         powers), and the domain does not show it; their signs, lowest power first, are: {0}"
    )]
    Signs(String),
    /// The tower has no room left.
    #[error(transparent)]
    Tower(#[from] TowerError),
}
