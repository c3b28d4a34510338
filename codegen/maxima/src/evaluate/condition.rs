//! Conditions and the sides of an `if`, whatever the numbers are that they compare.

use std::cmp::Ordering;

use crate::ast::{BinaryOperator, Branch, Expr, ExprKind, UnaryOperator};

/// The numbers of expressions as conditions see them.
pub(super) trait Comparing {
    /// Why something has no value.
    type Error;

    /// Which of both sides of a comparison is larger.
    fn order(&self, comparison: &Expr, left: &Expr, right: &Expr) -> Result<Ordering, Self::Error>;

    /// Why an expression is no condition.
    fn no_condition(&self, expression: &Expr) -> Self::Error;

    /// Whether the condition is true.
    fn holds(&self, condition: &Expr) -> Result<bool, Self::Error> {
        match &condition.kind {
            ExprKind::Symbol(name) if name == "true" => Ok(true),
            ExprKind::Symbol(name) if name == "false" => Ok(false),
            ExprKind::Unary { operator: UnaryOperator::Not, operand } => Ok(!self.holds(operand)?),
            ExprKind::Binary { operator: BinaryOperator::And, left, right } => {
                Ok(self.holds(left)? && self.holds(right)?)
            }
            ExprKind::Binary { operator: BinaryOperator::Or, left, right } => {
                Ok(self.holds(left)? || self.holds(right)?)
            }
            ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
                Ok(relation.holds(self.order(condition, left, right)?))
            }
            _ => Err(self.no_condition(condition)),
        }
    }

    /// The side of an `if` that is taken, if one is.
    fn side<'e>(&self, branches: &'e [Branch], otherwise: Option<&'e Expr>) -> Result<Option<&'e Expr>, Self::Error> {
        for branch in branches {
            if self.holds(&branch.condition)? {
                return Ok(Some(&branch.value));
            }
        }
        Ok(otherwise)
    }
}
