//! Slices: evaluated plainly, or in double-double alone.

use closedform_syntax::Expr;

use super::walk::Place;
use crate::mistake::Wrong;

/// What may stand for a slice; its digits are lost, or nothing proves them. The language has no `residual!` that decides.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
    match expr {
        Expr::Compensated(slice) => {
            let mut found = vec![Wrong::new("compensated! dropped", (*slice.value).clone())];
            if place != Place::Side {
                found.push(Wrong::new("compensated! as residual!", Expr::Residual(slice.value.clone())));
            }
            found
        }
        Expr::Residual(inner) => vec![Wrong::new("residual! dropped", (**inner).clone())],
        _ => Vec::new(),
    }
}
