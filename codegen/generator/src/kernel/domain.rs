//! Domains: a contract's conditions as steps that decide them, and as facts about signs.

use super::as_written::compensated_as_written;
use super::error::KernelError;
use super::formula::Formula;
use super::known::{Effort, Known};
use crate::algebra::Polynomial;
use crate::field::{Sign, TowerError};
use crate::program::{Condition, Node};
use crate::rust::RequireText;
use crate::stable::builder::Builder;
use crate::stable::compared_with_zero;
use closedform_arith::Relation;
use closedform_project::domain::{Comparison, Condition as Contracted, Domain, Stated};
use num_rational::BigRational;
use num_traits::Signed;

/// The conditions of a domain, in order, without the natural ones that always hold; what they say about signs goes into
/// the builder's facts.
///
/// # Errors
/// When a side of a comparison is no rational function of the inputs.
pub fn build(builder: &mut Builder, domain: &Domain) -> Result<Vec<RequireText>, KernelError> {
    let mut requires = Vec::new();
    let mut known = Known::new(&builder.tower);
    for Stated { text, condition, natural } in domain.stated() {
        let formula = Formula::of(&mut builder.tower, condition, text)?;
        if *natural && known.shows(&formula, Effort::Search) {
            continue;
        }
        known.learn(&formula);
        // decided before it is known to hold: a condition must not be taken for granted in its own test
        let steps = steps(builder, condition, text)?;
        requires.push(RequireText::new(steps, text));
        learn(builder, condition, text)?;
        builder.forget_polynomials();
    }
    Ok(requires)
}

/// Records what a domain says about signs, without any steps.
///
/// # Errors
/// When a side of a comparison is no rational function of the inputs.
pub fn learn_all(builder: &mut Builder, domain: &Domain) -> Result<(), KernelError> {
    domain.conditions().zip(domain.texts()).try_for_each(|(condition, text)| learn(builder, condition, text))
}

fn learn(builder: &mut Builder, condition: &Contracted, text: &str) -> Result<(), KernelError> {
    match condition {
        Contracted::Compare(comparison) => {
            for comparison in comparison.divisors().iter().chain([comparison]) {
                let (polynomial, order) = normal_form(builder, comparison, text)?;
                builder.tower.facts.learn(&polynomial, Sign::of_relation(order));
            }
            Ok(())
        }
        Contracted::And(parts) => parts.iter().try_for_each(|part| learn(builder, part, text)),
        Contracted::Or(_) => Ok(()),
    }
}

fn steps(builder: &mut Builder, condition: &Contracted, text: &str) -> Result<Condition, KernelError> {
    match condition {
        Contracted::Compare(comparison) => {
            let mut parts = Vec::new();
            for divisor in comparison.divisors() {
                let (polynomial, order) = normal_form(builder, divisor, text)?;
                if !builder.tower.facts.sign(&polynomial).is(Sign::NONZERO) {
                    parts.push(decided(builder, &polynomial, order, text)?);
                }
            }
            parts.push(compared(builder, comparison, text)?);
            // a divisor of a divisor says the same as that
            let first = |at: &usize| !parts[..*at].contains(&parts[*at]);
            let parts: Vec<Condition> = (0..parts.len()).filter(first).map(|at| parts[at].clone()).collect();
            Ok(joined(parts, Condition::And, builder))
        }
        Contracted::And(parts) => Ok(joined(all_steps(builder, parts, text)?, Condition::And, builder)),
        Contracted::Or(parts) => Ok(joined(all_steps(builder, parts, text)?, Condition::Or, builder)),
    }
}

fn all_steps(builder: &mut Builder, parts: &[Contracted], text: &str) -> Result<Vec<Condition>, KernelError> {
    parts.iter().map(|part| steps(builder, part, text)).collect()
}

/// The steps of a comparison where its sides have values.
fn compared(builder: &mut Builder, comparison: &Comparison, text: &str) -> Result<Condition, KernelError> {
    if let Some(condition) = as_written(builder, comparison, text)? {
        return Ok(condition);
    }
    let (polynomial, order) = normal_form(builder, comparison, text)?;
    decided(builder, &polynomial, order, text)
}

/// All parts joined; of none, what always holds.
fn joined(
    parts: Vec<Condition>,
    join: fn(Box<Condition>, Box<Condition>) -> Condition,
    builder: &mut Builder,
) -> Condition {
    let joined = parts.into_iter().reduce(|a, b| join(Box::new(a), Box::new(b)));
    joined.unwrap_or_else(|| {
        let zero = builder.graph.constant(&BigRational::from_integer(0.into()));
        Condition::Compare(zero, Relation::Equal, zero)
    })
}

/// A comparison in double-double as the contract writes it, where it holds the square of a sum: expanded, the square would
/// cancel again what its sum has cancelled already.
fn as_written(builder: &mut Builder, comparison: &Comparison, text: &str) -> Result<Option<Condition>, KernelError> {
    let (left, right) = (&comparison.lhs, &comparison.rhs);
    if !left.has_power_of_sum() && !right.has_power_of_sum() {
        return Ok(None);
    }
    let order = comparison.relation;
    let below = order.is_below();
    let (left, right, order) = if below { (right, left, order.mirrored()) } else { (left, right, order) };
    let expression = compensated_as_written(builder, &left.clone().minus(right.clone()))
        .map_err(|cause| KernelError::Domain { condition: text.to_owned(), cause })?;
    let Some(expression) = expression else { return Ok(None) };
    let node = builder.graph.compensated(expression, Sign::ANY);
    Ok(Some(compared_with_zero(&mut builder.graph, node, order)))
}

/// A comparison as a polynomial compared with zero, without the factors whose sign is known.
fn normal_form(
    builder: &mut Builder,
    comparison: &Comparison,
    text: &str,
) -> Result<(Polynomial, Relation), KernelError> {
    let failed = |cause: TowerError| KernelError::Domain { condition: text.to_owned(), cause };
    let difference = builder.tower.canonical(&comparison.difference()).map_err(failed)?;
    let factors = difference.numerator.times(&difference.denominator).factors();
    let mut order = comparison.relation;
    if factors.constant.is_negative() {
        order = order.mirrored();
    }
    let mut open = builder.tower.ring().integer(1);
    for (factor, exponent) in &factors.powers {
        let sign = builder.tower.facts.sign(factor).power(*exponent);
        if sign.is(Sign::NEGATIVE) {
            order = order.mirrored();
        } else if !(sign.is(Sign::POSITIVE)
            || matches!(order, Relation::Equal | Relation::NotEqual) && sign.is(Sign::NONZERO))
        {
            open = open.times(&factor.power(*exponent));
        }
    }
    let below = order.is_below();
    let mixed = open.terms().iter().any(|t| t.coefficient.is_positive())
        && open.terms().iter().any(|t| t.coefficient.is_negative());
    Ok(if below && mixed { (open.negated(), order.mirrored()) } else { (open, order) })
}

fn decided(
    builder: &mut Builder,
    polynomial: &Polynomial,
    order: Relation,
    text: &str,
) -> Result<Condition, KernelError> {
    decide(builder, polynomial, order).map_err(|cause| KernelError::Domain { condition: text.to_owned(), cause })
}

fn decide(builder: &mut Builder, polynomial: &Polynomial, order: Relation) -> Result<Condition, TowerError> {
    if let Some((left, right)) = two_exact_sides(builder, polynomial)? {
        return Ok(Condition::Compare(left, order, right));
    }
    let node = builder.polynomial(polynomial)?;
    Ok(compared_with_zero(&mut builder.graph, node, order))
}

/// The two sides of a comparison between inputs, or of an input with a constant, where no step rounds.
fn two_exact_sides(builder: &mut Builder, polynomial: &Polynomial) -> Result<Option<(Node, Node)>, TowerError> {
    let ring = polynomial.ring();
    let terms = polynomial.terms();
    let (first, second) = match terms.as_slice() {
        [a, b] if a.coefficient.is_positive() && b.coefficient.is_negative() => (a, b),
        [a, b] if a.coefficient.is_negative() && b.coefficient.is_positive() => (b, a),
        _ => return Ok(None),
    };
    let left = ring.term(&first.coefficient, &first.exponents);
    let right = ring.term(&-&second.coefficient, &second.exponents);
    let scale = first.coefficient.recip();
    let (left, right) = if second.exponents.iter().all(|e| *e == 0) {
        (left.scaled(&scale), right.scaled(&scale))
    } else {
        (left, right)
    };
    let (left, right) = (builder.polynomial(&left)?, builder.polynomial(&right)?);
    let exact = builder.graph.error(left) == 0.0 && builder.graph.error(right) == 0.0;
    Ok(exact.then_some((left, right)))
}
