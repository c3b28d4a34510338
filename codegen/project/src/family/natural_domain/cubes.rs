//! Sums of two terms with cube roots, whose sign is that of the sum of their cubes.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, parse_expression, print};

use num_bigint::BigInt;
use num_traits::One;

use super::number::number;
use super::surds::has_root;

/// The rational function that has the sign of the expression, if that is such a sum.
///
/// A larger number has a larger cube: s + t compares with zero as s does with -t, and as s^3 does with -t^3.
pub(super) fn decide(expr: &Expr) -> Option<Expr> {
    let ExprKind::Binary { operator, left, right } = &expr.kind else { return None };
    let sign = match operator {
        BinaryOperator::Add => '+',
        BinaryOperator::Subtract => '-',
        _ => return None,
    };
    let text = format!("{}{sign}{}", cube(left)?, cube(right)?);
    if has_root(expr) { parse_expression(&text).ok() } else { None }
}

/// The cube of a product of rational functions and cube roots of such.
fn cube(term: &Expr) -> Option<String> {
    match &term.kind {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(format!("(-{})", cube(operand)?)),
        ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } => {
            Some(format!("{}*{}", cube(left)?, cube(right)?))
        }
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right } if has_root(term) => {
            Some(format!("{}/({})", cube(left)?, cube(right)?))
        }
        ExprKind::Binary { operator: BinaryOperator::Power, left, right } if !has_root(left) => {
            let thirds = number(right)? * BigInt::from(3);
            let power = if thirds.is_one() { String::new() } else { format!("^({thirds})") };
            thirds.is_integer().then(|| format!("({}){power}", print(left)))
        }
        _ => (!has_root(term)).then(|| format!("({})^3", print(term))),
    }
}
