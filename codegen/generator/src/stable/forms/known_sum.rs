//! Rule `known-sum`: a variable is written through a sum whose sign the domain gives, so that nothing cancels.

use super::plain;
use crate::algebra::{Polynomial, Var};
use crate::field::{Slack, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;

/// The rule.
pub const RULE: Rule = Rule {
    name: "known-sum",
    statement: "p(x, y, ..) = q(s, y, ..) with s = x + y, or s = x - y",
    condition: "the domain gives the sign of s, all terms of q agree in sign, and s is one rounding of exact inputs",
};

/// The polynomial in plain arithmetic through one known sum, if there is one.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, polynomial: &Polynomial) -> Result<Option<Node>, TowerError> {
    let slacks: Vec<Slack> = builder.tower.facts.slacks().to_vec();
    for slack in &slacks {
        for var in slack.polynomial.variables() {
            if !polynomial.contains(var) {
                continue;
            }
            if let Some(node) = through(builder, polynomial, slack, var)? {
                builder.mark(&RULE, node);
                return Ok(Some(node));
            }
        }
    }
    Ok(None)
}

fn through(
    builder: &mut Builder,
    polynomial: &Polynomial,
    slack: &Slack,
    var: Var,
) -> Result<Option<Node>, TowerError> {
    let Some(sum) = plain::steps(builder, &slack.polynomial)? else { return Ok(None) };
    let stand_in = builder.tower.allocate(slack.sign)?;
    builder.stand_for(stand_in, sum);
    let Some(value) = slack.solved_for(var, &polynomial.ring().variable(stand_in)) else { return Ok(None) };
    plain::steps(builder, &polynomial.substituted(var, &value))
}
