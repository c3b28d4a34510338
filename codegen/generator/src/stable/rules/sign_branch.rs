//! Rule `sign-branch`: where the sign of a term decides which form cancels, the kernel decides by that sign.

use super::Rule;
use crate::field::{Sign, TowerError};
use crate::program::{Condition, Node, Order};
use crate::stable::builder::{Builder, not_opposite};

/// The rule.
pub const RULE: Rule = Rule {
    name: "sign-branch",
    statement: "f = if a*b >= 0 { direct form } else { conjugate form }",
    condition: "both forms are equal to f where they are used",
};

/// The condition that two steps are not of opposite signs.
///
/// # Errors
/// When the tower has no room left.
pub fn agree(builder: &mut Builder, a: (Node, Sign), b: (Node, Sign)) -> Result<Condition, TowerError> {
    if let Some(order) = not_opposite(b.1) {
        return Ok(builder.compare_with_zero(a.0, order));
    }
    if let Some(order) = not_opposite(a.1) {
        return Ok(builder.compare_with_zero(b.0, order));
    }
    let mut both = |order: Order| {
        let left = builder.compare_with_zero(a.0, order);
        let right = builder.compare_with_zero(b.0, order);
        Condition::And(Box::new(left), Box::new(right))
    };
    let (up, down) = (both(Order::GreaterOrEqual), both(Order::LessOrEqual));
    Ok(Condition::Or(Box::new(up), Box::new(down)))
}
