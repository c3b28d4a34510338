//! Rule `double-double`: where compensated expressions leave too many roundings, every step is taken in double-double.

use super::Pass;
use crate::stable::candidate::Candidate;
use crate::stable::rule::Rule;
use closedform_syntax::Precision;

/// The rule.
pub const RULE: Rule = Rule {
    name: "double-double",
    statement: "every step is taken in double-double, and only results are rounded",
    condition: "a result would be off by more than 5 ulp otherwise, or 2 where few roundings are asked for; no root is iterated",
};

/// A bound that is small enough, in units of 2^-53; and where few roundings are asked for.
const ENOUGH: f64 = 5.0;
const FEW: f64 = 2.0;

/// Whether a candidate has too many roundings in `f64`.
#[must_use]
pub fn is_worth_it(candidate: &Candidate, few_roundings: bool) -> bool {
    candidate.worst_error() > if few_roundings { FEW } else { ENOUGH }
}

/// Takes every step in double-double, where that bounds the errors of all results.
pub struct DoubleDouble;

impl Pass for DoubleDouble {
    fn apply(&self, candidate: &Candidate) -> Option<Candidate> {
        let mut made = Candidate { precision: Precision::DoubleDouble, ..candidate.clone() };
        if !made.worst_error().is_finite() {
            return None;
        }
        made.outputs.iter().for_each(|&output| made.graph.mark(output, RULE.name));
        Some(made)
    }
}
