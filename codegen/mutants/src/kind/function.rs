//! Functions: dropped, turned, added and taken for each other, the smallest for the largest, coefficients of a root's
//! polynomial left out.

use closedform_syntax::{Expr, Function};

use super::coefficient::literal;
use super::operator::negated;
use super::walk::Place;
use crate::mistake::Wrong;

/// What may stand for a function, and a function for a name.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
    match expr {
        Expr::Call(function, inner) => calls(expr, *function, inner),
        Expr::Name(_) if place == Place::Plain => {
            vec![Wrong::new("name as its root", root(expr))]
        }
        Expr::Extreme { largest, items } => extremes(*largest, items),
        Expr::PositiveRoot(coefficients) => left_out(coefficients),
        _ => Vec::new(),
    }
}

/// The square root of a value.
pub fn root(value: &Expr) -> Expr {
    Expr::Call(Function::Sqrt, value.clone().into())
}

/// The argument alone, the negative value, and every other function of its kind, a power, one with steps or neither, of the
/// argument.
fn calls(call: &Expr, function: Function, argument: &Expr) -> Vec<Wrong<Expr>> {
    let what = if function.degree().is_some() { "root" } else { function.properties().noun };
    let mut found = vec![
        Wrong::new(format!("{what} dropped"), argument.clone()),
        Wrong::new(format!("{what} negated"), negated(call)),
    ];
    let kind = |function: Function| (function.is_power(), function.has_steps());
    let others = Function::ALL.into_iter().filter(|other| *other != function && kind(*other) == kind(function));
    found.extend(others.map(|other| {
        let kind = format!("{} as {}", function.name(), other.name());
        Wrong::new(kind, Expr::Call(other, argument.clone().into()))
    }));
    found
}

/// The other extreme, each item alone, and the extreme without one.
fn extremes(largest: bool, items: &[Expr]) -> Vec<Wrong<Expr>> {
    let other = if largest { "max as min" } else { "min as max" };
    let mut found = vec![Wrong::new(other, Expr::Extreme { largest: !largest, items: items.to_vec() })];
    found.extend(items.iter().map(|item| Wrong::new("item alone", item.clone())));
    for at in (0..items.len()).filter(|_| items.len() > 2) {
        let mut items = items.to_vec();
        items.remove(at);
        found.push(Wrong::new("item left out", Expr::Extreme { largest, items }));
    }
    found
}

/// The polynomial with one coefficient zero, of one degree less, and backwards.
fn left_out(coefficients: &[Expr]) -> Vec<Wrong<Expr>> {
    let mut found: Vec<Wrong<Vec<Expr>>> = Vec::new();
    for at in 0..coefficients.len() {
        let mut without = coefficients.to_vec();
        without[at] = literal(0.0, &without[at]);
        found.push(Wrong::new("coefficient as 0", without));
    }
    found.push(Wrong::new("degree lowered", coefficients.iter().skip(1).cloned().collect()));
    found.push(Wrong::new("coefficients reversed", coefficients.iter().rev().cloned().collect()));
    found.into_iter().map(|wrong| wrong.map(Expr::PositiveRoot)).collect()
}
