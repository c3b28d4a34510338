//! Rule `factored`: an expanded polynomial is evaluated as the product of its factors.

use super::divided;
use crate::field::TowerError;
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::quotient::{Factor, Quotient};
use crate::stable::rule::Rule;

/// The rule.
pub const RULE: Rule = Rule {
    name: "factored",
    statement: "a*b + a*c = a*(b + c), and a*b/(a*c) = b/c",
    condition: "always; the factors are irreducible over the rationals, and common ones cancel",
};

/// The quotient, if it has factors that the expanded form hides.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, quotient: &Quotient) -> Result<Option<Node>, TowerError> {
    if !hides_factors(quotient) {
        return Ok(None);
    }
    let node = divided::steps(builder, quotient)?;
    builder.mark(&RULE, node);
    Ok(Some(node))
}

fn hides_factors(quotient: &Quotient) -> bool {
    let sum = |factor: &Factor| matches!(factor, Factor::Polynomial(p) if p.len() > 1);
    quotient.powers.iter().any(|(factor, power)| sum(factor) && (power.abs() > 1 || quotient.powers.len() > 1))
}
