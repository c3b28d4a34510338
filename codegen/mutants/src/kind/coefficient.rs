//! Coefficients: scaled, moved by one, replaced, and changed in the last digits.

use std::f64::consts::PI;

use closedform_syntax::Expr;
use proc_macro2::Span;

use crate::mistake::Wrong;

/// A relative change far above every bound, and far below what is seen without looking for it.
const SMALL: f64 = 1.0 / (1_u64 << 40) as f64;

/// What may stand for a number.
pub fn mutations(expr: &Expr) -> Vec<Wrong<Expr>> {
    let (value, span) = match expr {
        Expr::Literal { value, span } => (*value, *span),
        Expr::Pi(span) => (PI, *span),
        _ => return Vec::new(),
    };
    let others = [
        ("number doubled", value * 2.0),
        ("number halved", value / 2.0),
        ("number plus 1", value + 1.0),
        ("number minus 1", value - 1.0),
        ("number as 0", 0.0),
        ("number as 1", 1.0),
        ("number negated", -value),
        ("number off in its last digits", value + value * SMALL),
    ];
    let others = others.into_iter().filter(|(_, other)| *other != value);
    others.map(|(kind, other)| Wrong::new(kind, number(other, span))).collect()
}

/// A number that stands beside `neighbour`.
pub fn literal(value: f64, neighbour: &Expr) -> Expr {
    match neighbour {
        Expr::Literal { span, .. } => number(value, *span),
        _ => number(value, Span::call_site()),
    }
}

/// A number as the parser reads it: literals have no sign.
fn number(value: f64, span: Span) -> Expr {
    let magnitude = Expr::Literal { value: value.abs(), span };
    if value < 0.0 { Expr::Neg(magnitude.into()) } else { magnitude }
}
