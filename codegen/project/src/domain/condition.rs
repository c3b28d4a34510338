//! One condition in exact form: comparisons of rational functions, joined by `and` and `or`.
//!
//! A comparison has no value where something that is written in it divides by zero, and then neither holds nor fails.
//! `and` fails where one part does, `or` holds where one does, `not` holds where its part fails (Kleene's logic): so
//! `not` moves to the comparisons and turns them, and what is left holds by comparisons whose divisors are not zero.

use closedform_maxima::Relation;
use rug::Rational;

use super::exact::Exact;
use crate::expression::Expr;

/// A condition on the inputs of a kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// A comparison.
    Compare(Comparison),
    /// All hold.
    And(Vec<Condition>),
    /// One holds at least.
    Or(Vec<Condition>),
}

/// Two rational functions compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// How.
    pub relation: Relation,
    /// The side before the operator.
    pub lhs: Expr,
    /// The side after the operator.
    pub rhs: Expr,
    /// `lhs - rhs`, made ready to be decided at points.
    decided: Exact,
    divisors: Vec<Comparison>,
}

impl Condition {
    /// Whether the condition holds at a point, one coordinate a variable.
    pub fn holds(&self, point: &[Rational]) -> bool {
        match self {
            Self::Compare(comparison) => comparison.holds(point),
            Self::And(parts) => parts.iter().all(|part| part.holds(point)),
            Self::Or(parts) => parts.iter().any(|part| part.holds(point)),
        }
    }

    /// The condition that holds where this one fails: neither does where a comparison that matters has no value.
    pub(super) fn turned(&self) -> Self {
        let each = |parts: &[Self]| parts.iter().map(Self::turned).collect();
        match self {
            Self::Compare(comparison) => Self::Compare(comparison.turned()),
            Self::And(parts) => Self::Or(each(parts)),
            Self::Or(parts) => Self::And(each(parts)),
        }
    }

    /// Every comparison in the condition, those of divisors with zero before the one in which they stand.
    pub fn comparisons(&self) -> Vec<&Comparison> {
        match self {
            Self::Compare(comparison) => comparison.divisors.iter().chain([comparison]).collect(),
            Self::And(parts) | Self::Or(parts) => parts.iter().flat_map(Self::comparisons).collect(),
        }
    }
}

impl Comparison {
    /// Two functions of these variables compared; `None` if one of them is not rational.
    pub(super) fn new(relation: Relation, lhs: Expr, rhs: Expr, variables: &[String]) -> Option<Self> {
        let decided = Exact::of(&lhs.clone().minus(rhs.clone()), variables)?;
        Some(Self { relation, lhs, rhs, decided, divisors: Vec::new() })
    }

    /// The same, which has no value where one of these, comparisons of divisors with zero, fails.
    pub(super) fn divided_by(self, divisors: Vec<Comparison>) -> Self {
        Self { divisors, ..self }
    }

    /// What is divided by in the comparison, each compared with zero: where one of these fails, the comparison has no
    /// value.
    pub fn divisors(&self) -> &[Comparison] {
        &self.divisors
    }

    /// The comparison that holds where this one fails.
    fn turned(&self) -> Self {
        Self { relation: self.relation.negated(), ..self.clone() }
    }

    /// Whether the comparison holds at a point.
    pub fn holds(&self, point: &[Rational]) -> bool {
        self.divisors.iter().all(|divisor| divisor.holds(point))
            && self.difference_at(point).is_some_and(|difference| self.relation.holds(difference.cmp0()))
    }

    /// `lhs - rhs`
    pub fn difference(&self) -> Expr {
        self.lhs.clone().minus(self.rhs.clone())
    }

    /// `lhs - rhs` at a point; `None` at a pole.
    pub fn difference_at(&self, point: &[Rational]) -> Option<Rational> {
        self.decided.at(point)
    }

    /// Whether the comparison names a variable, given by its position.
    pub fn uses(&self, variable: usize) -> bool {
        self.decided.uses(variable)
    }
}
