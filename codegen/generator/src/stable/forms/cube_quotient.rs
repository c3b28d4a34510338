//! Rule `cube-quotient`: a sum of squares and a product of cube roots, which cancels in part, becomes a quotient.

use super::cubic::{self, Term};
use super::merge_cubes;
use super::sign_branch::agreement;
use crate::algebra::Polynomial;
use crate::field::{Sign, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use num_traits::Signed;

/// The rule.
pub const RULE: Rule = Rule {
    name: "cube-quotient",
    statement: "a^2 + a*b + b^2 = (a^3 - b^3)/(a - b)",
    condition: "a and b are of opposite signs, and neither is 0, so that a - b does not cancel or vanish",
};

/// A sum of three terms as a quotient, where the one in the middle is opposed to both others; as it stands elsewhere.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let parts = surd.cubic_terms();
    let ([_, middle, _], Some(below)) = (&parts[..], below(builder, surd)) else { return Ok(None) };
    let signs: Vec<Sign> = parts.iter().map(|part| builder.tower.sign_of(part)).collect();
    let around = signs[0].plus(signs[2]);
    // those around it are squares then
    if !is_added_where_opposed(builder, &below, middle) {
        return Ok(None);
    }
    let [a, b] = cubic::terms(builder, &below)?[..] else { return Ok(None) };
    let otherwise = quotient(builder, surd, &below, [a, b])?;
    builder.mark(&RULE, otherwise);
    if signs[1] == -(around & Sign::NONZERO) {
        return Ok(Some(otherwise));
    }
    let terms: Vec<Term> = cubic::terms(builder, surd)?;
    let then = cubic::added(builder, surd, &terms, around)?;
    // the terms below the bar are opposed, or one is zero, where those of the sum agree
    let turned = b.negated(&mut builder.graph);
    let condition = agreement(&mut builder.graph, (a.node, a.sign), (turned.node, turned.sign));
    Ok(Some(builder.graph.select(condition, then, otherwise)))
}

/// What the sum is multiplied with to be free of the root, if that has two terms: of a^2 + a*b + b^2 it is a - b.
fn below(builder: &Builder, surd: &Surd) -> Option<Surd> {
    let tower = &builder.tower;
    let (_, conjugate) = tower.conjugate(&surd.sum, &surd.radical).primitive();
    let conjugate = conjugate.divided_by(&tower.content(&conjugate))?;
    let conjugate = conjugate.divided_by(&merge_cubes::common_roots(tower, &conjugate))?;
    let below = Surd::new(conjugate, surd.radical.clone(), surd.quotient.clone());
    (below.cubic_terms().len() == 2).then_some(below)
}

/// Whether the terms below the bar have one sign, and are not zero, where the one in the middle is opposed to those
/// around it: their product is then a multiple of the one in the middle, by a negative constant.
fn is_added_where_opposed(builder: &Builder, below: &Surd, middle: &Polynomial) -> bool {
    let reduced = |polynomial: &Polynomial| builder.tower.reduce(polynomial);
    let product = below.cubic_terms().iter().fold(middle.clone(), |product, term| reduced(&product.times(term)));
    let factor = product.divided_by(&reduced(&middle.times(middle))).and_then(|factor| factor.as_constant());
    factor.is_some_and(|factor| factor.is_negative())
}

fn quotient(builder: &mut Builder, surd: &Surd, below: &Surd, [a, b]: [Term; 2]) -> Result<Node, TowerError> {
    let above = builder.tower.reduce(&surd.sum.times(&below.sum));
    let sum = builder.graph.add_of_one_sign(b.node, a.node, Sign::ANY);
    let mut quotient = surd.quotient.clone();
    quotient.multiply_node(sum, -1);
    builder.product(&above, quotient)
}
