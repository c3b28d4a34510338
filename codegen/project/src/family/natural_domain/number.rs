//! Expressions of numbers alone, and those in which an input occurs.

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

/// Whether an input occurs in an expression.
pub(super) fn has_input(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Symbol(name) => !name.starts_with('%'),
        ExprKind::Unary { operand, .. } => has_input(operand),
        ExprKind::Binary { left, right, .. } => has_input(left) || has_input(right),
        ExprKind::Call { arguments, .. } => arguments.iter().any(has_input),
        ExprKind::If { branches, otherwise } => {
            let sides =
                branches.iter().flat_map(|branch| [&branch.condition, &branch.value]).chain(otherwise.as_deref());
            sides.into_iter().any(has_input)
        }
        _ => false,
    }
}
