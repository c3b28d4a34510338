//! Rule `monotone-newton`: the one positive root of a polynomial by Newton from above, corrected by its exact residual.

use super::{Equation, RootError};
use crate::algebra::{Polynomial, Var};
use crate::field::{Sign, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::forms::double_double;
use crate::stable::rule::Rule;
use closedform_arith::error_model;

/// The rule.
pub const RULE: Rule = Rule {
    name: "monotone-newton",
    statement: "x := x - p(x)/p'(x) from above while x falls, then once with p(x) in double-double, or exact if coefficients cancel",
    condition: "the coefficients of p change sign once on the domain, from negative to positive: one positive root (Descartes)",
};

/// The root of an equation.
///
/// # Errors
/// When the domain does not show that there is exactly one positive root.
pub fn steps(builder: &mut Builder, equation: &Equation) -> Result<Node, RootError> {
    let unknown = equation.unknown;
    let polynomial = oriented(builder, &equation.polynomial, unknown);
    let coefficients = polynomial.coefficients(unknown);
    let turn = turning_power(builder, &coefficients)?;
    let nodes = coefficients.iter().map(|c| builder.value(c));
    let nodes: Vec<Node> = nodes.collect::<Result<_, _>>()?;
    let start = builder.graph.positive_root(nodes, f64::INFINITY);
    builder.mark(&RULE, start);
    builder.stand_for(unknown, start);
    builder.tower.facts.set_variable(unknown, Sign::POSITIVE);
    // the iterate counts as exact here: its residual is what is being computed
    let residual = remainder(builder, &polynomial, &coefficients)?;
    let slope = slope(builder, &coefficients, unknown, turn)?;
    let ratio = builder.graph.div(residual, slope);
    let step = builder.graph.mul(start, ratio);
    let root = builder.graph.sub(start, step);
    builder.mark(&RULE, root);
    Ok(builder.graph.with_error(root, Sign::POSITIVE, CORRECTED))
}

/// The relative error after the correction, in units of 2^-53.
const CORRECTED: f64 = error_model::CORRECTED_ROOT.to_f64();

/// The polynomial at the iterate. Powers of the iterate cancel by no more than double-double holds, since the root is well
/// conditioned; the terms of one coefficient may cancel by more.
fn remainder(builder: &mut Builder, polynomial: &Polynomial, coefficients: &[Polynomial]) -> Result<Node, TowerError> {
    let (content, expression) = double_double::polynomial(builder, polynomial)?;
    let may_cancel = coefficients.iter().any(|c| c.terms().len() > 1 && !builder.tower.facts.terms_agree(c));
    let expression =
        if may_cancel { builder.graph.compensated(expression, Sign::ANY) } else { builder.graph.residual(expression) };
    let content = builder.graph.constant(&content);
    Ok(builder.graph.mul(content, expression))
}

/// The polynomial, or its negative, so that the highest coefficient is positive.
fn oriented(builder: &Builder, polynomial: &Polynomial, unknown: Var) -> Polynomial {
    let highest = polynomial.coefficients(unknown).pop();
    let negative = highest.is_some_and(|c| builder.tower.facts.sign(&c).is(Sign::NEGATIVE));
    if negative { polynomial.negated() } else { polynomial.clone() }
}

/// The power at which the signs turn: all coefficients above are nonnegative, all below nonpositive.
fn turning_power(builder: &Builder, coefficients: &[Polynomial]) -> Result<usize, RootError> {
    let signs: Vec<Sign> = coefficients.iter().map(|c| builder.tower.facts.sign(c)).collect();
    let ends =
        signs.first().is_some_and(|s| s.is(Sign::NEGATIVE)) && signs.last().is_some_and(|s| s.is(Sign::POSITIVE));
    let fits = |turn: usize| {
        signs[..turn].iter().all(|s| s.is(Sign::NONPOSITIVE))
            && signs[turn + 1..].iter().all(|s| s.is(Sign::NONNEGATIVE))
    };
    let turn = (0..signs.len()).find(|&turn| fits(turn));
    match turn {
        Some(turn) if ends => Ok(turn),
        _ => Err(RootError::Signs(signs.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))),
    }
}

/// `x*p'(x)` at a root, without cancellation: the sum of `(j - turn)*c_j*x^j`, whose terms are all nonnegative.
fn slope(builder: &mut Builder, coefficients: &[Polynomial], unknown: Var, turn: usize) -> Result<Node, TowerError> {
    let x = builder.variable(unknown)?;
    let mut sum: Option<Node> = None;
    for (power, coefficient) in coefficients.iter().enumerate().rev() {
        let distance = power as i64 - turn as i64;
        let next = match (&sum, distance == 0 || coefficient.is_zero()) {
            (_, true) => None,
            (_, false) => {
                let weight = coefficient.ring().integer(distance);
                Some(builder.value(&coefficient.times(&weight))?)
            }
        };
        sum = match (sum, next) {
            (None, next) => next,
            (Some(so_far), None) => Some(builder.graph.mul(so_far, x)),
            (Some(so_far), Some(next)) => {
                let product = builder.graph.mul(so_far, x);
                Some(builder.graph.add(product, next))
            }
        };
    }
    Ok(sum.unwrap_or(x))
}
