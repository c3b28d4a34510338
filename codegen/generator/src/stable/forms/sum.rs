//! Sums with a square root whose terms have one sign: they are taken as they stand.

use crate::algebra::Polynomial;
use crate::field::{Radical, Sign, TowerError, parts};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::surd::Surd;
use num_traits::Signed;

/// The sum, if its terms have one sign.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let [left, right] = surd.signs(&builder.tower);
    let sign = left.plus(right);
    if !sign.is_definite() {
        return Ok(None);
    }
    as_it_stands(builder, surd, sign).map(Some)
}

/// The sum times the quotient, where both terms of the sum have the given sign.
///
/// # Errors
/// When the tower has no room left.
pub fn as_it_stands(builder: &mut Builder, surd: &Surd, sign: Sign) -> Result<Node, TowerError> {
    let node = of_one_sign(builder, &surd.sum, &surd.radical, sign)?;
    let mut quotient = surd.quotient.clone();
    quotient.multiply_node(node, 1);
    builder.quotient(&quotient)
}

/// `a + b*sqrt(r)` in plain arithmetic; the caller knows that both terms have the given sign.
///
/// # Errors
/// When the tower has no room left.
pub fn of_one_sign(builder: &mut Builder, sum: &Polynomial, radical: &Radical, sign: Sign) -> Result<Node, TowerError> {
    let (rational, surd) = parts(sum, radical.var);
    let a = upright(builder, &rational)?;
    let root = builder.tower.ring().variable(radical.var);
    let b = builder.value(&surd.times(&root))?;
    let node = builder.graph.add(b, a);
    let error = builder.graph.error(a).max(builder.graph.error(b)) + 1.0;
    Ok(builder.graph.with_error(node, sign, error))
}

/// A polynomial, or the negative of the steps of its negative: both mean the same branches where it has radicals.
///
/// # Errors
/// When the tower has no room left.
pub fn upright(builder: &mut Builder, polynomial: &Polynomial) -> Result<Node, TowerError> {
    let negative = polynomial.terms().first().is_some_and(|term| term.coefficient.is_negative());
    if !negative || builder.tower.top_radical(polynomial).is_none() {
        return builder.value(polynomial);
    }
    let turned = builder.value(&polynomial.negated())?;
    Ok(builder.graph.neg(turned))
}
