//! Rule `merge-cubes`: a product of cube roots, and a quotient by a factor of what stands under them, become one root.

use crate::algebra::Polynomial;
use crate::field::{Radical, Tower, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::quotient::{Factor, Quotient};
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use num_rational::BigRational;
use num_traits::Zero;

/// The rule.
pub const RULE: Rule = Rule {
    name: "merge-cubes",
    statement: "cbrt(a)*cbrt(b) = cbrt(a*b), cbrt(a)^2 = cbrt(a^2), and cbrt(a)/a = cbrt(1/a^2)",
    condition: "a is not 0 where it divides",
};

/// A cube root that is a factor of a whole sum, and how often.
type Common = (Radical, u32);

/// The sum, if cube roots are factors of all of it.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let common = common(&builder.tower, &surd.sum);
    if common.is_empty() {
        return Ok(None);
    }
    let roots = common_roots(&builder.tower, &surd.sum);
    let Some(rest) = surd.sum.divided_by(&roots) else { return Ok(None) };
    let mut quotient = surd.quotient.clone();
    multiply_roots(builder, &common, &mut quotient)?;
    builder.product(&rest, quotient).map(Some)
}

/// The cube roots that are factors of a whole sum.
fn common(tower: &Tower, sum: &Polynomial) -> Vec<Common> {
    let cubes = tower.radicals().iter().filter(|radical| radical.degree == 3);
    cubes.map(|radical| (radical.clone(), times_in(sum, radical))).filter(|(_, times)| *times > 0).collect()
}

/// Their product, as a polynomial in radicals.
#[must_use]
pub fn common_roots(tower: &Tower, sum: &Polynomial) -> Polynomial {
    let variable = |radical: &Radical| tower.ring().variable(radical.var);
    let common = common(tower, sum);
    common
        .iter()
        .fold(tower.ring().integer(1), |product, (radical, times)| product.times(&variable(radical).power(*times)))
}

/// How often a radical is a factor of every term.
fn times_in(sum: &Polynomial, radical: &Radical) -> u32 {
    sum.terms().iter().map(|term| u32::from(term.exponents[radical.var.0])).min().unwrap_or(0)
}

/// Multiplies a quotient by cube roots: by one for all whose radicands have no roots themselves.
fn multiply_roots(builder: &mut Builder, common: &[Common], quotient: &mut Quotient) -> Result<(), TowerError> {
    let (nested, flat): (Vec<&Common>, Vec<&Common>) =
        common.iter().partition(|(radical, _)| builder.tower.top_radical(&radical.radicand).is_some());
    for (radical, times) in nested {
        let root = builder.variable(radical.var)?;
        quotient.multiply_node(root, *times as i32);
    }
    let mut inside = Quotient::one();
    flat.iter().for_each(|(radical, times)| inside.multiply(&radical.radicand, *times as i32));
    let numbers = flat.iter().filter_map(|(radical, _)| radical.radicand.as_constant()).collect();
    let moved = move_denominators(&mut inside, quotient, numbers);
    if let ([(radical, 1)], false) = (&flat[..], moved) {
        let root = builder.variable(radical.var)?;
        quotient.multiply_node(root, 1);
    } else if !flat.is_empty() {
        let radicand = builder.quotient(&inside)?;
        let root = builder.root(3, radicand);
        builder.mark(&RULE, root);
        quotient.multiply_node(root, 1);
    }
    Ok(())
}

/// Takes factors, and `numbers` among them, that the root shares with the denominator under the root, as cubes.
fn move_denominators(inside: &mut Quotient, quotient: &mut Quotient, mut numbers: Vec<BigRational>) -> bool {
    numbers.retain(|number| (quotient.constant.denom() % number.numer()).is_zero());
    for number in &numbers {
        quotient.constant *= number;
        inside.constant /= number * number * number;
    }
    let mut moved = !numbers.is_empty();
    for (factor, power) in &mut inside.powers {
        let same =
            |other: &Factor| matches!((&*factor, other), (Factor::Polynomial(a), Factor::Polynomial(b)) if a == b);
        if let Some((_, exponent)) = quotient.powers.iter_mut().find(|(other, e)| *e < 0 && same(other)) {
            *exponent += 1;
            *power -= 3;
            moved = true;
        }
    }
    quotient.powers.retain(|(_, power)| *power != 0);
    moved
}
