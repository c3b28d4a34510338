//! Rule `factored`: an expanded polynomial is evaluated as the product of its factors.

use super::Rule;
use crate::stable::builder::{Factor, Quotient};

/// The rule.
pub const RULE: Rule = Rule {
    name: "factored",
    statement: "a*b + a*c = a*(b + c), and a*b/(a*c) = b/c",
    condition: "always; the factors are irreducible over the rationals, and common ones cancel",
};

/// Whether the quotient has factors that the expanded form hides.
#[must_use]
pub fn holds_for(quotient: &Quotient) -> bool {
    let sum = |factor: &Factor| matches!(factor, Factor::Polynomial(p) if p.len() > 1);
    quotient.powers.iter().any(|(factor, power)| sum(factor) && (power.abs() > 1 || quotient.powers.len() > 1))
}
