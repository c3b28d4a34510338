//! Stable forms: from canonical elements to programs that keep their digits, by named rules.

pub mod builder;
pub mod nest;
pub mod rules;
mod slices;

use crate::field::{Element, TowerError};
use crate::program::Node;
use builder::Builder;
use rules::gathered;
use rules::through_result::{self, Earlier};

/// The steps of several results that share work, in order.
///
/// # Errors
/// When the tower has no room left.
pub fn stabilise(builder: &mut Builder, results: &[Element]) -> Result<Vec<Node>, TowerError> {
    let mut earlier: Vec<Earlier> = Vec::new();
    for element in results {
        let node = with_few_roundings(builder, element, &earlier)?;
        earlier.push(Earlier { element: element.clone(), node });
    }
    Ok(earlier.into_iter().map(|result| result.node).collect())
}

/// The steps of an element: through an earlier result if that can be, unless it has more roundings than the direct form
/// and too many.
fn with_few_roundings(builder: &mut Builder, element: &Element, earlier: &[Earlier]) -> Result<Node, TowerError> {
    let unused = builder.used_rules().clone();
    let Some(through) = through_result::apply(builder, element, earlier)? else { return builder.element(element) };
    if builder.graph.error(through) <= gathered::ENOUGH {
        return Ok(through);
    }
    let used = builder.used_rules().clone();
    let through_error = gathered::error(builder, through);
    builder.reset_rules(unused);
    let direct = builder.element(element)?;
    let used_directly = builder.used_rules().clone();
    let is_better = gathered::error(builder, direct) < through_error;
    builder.reset_rules(if is_better { used_directly } else { used });
    Ok(if is_better { direct } else { through })
}
