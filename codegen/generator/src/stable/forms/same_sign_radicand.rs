//! Rule `same-sign-radicand`: a radicand that may cancel becomes a sum that does not.

use super::plain;
use crate::field::{Sign, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use closedform_syntax::Function;
use num_traits::{One, Signed};

/// The rule.
pub const RULE: Rule = Rule {
    name: "same-sign-radicand",
    statement: "r = a^2 - n for a sum a + sqrt(r) of norm n = a^2 - r",
    condition: "n is never positive, so that a^2 and -n do not cancel",
};

/// The sum with `sqrt(a^2 + (-n))` for its root, where the radicand has no plain form but that one.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let Surd { sum, radical, .. } = surd;
    if builder.tower.top_radical(&radical.radicand).is_some() || builder.has_stand_in(radical.var) {
        return Ok(None);
    }
    let (rational, irrational) = surd.parts();
    let unit = irrational.as_constant().is_some_and(|c| c.abs().is_one());
    let norm = builder.tower.norm(sum, radical);
    let agrees = builder.tower.sign_of(&norm).is(Sign::NONPOSITIVE);
    if !unit || !agrees || plain::steps(builder, &radical.radicand)?.is_some() {
        return Ok(None);
    }
    let a = builder.value(&rational)?;
    let square = builder.graph.mul(a, a);
    builder.graph.learn(square, Sign::NONNEGATIVE);
    let rest = builder.value(&norm.negated())?;
    let inside = builder.graph.add(square, rest);
    let root = builder.graph.call(Function::Sqrt, inside);
    builder.mark(&RULE, inside);
    builder.stand_for(radical.var, root);
    builder.surd(surd).map(Some)
}
