//! Branches: always the one, always the other, each where the other belongs.

use closedform_syntax::{Condition, Expr};

/// What may stand for a choice; its condition has mutations of its own.
pub fn mutations(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::If { condition, then, otherwise } => vec![
            (**then).clone(),
            (**otherwise).clone(),
            choice((**condition).clone(), (**otherwise).clone(), (**then).clone()),
        ],
        _ => Vec::new(),
    }
}

/// `if condition { then } else { otherwise }`
pub fn choice(condition: Condition, then: Expr, otherwise: Expr) -> Expr {
    Expr::If { condition: condition.into(), then: then.into(), otherwise: otherwise.into() }
}
