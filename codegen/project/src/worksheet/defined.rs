//! The names that a statement defines by itself.

use closedform_maxima::{BinaryOperator, Expr, ExprKind};

/// How a name is defined.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    Function,
    Variable,
}

/// The names that a statement defines by itself.
pub(super) fn definitions(statement: &Expr) -> Vec<(String, Kind)> {
    match &statement.kind {
        ExprKind::Binary { operator: BinaryOperator::Define | BinaryOperator::DefineMacro, left, .. } => head(left),
        ExprKind::Binary { operator: BinaryOperator::Assign, left, right } => {
            let mut found = targets(left);
            found.extend(definitions(right));
            found
        }
        ExprKind::Call { .. } => match statement.as_call() {
            Some(("define", [function, _])) => head(function),
            _ => Vec::new(),
        },
        ExprKind::Sequence(items) => items.iter().flat_map(definitions).collect(),
        ExprKind::Ev { expression, .. } => definitions(expression),
        _ => Vec::new(),
    }
}

fn head(head: &Expr) -> Vec<(String, Kind)> {
    head.as_call().map(|(name, _)| (name.to_owned(), Kind::Function)).into_iter().collect()
}

fn targets(target: &Expr) -> Vec<(String, Kind)> {
    match &target.kind {
        ExprKind::Symbol(name) => vec![(name.clone(), Kind::Variable)],
        ExprKind::List(items) => items.iter().flat_map(targets).collect(),
        _ => Vec::new(),
    }
}
