//! Rational functions of a kernel's inputs, evaluated without rounding.

use rug::Rational;
use rug::ops::Pow;

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
    /// The difference of two functions.
    pub(super) fn minus(self, other: Self) -> Self {
        Self::Sum(vec![self, other.negated()])
    }

    /// The function with the other sign.
    pub(super) fn negated(self) -> Self {
        Self::Product(vec![Self::Number(Rational::from(-1)), self])
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

fn all(parts: &[Exact], point: &[Rational]) -> Option<Vec<Rational>> {
    parts.iter().map(|part| part.at(point)).collect()
}

fn power(base: Rational, exponent: i32) -> Option<Rational> {
    if exponent < 0 && base.is_zero() { None } else { Some(base.pow(exponent)) }
}
