//! Rule `sign-branch`: where the sign of a term decides which form cancels, the kernel decides by that sign.

use super::{conjugate, cube_conjugate, cubic, sum};
use crate::field::{Sign, TowerError};
use crate::program::{Condition, Graph, Node};
use crate::stable::builder::Builder;
use crate::stable::comparison::{compared_with_zero, not_opposite};
use crate::stable::rule::Rule;
use crate::stable::surd::Surd;
use closedform_arith::Relation;

/// The rule.
pub const RULE: Rule = Rule {
    name: "sign-branch",
    statement: "f = if a*b >= 0 { direct form } else { conjugate form }",
    condition: "both forms are equal to f where they are used",
};

/// Either form of a sum, chosen by the signs of its terms.
///
/// # Errors
/// When the tower has no room left.
pub fn steps(builder: &mut Builder, surd: &Surd) -> Result<Node, TowerError> {
    let [left, right] = surd.signs(&builder.tower);
    let (rational, irrational) = surd.parts();
    let a = sum::upright(builder, &rational)?;
    let b = builder.value(&irrational)?;
    let condition = agreement(&mut builder.graph, (a, left), (b, right));
    let sign = if right.is_definite() { right } else { left };
    let agreeing = if sign.is_definite() { sign } else { Sign::ANY };
    let opposing = if right.is_definite() { -right } else { agreeing };
    let then = sum::as_it_stands(builder, surd, agreeing)?;
    let otherwise = conjugate::rationalised(builder, surd, opposing)?;
    let node = builder.graph.select(condition, then, otherwise);
    builder.mark(&RULE, node);
    builder.mark(&conjugate::RULE, otherwise);
    Ok(node)
}

/// Either form of a sum of two terms with cube roots, chosen by their signs.
///
/// # Errors
/// When there are three terms, of which no form keeps the digits; when the tower has no room left.
pub fn of_cubes(builder: &mut Builder, surd: &Surd) -> Result<Node, TowerError> {
    let terms = cubic::terms(builder, surd)?;
    let [a, b] = terms[..] else { return Err(TowerError::CancellingCubes) };
    let condition = agreement(&mut builder.graph, (a.node, a.sign), (b.node, b.sign));
    let sign = if b.sign.is_definite() { b.sign } else { a.sign };
    let then = cubic::added(builder, surd, &terms, if sign.is_definite() { sign } else { Sign::ANY })?;
    let otherwise = cube_conjugate::rationalised(builder, surd, [a, b])?;
    let node = builder.graph.select(condition, then, otherwise);
    builder.mark(&RULE, node);
    builder.mark(&cube_conjugate::RULE, otherwise);
    Ok(node)
}

/// The condition that two steps are not of opposite signs.
pub fn agreement(graph: &mut Graph, a: (Node, Sign), b: (Node, Sign)) -> Condition {
    if let Some(order) = not_opposite(b.1) {
        return compared_with_zero(graph, a.0, order);
    }
    if let Some(order) = not_opposite(a.1) {
        return compared_with_zero(graph, b.0, order);
    }
    let mut both = |order: Relation| {
        let left = compared_with_zero(graph, a.0, order);
        let right = compared_with_zero(graph, b.0, order);
        Condition::And(Box::new(left), Box::new(right))
    };
    let (up, down) = (both(Relation::GreaterOrEqual), both(Relation::LessOrEqual));
    Condition::Or(Box::new(up), Box::new(down))
}
