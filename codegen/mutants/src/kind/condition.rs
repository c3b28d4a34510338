//! Conditions: other comparisons, sides swapped, parts dropped, joined otherwise, negated.

use closedform_syntax::{Comparison, Condition, Expr};
use proc_macro2::Span;

use super::walk::{Place, Walk};

/// Every comparison operator.
const ALL: [Comparison; 6] = [
    Comparison::Less,
    Comparison::LessEqual,
    Comparison::Greater,
    Comparison::GreaterEqual,
    Comparison::Equal,
    Comparison::NotEqual,
];

/// What may stand for what a `require!` demands; nothing demanded is among it.
pub fn required(condition: &Condition, walk: &Walk) -> Vec<Condition> {
    let mut found = mutations(condition, walk);
    found.push(always());
    found
}

/// What may stand for a condition.
pub fn mutations(condition: &Condition, walk: &Walk) -> Vec<Condition> {
    let mut found = match condition {
        Condition::Compare { op, left, right } => compared(*op, left, right, walk),
        Condition::Not(inner) => {
            let inside = mutations(inner, walk).into_iter().map(|inner| Condition::Not(inner.into()));
            inside.chain([(**inner).clone()]).collect()
        }
        Condition::And(left, right) => joined(left, right, Condition::And, Condition::Or, walk),
        Condition::Or(left, right) => joined(left, right, Condition::Or, Condition::And, walk),
    };
    found.push(Condition::Not(condition.clone().into()));
    found
}

/// A condition that always holds: with it the others keep their positions.
fn always() -> Condition {
    let zero = || Expr::Literal { value: 0.0, span: Span::call_site() };
    Condition::Compare { op: Comparison::Equal, left: zero(), right: zero() }
}

fn compared(op: Comparison, left: &Expr, right: &Expr, walk: &Walk) -> Vec<Condition> {
    let compare = |op, left: &Expr, right: &Expr| Condition::Compare { op, left: left.clone(), right: right.clone() };
    let mut found: Vec<Condition> =
        ALL.into_iter().filter(|other| *other != op).map(|other| compare(other, left, right)).collect();
    found.push(compare(op, right, left));
    found.extend(walk.expression(left, Place::Side).iter().map(|left| compare(op, left, right)));
    found.extend(walk.expression(right, Place::Side).iter().map(|right| compare(op, left, right)));
    found
}

type Join = fn(Box<Condition>, Box<Condition>) -> Condition;

fn joined(left: &Condition, right: &Condition, join: Join, other: Join, walk: &Walk) -> Vec<Condition> {
    let (own, kept) = (|left: Condition| join(left.into(), right.clone().into()), left.clone());
    let mut found: Vec<Condition> = mutations(left, walk).into_iter().map(own).collect();
    found.extend(mutations(right, walk).into_iter().map(|right| join(kept.clone().into(), right.into())));
    found.extend([left.clone(), right.clone(), other(left.clone().into(), right.clone().into())]);
    found
}
