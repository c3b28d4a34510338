//! Expressions of numbers alone.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, exact};
use num_rational::BigRational;
use num_traits::Zero;

/// The value of an expression of numbers alone.
pub(super) fn number(expr: &Expr) -> Option<BigRational> {
    match &expr.kind {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(-number(operand)?),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => number(operand),
        ExprKind::Binary { operator, left, right } => {
            let (left, right) = (number(left)?, number(right)?);
            match operator {
                BinaryOperator::Add => Some(left + right),
                BinaryOperator::Subtract => Some(left - right),
                BinaryOperator::Multiply => Some(left * right),
                BinaryOperator::Divide => (!right.is_zero()).then(|| left / right),
                _ => None,
            }
        }
        _ => exact::rational(expr).ok(),
    }
}
