//! Conditions: other comparisons, sides swapped, parts dropped, joined otherwise, negated.

use closedform_syntax::{Condition, Expr, Relation};
use proc_macro2::Span;

use super::walk::{Place, Walk};
use crate::mistake::Wrong;

/// What may stand for what a `require!` demands; nothing demanded is among it.
pub fn required(condition: &Condition, walk: &Walk) -> Vec<Wrong<Condition>> {
    let mut found = mutations(condition, walk);
    found.push(Wrong::new("condition dropped", always()));
    found
}

/// What may stand for a condition.
pub fn mutations(condition: &Condition, walk: &Walk) -> Vec<Wrong<Condition>> {
    let mut found = match condition {
        Condition::Compare { op, left, right } => compared(*op, left, right, walk),
        Condition::Not(inner) => {
            let inside = mutations(inner, walk).into_iter();
            let inside = inside.map(|wrong| wrong.map(|inner| Condition::Not(inner.into())));
            inside.chain([Wrong::new("not dropped", (**inner).clone())]).collect()
        }
        Condition::And(left, right) => joined([left, right], "&& as ||", [Condition::And, Condition::Or], walk),
        Condition::Or(left, right) => joined([left, right], "|| as &&", [Condition::Or, Condition::And], walk),
    };
    found.push(Wrong::new("condition negated", Condition::Not(condition.clone().into())));
    found
}

/// A condition that always holds: with it the others keep their positions.
fn always() -> Condition {
    let zero = || Expr::Literal { value: 0.0, span: Span::call_site() };
    Condition::Compare { op: Relation::Equal, left: zero(), right: zero() }
}

fn compared(op: Relation, left: &Expr, right: &Expr, walk: &Walk) -> Vec<Wrong<Condition>> {
    let compare = |op, left: &Expr, right: &Expr| Condition::Compare { op, left: left.clone(), right: right.clone() };
    let others = Relation::ALL.into_iter().filter(|other| *other != op);
    let mut found: Vec<Wrong<Condition>> = others
        .map(|other| Wrong::new(format!("{} as {}", op.rust(), other.rust()), compare(other, left, right)))
        .collect();
    found.push(Wrong::new("compared sides swapped", compare(op, right, left)));
    let lefts = walk.expression(left, Place::Side).into_iter();
    found.extend(lefts.map(|wrong| wrong.map(|left| compare(op, &left, right))));
    let rights = walk.expression(right, Place::Side).into_iter();
    found.extend(rights.map(|wrong| wrong.map(|right| compare(op, left, &right))));
    found
}

type Join = fn(Box<Condition>, Box<Condition>) -> Condition;

fn joined(parts: [&Condition; 2], exchanged: &str, joins: [Join; 2], walk: &Walk) -> Vec<Wrong<Condition>> {
    let ([left, right], [join, other]) = (parts, joins);
    let lefts = mutations(left, walk).into_iter();
    let mut found: Vec<Wrong<Condition>> =
        lefts.map(|wrong| wrong.map(|left| join(left.into(), right.clone().into()))).collect();
    let rights = mutations(right, walk).into_iter();
    found.extend(rights.map(|wrong| wrong.map(|right| join(left.clone().into(), right.into()))));
    found.extend([
        Wrong::new("first part alone", left.clone()),
        Wrong::new("second part alone", right.clone()),
        Wrong::new(exchanged, other(left.clone().into(), right.clone().into())),
    ]);
    found
}
