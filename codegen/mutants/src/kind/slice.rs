//! Slices: evaluated plainly, or in double-double alone.

use closedform_syntax::Expr;

use super::walk::Place;

/// What may stand for a slice; its digits are lost, or nothing proves them. The language has no `residual!` that decides.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Expr> {
    match expr {
        Expr::Compensated(slice) if place == Place::Side => vec![(*slice.value).clone()],
        Expr::Compensated(slice) => vec![(*slice.value).clone(), Expr::Residual(slice.value.clone())],
        Expr::Residual(inner) => vec![(**inner).clone()],
        _ => Vec::new(),
    }
}
