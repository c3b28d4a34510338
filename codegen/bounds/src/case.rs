//! Cases: what holds where a value is computed, from the domain's conditions and those of branches.

use crate::count::{Count, Effort};
use crate::polynomial::{Atom, Polynomial};
use crate::sign::{Facts, Sign};
use closedform_syntax::Condition;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};

/// How many cases conditions with `or` are split into, at most; beyond, what they say is left out.
pub const CASES: usize = 64;

/// The facts of a case, and what has been counted in it so far.
#[derive(Default)]
pub struct Case {
    /// What holds.
    pub facts: RefCell<Facts>,
    /// The counts of steps, by slot.
    pub counts: RefCell<HashMap<usize, Count>>,
    /// The signs of polynomials, and how long they were searched for.
    pub signs: RefCell<HashMap<Polynomial, (Sign, Effort)>>,
    /// The atoms of which the facts know what their meaning tells.
    pub learnt: RefCell<BTreeSet<Atom>>,
}

/// A fact: a polynomial and its sign.
pub type Fact = (Polynomial, Sign);

impl Case {
    /// The cases of this one in which one list of facts each holds.
    pub fn split(&self, alternatives: &[Vec<Fact>]) -> Vec<Self> {
        let with = |facts: &Vec<Fact>| {
            let mut known = self.facts.borrow().clone();
            facts.iter().for_each(|(polynomial, sign)| known.learn(polynomial, *sign));
            known.settle();
            (!known.is_impossible()).then(|| Self { facts: RefCell::new(known), ..Self::default() })
        };
        alternatives.iter().filter_map(with).collect()
    }
}

/// What holds where a condition does, or where it does not: one of these lists. `compare` tells what a comparison
/// says, if it is one whose result rounding cannot turn.
pub fn alternatives<'k>(
    condition: &'k Condition,
    holds: bool,
    compare: &dyn Fn(&'k Condition) -> Option<Polynomial>,
) -> Vec<Vec<Fact>> {
    let part = |inner: &'k Condition| alternatives(inner, holds, compare);
    match (condition, holds) {
        (Condition::Not(inner), _) => alternatives(inner, !holds, compare),
        (Condition::And(a, b), true) | (Condition::Or(a, b), false) => both(&part(a), &part(b)),
        (Condition::And(a, b), false) | (Condition::Or(a, b), true) => either(part(a), part(b)),
        (Condition::Compare { op, .. }, _) => {
            let sign = Sign::of_relation(if holds { *op } else { op.negated() });
            vec![compare(condition).map(|difference| (difference, sign)).into_iter().collect()]
        }
    }
}

fn both(a: &[Vec<Fact>], b: &[Vec<Fact>]) -> Vec<Vec<Fact>> {
    if a.len() * b.len() > CASES {
        return vec![Vec::new()];
    }
    a.iter().flat_map(|one| b.iter().map(move |other| [&one[..], &other[..]].concat())).collect()
}

fn either(a: Vec<Vec<Fact>>, b: Vec<Vec<Fact>>) -> Vec<Vec<Fact>> {
    let all = [a, b].concat();
    if all.len() > CASES { vec![Vec::new()] } else { all }
}
