//! Rule `cube-conjugate`: a sum of two terms with cube roots that cancels becomes a quotient that does not.

use super::cubic::{self, Term};
use crate::field::{Sign, TowerError};
use crate::program::{Node, Op};
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use num_rational::BigRational;
use num_traits::Zero;

/// The rule.
pub const RULE: Rule = Rule {
    name: "cube-conjugate",
    statement: "a + b = (a^3 + b^3)/(a*(a - b) + b^2), where a or b has a cube root and a^3 + b^3 has none of it",
    condition: "a and b are of opposite signs, and not both 0, so that a*(a - b) + b^2 does not cancel or vanish",
};

/// The sum in the form that does not cancel, if it has two terms, which are of opposite signs.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let signs: Vec<Sign> = surd.cubic_terms().iter().map(|term| builder.tower.sign_of(term)).collect();
    let [left, right] = signs[..] else { return Ok(None) };
    let difference = left.plus(-right);
    // a sum of signs that cannot be 0 is of one sign
    if !difference.is(Sign::NONZERO) {
        return Ok(None);
    }
    let [a, b] = cubic::terms(builder, surd)?[..] else { return Ok(None) };
    let node = rationalised(builder, surd, [a, b])?;
    builder.mark(&RULE, node);
    Ok(Some(node))
}

/// The sum of two terms as the sum of their cubes over what is left, where they are of opposite signs.
///
/// # Errors
/// When the tower has no room left.
pub fn rationalised(builder: &mut Builder, surd: &Surd, [a, b]: [Term; 2]) -> Result<Node, TowerError> {
    let cubes = surd.cubic_terms().iter().map(|term| term.power(3)).reduce(|sum, cube| sum.plus(&cube));
    let cubes = builder.tower.reduce(&cubes.unwrap_or_else(|| builder.tower.ring().integer(0)));
    if cubes.is_zero() {
        // a = -b, since a number has one real cube root
        return Ok(builder.graph.constant(&BigRational::zero()));
    }
    let graph = &mut builder.graph;
    // what stands below the bar is the same of -a and -b
    let (a, b) = if matches!(graph.op(a.node), Op::Neg(_)) { (a.negated(graph), b.negated(graph)) } else { (a, b) };
    let turned = graph.neg(b.node);
    let difference = graph.add_of_one_sign(a.node, turned, a.sign.plus(-b.sign));
    let product = graph.mul(a.node, difference);
    let product = graph.with_error(product, Sign::NONNEGATIVE, graph.error(product));
    let square = graph.mul(b.node, b.node);
    let square = graph.with_error(square, Sign::NONNEGATIVE, graph.error(square));
    let below = graph.add_of_one_sign(product, square, Sign::POSITIVE);
    let mut quotient = surd.quotient.clone();
    quotient.multiply_node(below, -1);
    builder.product(&cubes, quotient)
}
