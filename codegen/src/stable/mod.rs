//! Stable forms: from canonical elements to programs that keep their digits, by named rules.

pub mod builder;
pub mod nest;
pub mod rules;

use crate::field::{Element, TowerError};
use crate::program::Node;
use builder::Builder;
use rules::through_result::{self, Earlier};

/// The steps of several results that share work, in order.
///
/// # Errors
/// When the tower has no room left.
pub fn stabilise(builder: &mut Builder, results: &[Element]) -> Result<Vec<Node>, TowerError> {
    let mut earlier: Vec<Earlier> = Vec::new();
    for element in results {
        let node = match through_result::apply(builder, element, &earlier)? {
            Some(node) => node,
            None => builder.element(element)?,
        };
        earlier.push(Earlier { element: element.clone(), node });
    }
    Ok(earlier.into_iter().map(|result| result.node).collect())
}
