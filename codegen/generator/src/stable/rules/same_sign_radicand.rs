//! Rule `same-sign-radicand`: a radicand that may cancel becomes a sum that does not.

use super::Rule;
use crate::algebra::Polynomial;
use crate::field::{Radical, Sign, TowerError, parts};
use crate::stable::builder::{Builder, Quotient};
use num_traits::Signed;

/// The rule.
pub const RULE: Rule = Rule {
    name: "same-sign-radicand",
    statement: "r = a^2 - n for a sum a + sqrt(r) of norm n = a^2 - r",
    condition: "n is never positive, so that a^2 and -n do not cancel",
};

/// Lets the radical stand for `sqrt(a^2 + (-n))` where its radicand has no plain form but that one.
///
/// # Errors
/// When the tower has no room left.
pub fn prepare(builder: &mut Builder, sum: &Polynomial, radical: &Radical) -> Result<(), TowerError> {
    if builder.tower.top_radical(&radical.radicand).is_some() || builder.has_stand_in(radical.var) {
        return Ok(());
    }
    let (rational, surd) = parts(sum, radical.var);
    let unit = surd.as_constant().is_some_and(|c| c.abs() == num_traits::One::one());
    let norm = builder.tower.norm(sum, radical);
    let agrees = builder.tower.sign_of(&norm).is(Sign::NONPOSITIVE);
    if !unit || !agrees || builder.plain(&radical.radicand)?.is_some() {
        return Ok(());
    }
    let a = builder.surd(&rational, Quotient::one())?;
    let square = builder.graph.mul(a, a);
    let square = builder.graph.with_error(square, Sign::NONNEGATIVE, 2.0 * builder.graph.error(a) + 1.0);
    let rest = builder.surd(&norm.negated(), Quotient::one())?;
    let inside = builder.graph.add(square, rest);
    let root = builder.graph.sqrt(inside);
    builder.apply(&RULE, inside);
    builder.stand_for(radical.var, root);
    Ok(())
}
