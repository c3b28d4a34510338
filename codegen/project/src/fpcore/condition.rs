//! Preconditions as parts that all hold.

use closedform_maxima::{BinaryOperator, Expr, ExprKind};

use super::expression::expression;
use super::mistake::CoreMistake;
use super::read::Node;
use super::scope::Scope;

/// The parts of a precondition, all of which hold; none of one that always does.
pub(super) fn conditions(node: &Node, scope: &mut Scope<'_>) -> Result<Vec<Expr>, CoreMistake> {
    let mut parts = Vec::new();
    split(expression(node, scope)?.expr, &mut parts);
    parts.retain(|part| part.as_symbol() != Some("true"));
    Ok(parts)
}

fn split(condition: Expr, parts: &mut Vec<Expr>) {
    match condition.kind {
        ExprKind::Binary { operator: BinaryOperator::And, left, right } => {
            split(*left, parts);
            split(*right, parts);
        }
        _ => parts.push(condition),
    }
}
