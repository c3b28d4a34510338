//! Rational functions of a kernel's inputs, evaluated without rounding.

use num_bigint::BigInt;
use num_rational::BigRational;
use rug::ops::Pow;
use rug::{Integer, Rational};

use crate::expression::Expr;

/// A rational function; variables are positions in the list of inputs.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Exact {
    Number(Rational),
    Variable(usize),
    Sum(Vec<Exact>),
    Product(Vec<Exact>),
    Power(Box<Exact>, i32),
}

impl Exact {
    /// An expression of these variables; `None` if it is no rational function of them.
    pub(super) fn of(expression: &Expr, variables: &[String]) -> Option<Self> {
        let all = |parts: &[Expr]| parts.iter().map(|part| Self::of(part, variables)).collect::<Option<_>>();
        match expression {
            Expr::Rational(value) => number(value),
            Expr::Symbol(name) => variables.iter().position(|variable| variable == name).map(Self::Variable),
            Expr::Sum(terms) => all(terms).map(Self::Sum),
            Expr::Product(factors) => all(factors).map(Self::Product),
            Expr::Power(base, exponent) => Some(Self::Power(Box::new(Self::of(base, variables)?), *exponent)),
            _ => None,
        }
    }

    /// The value at a point; `None` at a pole.
    pub(super) fn at(&self, point: &[Rational]) -> Option<Rational> {
        Some(match self {
            Self::Number(value) => value.clone(),
            Self::Variable(index) => point.get(*index)?.clone(),
            Self::Sum(terms) => all(terms, point)?.into_iter().fold(Rational::new(), |sum, term| sum + term),
            Self::Product(factors) => {
                all(factors, point)?.into_iter().fold(Rational::from(1), |product, factor| product * factor)
            }
            Self::Power(base, exponent) => power(base.at(point)?, *exponent)?,
        })
    }

    /// Whether the function names a variable.
    pub(super) fn uses(&self, variable: usize) -> bool {
        match self {
            Self::Number(_) => false,
            Self::Variable(index) => *index == variable,
            Self::Sum(parts) | Self::Product(parts) => parts.iter().any(|part| part.uses(variable)),
            Self::Power(part, _) => part.uses(variable),
        }
    }
}

/// The number in the arithmetic of decisions, which is GMP's because sampling makes many of them.
fn number(value: &BigRational) -> Option<Exact> {
    let integer = |number: &BigInt| number.to_string().parse::<Integer>().ok();
    Some(Exact::Number(Rational::from((integer(value.numer())?, integer(value.denom())?))))
}

fn all(parts: &[Exact], point: &[Rational]) -> Option<Vec<Rational>> {
    parts.iter().map(|part| part.at(point)).collect()
}

fn power(base: Rational, exponent: i32) -> Option<Rational> {
    if exponent < 0 && base.is_zero() { None } else { Some(base.pow(exponent)) }
}
