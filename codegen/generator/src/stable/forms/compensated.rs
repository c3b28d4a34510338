//! Rule `compensated`: what may cancel and cannot be rewritten is evaluated in pairs of `f64`.

use super::{differences_first, double_double};
use crate::algebra::Polynomial;
use crate::field::{Sign, TowerError};
use crate::program::Node;
use crate::stable::builder::Builder;
use crate::stable::rule::Rule;

/// The rule.
pub const RULE: Rule = Rule {
    name: "compensated",
    statement: "p(x, y, ..) is evaluated in pairs of f64 and rounded once",
    condition: "p is a polynomial whose operands are exact: inputs, or values that define the problem",
};

/// The polynomial in pairs; the compensated expression is positive where the domain makes it so.
///
/// # Errors
/// When the circle constant is among the operands; when the tower has no room left.
pub fn steps(builder: &mut Builder, polynomial: &Polynomial) -> Result<Node, TowerError> {
    if builder.tower.pi().is_some_and(|pi| polynomial.contains(pi)) {
        return Err(TowerError::CancellingPi);
    }
    let sign = builder.tower.facts.sign(polynomial);
    let turned = sign.is(Sign::NONPOSITIVE);
    let (polynomial, sign) = if turned { (&polynomial.negated(), -sign) } else { (polynomial, sign) };
    let grouped = differences_first::group(builder, polynomial)?;
    let (content, expression) = double_double::polynomial(builder, &grouped)?;
    let expression = builder.graph.compensated(expression, sign);
    builder.mark(&RULE, expression);
    if grouped != *polynomial {
        builder.mark(&differences_first::RULE, expression);
    }
    let content = builder.graph.constant(&if turned { -content } else { content });
    Ok(builder.graph.mul(content, expression))
}
