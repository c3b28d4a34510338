//! Rule `conjugate`: a sum with a square root that cancels becomes a quotient that does not.

use super::{Rule, same_sign_radicand, sign_branch};
use crate::algebra::Polynomial;
use crate::field::{Radical, Sign, TowerError, conjugate, parts};
use crate::program::Node;
use crate::stable::builder::{Builder, Quotient};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The rule.
pub const RULE: Rule = Rule {
    name: "conjugate",
    statement: "a + b*sqrt(r) = (a^2 - b^2*r)/(a - b*sqrt(r))",
    condition: "a and b*sqrt(r) are of opposite signs, and not both 0, so that a - b*sqrt(r) does not cancel or vanish",
};

/// A sum `a + b*sqrt(r)` times a quotient, in the form that does not cancel.
///
/// # Errors
/// When the tower has no room left.
pub fn apply(
    builder: &mut Builder,
    sum: &Polynomial,
    radical: &Radical,
    quotient: Quotient,
) -> Result<Node, TowerError> {
    same_sign_radicand::prepare(builder, sum, radical)?;
    let (rational, surd) = parts(sum, radical.var);
    let root = builder.tower.facts.variable(radical.var);
    let left = builder.tower.sign_of(&rational);
    let right = builder.tower.sign_of(&surd) * root;
    if left.plus(right).is_definite() {
        return direct(builder, sum, radical, quotient, left.plus(right));
    }
    let below = left.plus(-right);
    if below.is_definite() && below.is(Sign::NONZERO) {
        let node = rationalised(builder, sum, radical, quotient, below)?;
        builder.apply(&RULE, node);
        return Ok(node);
    }
    let condition = {
        let a = of_one_sign(builder, &rational)?;
        let b = builder.surd(&surd, Quotient::one())?;
        sign_branch::agree(builder, (a, left), (b, right))?
    };
    let sign = if right.is_definite() { right } else { left };
    let agreeing = if sign.is_definite() { sign } else { Sign::ANY };
    let opposing = if right.is_definite() { -right } else { agreeing };
    let then = direct(builder, sum, radical, quotient.clone(), agreeing)?;
    let otherwise = rationalised(builder, sum, radical, quotient, opposing)?;
    let node = builder.graph.select(condition, then, otherwise);
    builder.apply(&sign_branch::RULE, node);
    builder.apply(&RULE, otherwise);
    Ok(node)
}

fn direct(
    builder: &mut Builder,
    sum: &Polynomial,
    radical: &Radical,
    mut quotient: Quotient,
    sign: Sign,
) -> Result<Node, TowerError> {
    let node = sum_of_one_sign(builder, sum, radical, sign)?;
    quotient.multiply_node(node, 1);
    builder.assemble(&quotient)
}

fn rationalised(
    builder: &mut Builder,
    sum: &Polynomial,
    radical: &Radical,
    mut quotient: Quotient,
    sign: Sign,
) -> Result<Node, TowerError> {
    let norm = builder.tower.norm(sum, radical);
    if norm.is_zero() {
        // a = -b*sqrt(r) wherever the two are of opposite signs
        return Ok(builder.graph.constant(&BigRational::zero()));
    }
    let mut below = conjugate(sum, radical.var);
    let mut sign = sign;
    if sign.is(Sign::NONPOSITIVE) {
        quotient.constant = -quotient.constant;
        (below, sign) = (below.negated(), -sign);
    }
    let node = sum_of_one_sign(builder, &below, radical, sign)?;
    quotient.multiply_node(node, -1);
    builder.surd(&norm, quotient)
}

/// A polynomial, or the negative of the steps of its negative: both mean the same branches where it has radicals.
fn of_one_sign(builder: &mut Builder, polynomial: &Polynomial) -> Result<Node, TowerError> {
    let negative = polynomial.terms().first().is_some_and(|term| term.coefficient.is_negative());
    if !negative || builder.tower.top_radical(polynomial).is_none() {
        return builder.surd(polynomial, Quotient::one());
    }
    let turned = builder.surd(&polynomial.negated(), Quotient::one())?;
    Ok(builder.graph.neg(turned))
}

/// `a + b*sqrt(r)` in plain arithmetic; the caller knows that both terms have the given sign.
fn sum_of_one_sign(builder: &mut Builder, sum: &Polynomial, radical: &Radical, sign: Sign) -> Result<Node, TowerError> {
    let (rational, surd) = parts(sum, radical.var);
    let a = of_one_sign(builder, &rational)?;
    let root = builder.tower.ring().variable(radical.var);
    let b = builder.surd(&surd.times(&root), Quotient::one())?;
    let node = builder.graph.add(b, a);
    let error = builder.graph.error(a).max(builder.graph.error(b)) + 1.0;
    Ok(builder.graph.with_error(node, sign, error))
}
