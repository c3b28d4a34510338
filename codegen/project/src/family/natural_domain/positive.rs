//! What is positive wherever it has a value, whatever its inputs are.

use closedform_maxima::{BinaryOperator, Expr, ExprKind};
use num_traits::Signed;

use super::number::{has_input, number};

/// Whether the form alone tells that an expression is positive.
pub(super) fn is_positive(expr: &Expr) -> bool {
    if let Some(number) = number(expr) {
        return number.is_positive();
    }
    match &expr.kind {
        ExprKind::Symbol(name) => name == "%pi" || name == "%e",
        ExprKind::Binary { operator, left, right } => match operator {
            BinaryOperator::Add => {
                (is_positive(left) && is_not_negative(right)) || (is_not_negative(left) && is_positive(right))
            }
            BinaryOperator::Multiply | BinaryOperator::Divide => is_positive(left) && is_positive(right),
            BinaryOperator::Power => is_positive(left),
            _ => false,
        },
        _ => match expr.as_call() {
            Some(("exp" | "cosh", _)) => true,
            Some(("sqrt", [radicand])) => is_positive(radicand),
            _ => false,
        },
    }
}

/// The same of what is not negative.
fn is_not_negative(expr: &Expr) -> bool {
    if is_positive(expr) || number(expr).is_some_and(|number| !number.is_negative()) {
        return true;
    }
    match &expr.kind {
        ExprKind::Binary { operator, left, right } => match operator {
            BinaryOperator::Add | BinaryOperator::Multiply | BinaryOperator::Divide => {
                is_not_negative(left) && is_not_negative(right)
            }
            BinaryOperator::Power => {
                let is_even = number(right).is_some_and(|power| power.is_integer() && !power.numer().bit(0));
                is_even || is_not_negative(left)
            }
            _ => false,
        },
        _ => matches!(expr.as_call(), Some(("sqrt" | "abs", _))),
    }
}

/// What has the sign of an expression without its positive factors that no input occurs in.
pub(super) fn without_positive_constants(expr: &Expr) -> &Expr {
    let is_constant = |factor: &Expr| !has_input(factor) && is_positive(factor);
    match &expr.kind {
        ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } if is_constant(left) => {
            without_positive_constants(right)
        }
        ExprKind::Binary { operator: BinaryOperator::Multiply | BinaryOperator::Divide, left, right }
            if is_constant(right) =>
        {
            without_positive_constants(left)
        }
        _ => expr,
    }
}
