//! Rule `merge-roots`: a product of square roots, and a quotient by a factor of the radicand, become one root.

use crate::algebra::Polynomial;
use crate::field::{Radical, Sign, TowerError, parts};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::quotient::{Factor, Quotient};
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use closedform_syntax::Function;

/// The rule.
pub const RULE: Rule = Rule {
    name: "merge-roots",
    statement: "sqrt(a)*sqrt(b) = sqrt(a*b), sqrt(a*b)/a = sqrt(b/a), sqrt(a^2*b)/a^2 = sqrt(b/a^2), and sqrt(r)/r = 1/sqrt(r)",
    condition: "a and b are nonnegative; a is positive where it divides alone",
};

/// The sum, if a root is a factor of all of it.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Option<Node>, TowerError> {
    let common = builder.tower.radicals().iter().rev().find_map(|radical| {
        let (rational, rest) = parts(&surd.sum, radical.var);
        (radical.degree == 2 && rational.is_zero()).then(|| (radical.clone(), rest))
    });
    let Some((radical, rest)) = common else { return Ok(None) };
    merged(builder, &rest, &radical, surd.quotient.clone()).map(Some)
}

/// `surd*sqrt(r)` times a quotient, with one root for all that `surd` contains as factors.
fn merged(
    builder: &mut Builder,
    surd: &Polynomial,
    radical: &Radical,
    mut quotient: Quotient,
) -> Result<Node, TowerError> {
    let mut inside = Quotient::one();
    let mut rest = surd.clone();
    let mut next = Some(radical.clone());
    let (mut merged, mut magnitudes) = (Vec::new(), Vec::new());
    while let Some(root) = next {
        if let Some(magnitude) = builder.tower.magnitude_of(&root) {
            magnitudes.push((root, magnitude));
        } else if builder.tower.top_radical(&root.radicand).is_some() {
            let node = builder.variable(root.var)?;
            quotient.multiply_node(node, 1);
        } else {
            inside.multiply(&root.radicand, 1);
            merged.push(root.var);
        }
        next = builder.tower.top_radical(&rest).filter(|radical| radical.degree == 2).cloned();
        if let Some(root) = &next {
            let (rational, surd) = parts(&rest, root.var);
            if !rational.is_zero() {
                break;
            }
            rest = surd;
        }
    }
    for (radical, magnitude) in magnitudes {
        let (shared, below) = (holds(&inside, &magnitude, 1), holds(&quotient, &magnitude, -2));
        if shared && below {
            inside.multiply(&radical.radicand, 1);
            merged.push(radical.var);
            continue;
        }
        let node = builder.variable(radical.var)?;
        quotient.multiply_node(node, if below { -1 } else { 1 });
        if below {
            quotient.multiply(&radical.radicand, 1);
        }
    }
    let below = divide_by_radicand(&inside, &mut quotient);
    let moved = below || move_denominators(builder, &mut inside, &mut quotient);
    if let ([var], false) = (merged.as_slice(), moved) {
        let root = builder.variable(*var)?;
        quotient.multiply_node(root, 1);
    } else if !merged.is_empty() {
        let radicand = builder.quotient(&inside)?;
        let root = builder.graph.call(Function::Sqrt, radicand);
        builder.mark(&RULE, root);
        quotient.multiply_node(root, if below { -1 } else { 1 });
    }
    builder.product(&rest, quotient)
}

/// Whether a quotient has this power of a polynomial, or one that is farther from zero.
fn holds(quotient: &Quotient, polynomial: &Polynomial, power: i32) -> bool {
    let held = |factor: &Polynomial, wanted: i32| {
        quotient.powers.iter().any(|(f, e)| {
            matches!(f, Factor::Polynomial(p) if p == factor)
                && e.signum() == wanted.signum()
                && e.abs() >= wanted.abs()
        })
    };
    polynomial.factors().powers.iter().all(|(factor, times)| held(factor, power * *times as i32))
}

/// Takes a whole radicand out of the denominator, if it is there: `sqrt(r)/r` is `1/sqrt(r)`.
fn divide_by_radicand(inside: &Quotient, quotient: &mut Quotient) -> bool {
    let same = |a: &Factor, b: &Factor| matches!((a, b), (Factor::Polynomial(a), Factor::Polynomial(b)) if a == b);
    let sum = inside.powers.iter().any(|(factor, _)| matches!(factor, Factor::Polynomial(p) if p.len() > 1));
    let held = |(factor, power): &(Factor, i32)| quotient.powers.iter().any(|(f, e)| same(f, factor) && *e <= -power);
    if !sum || !inside.powers.iter().all(held) {
        return false;
    }
    for (factor, power) in &inside.powers {
        if let Some((_, exponent)) = quotient.powers.iter_mut().find(|(f, _)| same(f, factor)) {
            *exponent += power;
        }
    }
    quotient.constant *= &inside.constant;
    quotient.powers.retain(|(_, power)| *power != 0);
    true
}

/// Takes factors that the root shares with the denominator under the root: positive ones, and squares of any.
fn move_denominators(builder: &Builder, inside: &mut Quotient, quotient: &mut Quotient) -> bool {
    let mut moved = false;
    for (factor, power) in &mut inside.powers {
        let Factor::Polynomial(polynomial) = factor else { continue };
        let taken = match *power {
            1 if builder.tower.facts.sign(polynomial).is(Sign::POSITIVE) => 1,
            2.. => 2,
            _ => continue,
        };
        let held = |f: &Factor, e: i32| matches!(f, Factor::Polynomial(p) if p == polynomial) && e <= -taken;
        if let Some((_, exponent)) = quotient.powers.iter_mut().find(|(f, e)| held(f, *e)) {
            *exponent += taken;
            *power -= 2 * taken;
            moved = true;
        }
    }
    quotient.powers.retain(|(_, power)| *power != 0);
    moved
}
