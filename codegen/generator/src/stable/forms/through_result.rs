//! Rule `through-result`: a result is computed from an earlier result of the same kernel, where that removes cancellation.

use super::plain;
use crate::algebra::{Polynomial, Var};
use crate::field::{Element, Sign, Tower, TowerError, parts};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::quotient::Quotient;
use crate::stable::rule::Rule;
use std::cmp::Ordering;

/// The rule.
pub const RULE: Rule = Rule {
    name: "through-result",
    statement: "f(x, .., sqrt(r)) = g(x, .., u) with an earlier result u = (a + b*sqrt(r))/c",
    condition: "f - g(.., u) is exactly zero, and no sum of g cancels on the domain",
};

/// An earlier result: its exact value and its step.
pub struct Earlier {
    /// The exact value.
    pub element: Element,
    /// The step.
    pub node: Node,
}

/// A result, and those before it.
pub struct Later {
    /// The exact value.
    pub element: Element,
    /// What comes before it.
    pub earlier: Vec<Earlier>,
}

/// The steps of a result through an earlier one, if that gives a plain rational form.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, later: &Later) -> Result<Option<Node>, TowerError> {
    for result in &later.earlier {
        let sign = builder.tower.sign(&result.element);
        let Some((numerator, denominator)) = eliminate(builder, &later.element, result, sign)? else { continue };
        let mut quotient = Quotient::one();
        quotient.multiply(&denominator, -1);
        quotient.multiply(&numerator, 1);
        let node = builder.quotient(&quotient)?;
        builder.mark(&RULE, node);
        return Ok(Some(node));
    }
    Ok(None)
}

/// The element as a rational function of the inputs and the earlier result, without the root.
fn eliminate(
    builder: &mut Builder,
    element: &Element,
    earlier: &Earlier,
    sign: Sign,
) -> Result<Option<(Polynomial, Polynomial)>, TowerError> {
    let tower = &builder.tower;
    // of several roots u would give one by the others: their sums are left to the forms of surds
    let [radical] = tower.radicals() else { return Ok(None) };
    let radical = radical.clone();
    if radical.degree != 2 || ![element, &earlier.element].iter().all(|with| with.numerator.contains(radical.var)) {
        return Ok(None);
    }
    let stand_in = builder.tower.allocate(sign)?;
    builder.stand_for(stand_in, earlier.node);
    let ring = builder.tower.ring().clone();
    let result = ring.variable(stand_in);
    // u = (a + b*s)/c  =>  s = (c*u - a)/b  and  (c*u - a)^2 = b^2*r
    let (a, b) = parts(&earlier.element.numerator, radical.var);
    let offset = earlier.element.denominator.times(&result).minus(&a);
    let relation = offset.power(2).minus(&b.power(2).times(&radical.radicand));
    let (rational, surd) = parts(&element.numerator, radical.var);
    let numerator = rational.times(&b).plus(&surd.times(&offset));
    let denominator = element.denominator.times(&b);
    let mut candidates = vec![(numerator.clone(), denominator.clone())];
    if a.is_zero() {
        // u = b*s/c, so a radicand below the bar is (c*u/b)^2
        if let Some(rest) = denominator.divided_by(&radical.radicand) {
            candidates.push((numerator.times(&b.power(2)), rest.times(&offset.power(2))));
        }
    }
    for (factor, _) in relation.factors().powers {
        if vanishes(&builder.tower, &factor, stand_in, &earlier.element)? {
            candidates.extend(eliminations(&numerator, &denominator, &factor));
        }
    }
    let mut plain: Vec<(Polynomial, Polynomial)> = candidates
        .into_iter()
        .map(|(n, d)| lowest_terms(&n, &d))
        .filter(|(n, d)| is_plain(builder, n) && is_plain(builder, d))
        .collect();
    plain.sort_by(|x, y| (x.0.len() + x.1.len()).cmp(&(y.0.len() + y.1.len())).then_with(|| order(x, y)));
    Ok(plain.into_iter().next())
}

fn order(x: &(Polynomial, Polynomial), y: &(Polynomial, Polynomial)) -> Ordering {
    x.0.compare(&y.0).then_with(|| x.1.compare(&y.1))
}

/// The quotient with each input that the relation gives as a rational function replaced by it.
fn eliminations(
    numerator: &Polynomial,
    denominator: &Polynomial,
    relation: &Polynomial,
) -> Vec<(Polynomial, Polynomial)> {
    let mut found = Vec::new();
    for var in relation.variables() {
        if relation.degree(var) != 1 {
            continue;
        }
        let coefficients = relation.coefficients(var);
        let value = (coefficients[0].negated(), coefficients[1].clone());
        let (n, n_power) = homogenised(numerator, var, &value);
        let (d, d_power) = homogenised(denominator, var, &value);
        let scale = |p: Polynomial, missing: u16| p.times(&value.1.power(u32::from(missing)));
        let most = n_power.max(d_power);
        found.push((scale(n, most - n_power), scale(d, most - d_power)));
    }
    found
}

/// `p(value.0/value.1) * value.1^k` and `k`, the degree.
fn homogenised(polynomial: &Polynomial, var: Var, value: &(Polynomial, Polynomial)) -> (Polynomial, u16) {
    let degree = polynomial.degree(var);
    let mut sum = polynomial.ring().integer(0);
    for (power, coefficient) in polynomial.coefficients(var).iter().enumerate() {
        let over = value.0.power(power as u32);
        let under = value.1.power(u32::from(degree) - power as u32);
        sum = sum.plus(&coefficient.times(&over).times(&under));
    }
    (sum, degree)
}

fn lowest_terms(numerator: &Polynomial, denominator: &Polynomial) -> (Polynomial, Polynomial) {
    let common = numerator.gcd(denominator);
    let cancel = |p: &Polynomial| p.divided_by(&common).unwrap_or_else(|| p.clone());
    (cancel(numerator), cancel(denominator))
}

fn is_plain(builder: &Builder, polynomial: &Polynomial) -> bool {
    let factors = polynomial.factors();
    !polynomial.is_zero() && factors.powers.iter().all(|(factor, _)| plain::applies(builder, factor))
}

/// Whether the relation holds for the earlier result itself, exactly.
fn vanishes(tower: &Tower, relation: &Polynomial, stand_in: Var, value: &Element) -> Result<bool, TowerError> {
    let (numerator, _) = homogenised(relation, stand_in, &(value.numerator.clone(), value.denominator.clone()));
    Ok(tower.reduce(&numerator).is_zero())
}
