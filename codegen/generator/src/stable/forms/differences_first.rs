//! Rule `differences-first`: what depends on two inputs only through their difference takes the difference first.

use super::plain;
use crate::algebra::{Polynomial, Var};
use crate::field::TowerError;
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;
use num_traits::Signed;

/// The rule.
pub const RULE: Rule = Rule {
    name: "differences-first",
    statement: "p(x1, x0, ..) = q(x1 - x0, ..)",
    condition: "p(x1 + h, x0 + h, ..) = p(x1, x0, ..) for every h; the difference of two inputs is exact in double-double",
};

/// The polynomial in plain arithmetic through differences of inputs, if nothing cancels then.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, polynomial: &Polynomial) -> Result<Option<Node>, TowerError> {
    let grouped = group(builder, polynomial)?;
    if grouped == *polynomial {
        return Ok(None);
    }
    let node = plain::steps(builder, &grouped)?;
    if let Some(node) = node {
        builder.mark(&RULE, node);
    }
    Ok(node)
}

/// The polynomial in differences of inputs, each standing in place of the two.
///
/// # Errors
/// When the tower has no room left.
pub fn group(builder: &mut Builder, polynomial: &Polynomial) -> Result<Polynomial, TowerError> {
    let mut grouped = polynomial.clone();
    let inputs: Vec<Var> = polynomial.variables().into_iter().filter(|v| v.0 < builder.tower.inputs()).collect();
    for (position, &low) in inputs.iter().enumerate() {
        for &high in &inputs[position + 1..] {
            if let Some(rewritten) = through_difference(builder, &grouped, high, low)? {
                grouped = rewritten;
            }
        }
    }
    let negative = grouped.terms().iter().all(|term| term.coefficient.is_negative());
    if negative { turn_differences(builder, &grouped) } else { Ok(grouped) }
}

/// The polynomial in the opposite differences, so that it does not begin with a minus.
fn turn_differences(builder: &mut Builder, polynomial: &Polynomial) -> Result<Polynomial, TowerError> {
    let mut turned = polynomial.clone();
    for var in polynomial.variables() {
        if let Some((high, low)) = builder.difference_of(var) {
            let opposite = builder.difference(low, high)?;
            turned = turned.substituted(var, &polynomial.ring().variable(opposite).negated());
        }
    }
    Ok(turned)
}

fn through_difference(
    builder: &mut Builder,
    polynomial: &Polynomial,
    high: Var,
    low: Var,
) -> Result<Option<Polynomial>, TowerError> {
    if !polynomial.contains(high) {
        return Ok(None);
    }
    let ring = polynomial.ring();
    let shifted = polynomial.substituted(high, &ring.variable(high).plus(&ring.variable(low)));
    if shifted.contains(low) {
        return Ok(None);
    }
    let difference = builder.difference(high, low)?;
    Ok(Some(shifted.substituted(high, &ring.variable(difference))))
}
