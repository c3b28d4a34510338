//! Exact expressions: what a reference expression means, free of Maxima's syntax and of any float.

mod lower;

pub use lower::{LowerError, lower};

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeSet;

/// A closed form over named variables with exact rational constants.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// An exact rational number.
    Rational(BigRational),
    /// The circle constant.
    Pi,
    /// A variable.
    Symbol(String),
    /// A sum of terms.
    Sum(Vec<Expr>),
    /// A product of factors.
    Product(Vec<Expr>),
    /// An integer power.
    Power(Box<Expr>, i32),
    /// The nonnegative square root.
    Sqrt(Box<Expr>),
    /// The absolute value.
    Abs(Box<Expr>),
    /// The one positive root of a polynomial in `unknown`.
    PositiveRoot {
        /// The polynomial, as an expression.
        polynomial: Box<Expr>,
        /// Its unknown.
        unknown: String,
    },
}

impl Expr {
    /// An integer constant.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self::Rational(BigRational::from_integer(value.into()))
    }

    /// A variable.
    #[must_use]
    pub fn symbol(name: &str) -> Self {
        Self::Symbol(name.to_owned())
    }

    /// The sum of two expressions.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self::Sum(vec![self, other])
    }

    /// The difference of two expressions.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self::Sum(vec![self, other.negated()])
    }

    /// The product of two expressions.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self::Product(vec![self, other])
    }

    /// The quotient of two expressions.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        Self::Product(vec![self, Self::Power(Box::new(other), -1)])
    }

    /// The negative of an expression.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::Rational(value) => Self::Rational(-value),
            other => Self::Product(vec![Self::integer(-1), other]),
        }
    }

    /// The names of all free variables.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        self.collect_symbols(&mut names);
        names
    }

    fn collect_symbols(&self, names: &mut BTreeSet<String>) {
        match self {
            Self::Rational(_) | Self::Pi => {}
            Self::Symbol(name) => {
                names.insert(name.clone());
            }
            Self::Sum(items) | Self::Product(items) => {
                for item in items {
                    item.collect_symbols(names);
                }
            }
            Self::Power(base, _) | Self::Sqrt(base) | Self::Abs(base) => base.collect_symbols(names),
            Self::PositiveRoot { polynomial, unknown } => {
                let mut inner = polynomial.symbols();
                inner.remove(unknown);
                names.extend(inner);
            }
        }
    }

    /// Whether a power of a sum occurs in it.
    #[must_use]
    pub fn has_power_of_sum(&self) -> bool {
        match self {
            Self::Rational(_) | Self::Pi | Self::Symbol(_) => false,
            Self::Sum(items) | Self::Product(items) => items.iter().any(Self::has_power_of_sum),
            Self::Power(base, _) => matches!(**base, Self::Sum(_)) || base.has_power_of_sum(),
            Self::Sqrt(base) | Self::Abs(base) => base.has_power_of_sum(),
            Self::PositiveRoot { polynomial, .. } => polynomial.has_power_of_sum(),
        }
    }

    /// The derivative by a variable; `None` where an absolute value or a polynomial root depends on it.
    #[must_use]
    pub fn derivative(&self, by: &str) -> Option<Self> {
        if !self.symbols().contains(by) {
            return Some(Self::integer(0));
        }
        match self {
            Self::Rational(_) | Self::Pi => Some(Self::integer(0)),
            Self::Symbol(name) => Some(Self::integer(i64::from(name == by))),
            Self::Sum(items) => items.iter().map(|item| item.derivative(by)).collect::<Option<_>>().map(Self::Sum),
            Self::Product(items) => derivative_of_product(items, by),
            Self::Power(base, exponent) => Some(Self::Product(vec![
                Self::integer(i64::from(*exponent)),
                Self::Power(base.clone(), exponent - 1),
                base.derivative(by)?,
            ])),
            Self::Sqrt(base) => Some(base.derivative(by)?.over(Self::integer(2).times(self.clone()))),
            Self::Abs(_) | Self::PositiveRoot { .. } => None,
        }
    }

    /// Whether the expression is the constant zero, as written.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Rational(value) if value.is_zero())
    }

    /// Whether the expression is the constant one, as written.
    #[must_use]
    pub fn is_one(&self) -> bool {
        matches!(self, Self::Rational(value) if value.is_one())
    }

    /// Whether the expression is written with a leading minus.
    #[must_use]
    pub fn is_negative_constant(&self) -> bool {
        matches!(self, Self::Rational(value) if value.is_negative())
    }
}

fn derivative_of_product(items: &[Expr], by: &str) -> Option<Expr> {
    let mut terms = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let mut factors = items.to_vec();
        factors[index] = item.derivative(by)?;
        terms.push(Expr::Product(factors));
    }
    Some(Expr::Sum(terms))
}
