//! Rule `conjugate`: a sum with a square root that cancels becomes a quotient that does not.

use super::sum;
use crate::field::{Sign, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use num_rational::BigRational;
use num_traits::Zero;

/// The rule.
pub const RULE: Rule = Rule {
    name: "conjugate",
    statement: "a + b*sqrt(r) = (a^2 - b^2*r)/(a - b*sqrt(r))",
    condition: "a and b*sqrt(r) are of opposite signs, and not both 0, so that a - b*sqrt(r) does not cancel or vanish",
};

/// The sum in the form that does not cancel, if its terms are of opposite signs.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let [left, right] = surd.signs(&builder.tower);
    let below = left.plus(-right);
    // a sum of signs that cannot be 0 is of one sign
    if !below.is(Sign::NONZERO) {
        return Ok(None);
    }
    let node = rationalised(builder, surd, below)?;
    builder.mark(&RULE, node);
    Ok(Some(node))
}

/// The sum as its norm over its conjugate, both of whose terms have the given sign.
///
/// # Errors
/// When the tower has no room left.
pub fn rationalised(builder: &mut Builder, surd: &Surd, sign: Sign) -> Result<Node, TowerError> {
    let Surd { sum, radical, .. } = surd;
    let norm = builder.tower.norm(sum, radical);
    if norm.is_zero() {
        // a = -b*sqrt(r) wherever the two are of opposite signs
        return Ok(builder.graph.constant(&BigRational::zero()));
    }
    let mut quotient = surd.quotient.clone();
    let (mut below, mut sign) = (builder.tower.conjugate(sum, radical), sign);
    if sign.is(Sign::NONPOSITIVE) {
        quotient.constant = -quotient.constant;
        (below, sign) = (below.negated(), -sign);
    }
    let node = sum::of_one_sign(builder, &below, radical, sign)?;
    quotient.multiply_node(node, -1);
    builder.product(&norm, quotient)
}
