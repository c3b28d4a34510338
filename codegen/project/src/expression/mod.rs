//! Exact expressions: what a reference expression means, free of Maxima's syntax and of any float.

mod lower;

pub use lower::{LowerError, lower, lower_errors, remedy_of_constant, remedy_of_function};

use num_rational::BigRational;
use num_traits::Zero;
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
    /// The largest or the smallest of some values.
    Extreme {
        /// Whether it is the largest one.
        largest: bool,
        /// The values.
        items: Vec<Expr>,
    },
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
            Self::Sum(items) | Self::Product(items) | Self::Extreme { items, .. } => {
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
            Self::Sum(items) | Self::Product(items) | Self::Extreme { items, .. } => {
                items.iter().any(Self::has_power_of_sum)
            }
            Self::Power(base, _) => matches!(**base, Self::Sum(_)) || base.has_power_of_sum(),
            Self::Sqrt(base) | Self::Abs(base) => base.has_power_of_sum(),
            Self::PositiveRoot { polynomial, .. } => polynomial.has_power_of_sum(),
        }
    }

    /// The derivative by a variable; `None` where an absolute value, a choice or a polynomial root depends on it.
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
            Self::Abs(_) | Self::Extreme { .. } | Self::PositiveRoot { .. } => None,
        }
    }

    /// Whether the expression is the constant zero, as written.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Rational(value) if value.is_zero())
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of an expression of rational operations at x = `at`.
    fn value(expr: &Expr, at: &BigRational) -> BigRational {
        match expr {
            Expr::Rational(number) => number.clone(),
            Expr::Symbol(_) => at.clone(),
            Expr::Sum(items) => items.iter().map(|item| value(item, at)).sum(),
            Expr::Product(items) => items.iter().map(|item| value(item, at)).product(),
            Expr::Power(base, exponent) => value(base, at).pow(*exponent),
            _ => panic!("{expr:?} has no rational value"),
        }
    }

    #[test]
    fn derivatives_are_exact() {
        let x = || Expr::symbol("x");
        // x^3/(x + 1), whose derivative at 2 is (2*8 + 3*4)/9
        let quotient = Expr::Power(Box::new(x()), 3).over(x().plus(Expr::integer(1)));
        let two = BigRational::from_integer(2.into());
        let slope = value(&quotient.derivative("x").unwrap(), &two);
        assert_eq!(slope, BigRational::new(28.into(), 9.into()));
        assert!(quotient.derivative("y").unwrap().is_zero());
        assert_eq!(Expr::Abs(Box::new(x())).derivative("x"), None);
    }

    #[test]
    fn a_power_of_a_sum_is_found_wherever_it_stands() {
        let square = Expr::Power(Box::new(Expr::symbol("x").plus(Expr::symbol("y"))), 2);
        assert!(Expr::integer(3).times(square).has_power_of_sum());
        assert!(!Expr::Power(Box::new(Expr::symbol("x")), 2).plus(Expr::symbol("y")).has_power_of_sum());
    }
}
