//! The tree of an exact expression: sums, products, powers, functions and choices over rational numbers and variables.

use closedform_maxima::Relation;
use closedform_syntax::Function;
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
    /// A function of an expression.
    Call(Function, Box<Expr>),
    /// The largest or the smallest of some values.
    Extreme {
        /// Whether it is the largest one.
        largest: bool,
        /// The values.
        items: Vec<Expr>,
    },
    /// The first of two values where a condition holds, else the second.
    Choice(Test, Box<[Expr; 2]>),
    /// The one positive root of a polynomial in `unknown`.
    PositiveRoot {
        /// The polynomial, as an expression.
        polynomial: Box<Expr>,
        /// Its unknown.
        unknown: String,
    },
}

/// A condition of a choice.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// The first compares so with the second.
    Compare(Relation, Box<[Expr; 2]>),
    /// Both hold.
    And(Box<[Test; 2]>),
    /// One holds at least.
    Or(Box<[Test; 2]>),
    /// It does not hold.
    Not(Box<Test>),
}

impl Test {
    /// The expressions that are compared, in order.
    fn compared(&self) -> Vec<&Expr> {
        match self {
            Self::Compare(_, sides) => sides.iter().collect(),
            Self::And(parts) | Self::Or(parts) => parts.iter().flat_map(Self::compared).collect(),
            Self::Not(part) => part.compared(),
        }
    }

    /// The same condition on what `change` makes of the expressions that are compared.
    fn map(&self, change: &mut dyn FnMut(&Expr) -> Expr) -> Self {
        match self {
            Self::Compare(relation, sides) => Self::Compare(*relation, Box::new(sides.each_ref().map(change))),
            Self::And(parts) => Self::And(Box::new(parts.each_ref().map(|part| part.map(change)))),
            Self::Or(parts) => Self::Or(Box::new(parts.each_ref().map(|part| part.map(change)))),
            Self::Not(part) => Self::Not(Box::new(part.map(change))),
        }
    }
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

    /// A function of an expression.
    #[must_use]
    pub fn call(function: Function, argument: Self) -> Self {
        Self::Call(function, Box::new(argument))
    }

    /// The expressions directly inside, in order; of a choice those that are compared come first.
    #[must_use]
    pub fn children(&self) -> Vec<&Expr> {
        match self {
            Self::Rational(_) | Self::Pi | Self::Symbol(_) => Vec::new(),
            Self::Sum(items) | Self::Product(items) | Self::Extreme { items, .. } => items.iter().collect(),
            Self::Choice(test, values) => test.compared().into_iter().chain(values.iter()).collect(),
            Self::Power(inner, _) | Self::Call(_, inner) | Self::PositiveRoot { polynomial: inner, .. } => vec![inner],
        }
    }

    /// The same expression with what `change` makes of those directly inside.
    #[must_use]
    pub fn map(&self, change: &mut dyn FnMut(&Expr) -> Expr) -> Self {
        let mut boxed = |inner: &Expr| Box::new(change(inner));
        match self {
            Self::Rational(_) | Self::Pi | Self::Symbol(_) => self.clone(),
            Self::Power(base, exponent) => Self::Power(boxed(base), *exponent),
            Self::Call(function, inner) => Self::Call(*function, boxed(inner)),
            Self::PositiveRoot { polynomial, unknown } => {
                Self::PositiveRoot { polynomial: boxed(polynomial), unknown: unknown.clone() }
            }
            Self::Sum(items) => Self::Sum(items.iter().map(change).collect()),
            Self::Product(items) => Self::Product(items.iter().map(change).collect()),
            Self::Choice(test, values) => Self::Choice(test.map(change), Box::new(values.each_ref().map(change))),
            Self::Extreme { largest, items } => {
                Self::Extreme { largest: *largest, items: items.iter().map(change).collect() }
            }
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
            Self::Symbol(name) => {
                names.insert(name.clone());
            }
            Self::PositiveRoot { polynomial, unknown } => {
                let mut inner = polynomial.symbols();
                inner.remove(unknown);
                names.extend(inner);
            }
            _ => self.children().iter().for_each(|child| child.collect_symbols(names)),
        }
    }

    /// Whether a power of a sum occurs in it.
    #[must_use]
    pub fn has_power_of_sum(&self) -> bool {
        let is_one = matches!(self, Self::Power(base, _) if matches!(**base, Self::Sum(_)));
        is_one || self.children().into_iter().any(Self::has_power_of_sum)
    }

    /// The expression with others in the place of some variables.
    pub(super) fn with_symbols(&self, values: &[(&str, &Expr)]) -> Self {
        match self {
            Self::Symbol(name) => {
                let value = values.iter().find(|(symbol, _)| symbol == name);
                value.map_or_else(|| self.clone(), |(_, value)| (*value).clone())
            }
            _ => self.map(&mut |child| child.with_symbols(values)),
        }
    }

    /// Whether the expression is the constant zero, as written.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Rational(value) if value.is_zero())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_a_sum_is_found_wherever_it_stands() {
        let square = Expr::Power(Box::new(Expr::symbol("x").plus(Expr::symbol("y"))), 2);
        assert!(Expr::integer(3).times(square).has_power_of_sum());
        assert!(!Expr::Power(Box::new(Expr::symbol("x")), 2).plus(Expr::symbol("y")).has_power_of_sum());
    }
}
