//! Branches: always the one, always the other, each where the other belongs.

use closedform_syntax::{Condition, Expr};

use crate::mistake::Wrong;

/// What may stand for a choice; its condition has mutations of its own.
pub fn mutations(expr: &Expr) -> Vec<Wrong<Expr>> {
    match expr {
        Expr::If { condition, then, otherwise } => vec![
            Wrong::new("first branch alone", (**then).clone()),
            Wrong::new("second branch alone", (**otherwise).clone()),
            Wrong::new("branches swapped", choice((**condition).clone(), (**otherwise).clone(), (**then).clone())),
        ],
        _ => Vec::new(),
    }
}

/// `if condition { then } else { otherwise }`
pub fn choice(condition: Condition, then: Expr, otherwise: Expr) -> Expr {
    Expr::If { condition: condition.into(), then: then.into(), otherwise: otherwise.into() }
}
