//! Functions: roots dropped, turned and added, magnitudes dropped, the smallest for the largest, coefficients of a root's
//! polynomial left out.

use closedform_syntax::Expr;

use super::coefficient::literal;
use super::operator::negated;
use super::walk::Place;

/// What may stand for a function, and a function for a name.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Expr> {
    match expr {
        Expr::Sqrt(inner) => vec![(**inner).clone(), negated(expr)],
        Expr::Abs(inner) => vec![(**inner).clone(), negated(expr)],
        Expr::Name(_) if place == Place::Plain => vec![Expr::Sqrt(expr.clone().into())],
        Expr::Extreme { largest, items } => extremes(*largest, items),
        Expr::PositiveRoot(coefficients) => left_out(coefficients),
        _ => Vec::new(),
    }
}

/// The other extreme, each item alone, and the extreme without one.
fn extremes(largest: bool, items: &[Expr]) -> Vec<Expr> {
    let mut found = vec![Expr::Extreme { largest: !largest, items: items.to_vec() }];
    found.extend(items.iter().cloned());
    for at in (0..items.len()).filter(|_| items.len() > 2) {
        let mut items = items.to_vec();
        items.remove(at);
        found.push(Expr::Extreme { largest, items });
    }
    found
}

/// The polynomial with one coefficient zero, of one degree less, and backwards.
fn left_out(coefficients: &[Expr]) -> Vec<Expr> {
    let mut found: Vec<Vec<Expr>> = Vec::new();
    for at in 0..coefficients.len() {
        let mut without = coefficients.to_vec();
        without[at] = literal(0.0, &without[at]);
        found.push(without);
    }
    found.push(coefficients.iter().skip(1).cloned().collect());
    found.push(coefficients.iter().rev().cloned().collect());
    found.into_iter().map(Expr::PositiveRoot).collect()
}
