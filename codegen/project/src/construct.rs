//! Maxima expressions made of others, without the way over their text.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};

/// The most nodes that a formula may have when everything that it names is put in.
pub(crate) const SIZE_LIMIT: usize = 100_000;

pub(crate) fn integer(value: i32) -> Expr {
    ExprKind::Integer(value.into()).into()
}

pub(crate) fn negative(expr: Expr) -> Expr {
    let span = expr.span.clone();
    Expr::new(ExprKind::Unary { operator: UnaryOperator::Minus, operand: Box::new(expr) }, span)
}

/// Two operands joined; errors point at the first one.
pub(crate) fn binary(operator: BinaryOperator, left: Expr, right: Expr) -> Expr {
    let span = left.span.clone();
    Expr::new(ExprKind::Binary { operator, left: Box::new(left), right: Box::new(right) }, span)
}

pub(crate) fn compared(relation: Relation, left: Expr, right: Expr) -> Expr {
    binary(BinaryOperator::Compare(relation), left, right)
}

pub(crate) fn squared(expr: Expr) -> Expr {
    binary(BinaryOperator::Power, expr, integer(2))
}

/// The product of all factors; none of no factors.
pub(crate) fn product(factors: impl IntoIterator<Item = Expr>) -> Option<Expr> {
    factors.into_iter().reduce(|product, factor| binary(BinaryOperator::Multiply, product, factor))
}

/// The operands of `or` or `and`, joined; none of no operands.
pub(crate) fn joined(operator: BinaryOperator, parts: impl IntoIterator<Item = Expr>) -> Option<Expr> {
    parts.into_iter().reduce(|all, part| binary(operator, all, part))
}
