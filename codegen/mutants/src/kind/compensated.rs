//! Compensated expressions: evaluated plainly, or in double-double alone.

use closedform_syntax::Expr;

use super::walk::Place;
use crate::mistake::Wrong;

/// What may stand for a compensated expression; its digits are lost, or nothing proves them. The language has no
/// `residual!` that decides.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
    match expr {
        Expr::Compensated(expression) => {
            let mut found = vec![Wrong::new("compensated! dropped", (*expression.value).clone())];
            if place != Place::Side {
                found.push(Wrong::new("compensated! as residual!", Expr::Residual(expression.value.clone())));
            }
            found
        }
        Expr::Residual(inner) => vec![Wrong::new("residual! dropped", (**inner).clone())],
        _ => Vec::new(),
    }
}
