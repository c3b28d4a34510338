//! Slices: evaluated plainly.

use closedform_syntax::Expr;

/// What may stand for a slice; its digits are lost.
pub fn mutations(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Compensated(slice) => vec![(*slice.value).clone()],
        Expr::Residual(inner) => vec![(**inner).clone()],
        _ => Vec::new(),
    }
}
