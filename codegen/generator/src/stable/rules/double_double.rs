//! Rule `double-double`: where slices leave too many roundings, every step is taken in double-double.

use super::Rule;
use crate::program::{Graph, Node, Op};
use crate::stable::builder::Builder;
use closedform_arith::error_model;
use std::collections::HashMap;

/// The rule.
pub const RULE: Rule = Rule {
    name: "double-double",
    statement: "every step is taken in double-double, and only results are rounded",
    condition: "a result would have a bound of more than 5 ulp otherwise, or of more than 2 where the contract asks for few \
                roundings; and no root is iterated",
};

/// A bound that is small enough, in units of 2^-53; and where few roundings are asked for.
const ENOUGH: f64 = 5.0;
const FEW: f64 = 2.0;

/// What a step in double-double adds to a relative error, in units of 2^-53.
const STEP: f64 = error_model::DOUBLE_DOUBLE_STEP.to_f64();

/// How far a `compensated!` slice may be off that is not rounded, in units of 2^-53.
const COMPENSATED: f64 = error_model::COMPENSATED_IN_DOUBLE_DOUBLE.to_f64();

/// Whether the results are taken in double-double, since what is gathered is not enough.
pub fn apply(builder: &mut Builder, results: &[Node], gathered: &[Node], few_roundings: bool) -> bool {
    let most = if few_roundings { FEW } else { ENOUGH };
    let enough = gathered.iter().all(|&result| builder.graph.error(result) <= most);
    if enough || results.iter().any(|&result| !error(&builder.graph, result).is_finite()) {
        return false;
    }
    results.iter().for_each(|&result| builder.apply(&RULE, result));
    true
}

/// The relative error of a result in units of 2^-53 when its steps are taken in double-double, and it is rounded.
#[must_use]
pub fn error(graph: &Graph, result: Node) -> f64 {
    error_of_step(graph, result, &mut HashMap::new()) + error_model::ROUNDING.to_f64()
}

fn error_of_step(graph: &Graph, node: Node, known: &mut HashMap<Node, f64>) -> f64 {
    if graph.error(node) == 0.0 || !graph.error(node).is_finite() {
        return graph.error(node);
    }
    if let Some(&error) = known.get(&node) {
        return error;
    }
    let mut of = |node| error_of_step(graph, node, known);
    let error = match graph.op(node) {
        Op::Input(_) | Op::Literal(_) => graph.error(node),
        Op::Pi => STEP,
        Op::Neg(a) | Op::Abs(a) => of(*a),
        // the sum of what `f64` adds without cancellation does not cancel here either
        Op::Add(a, b) | Op::Sub(a, b) => of(*a).max(of(*b)) + STEP,
        Op::Mul(a, b) | Op::Div(a, b) => of(*a) + of(*b) + STEP,
        Op::Sqrt(a) => 0.5 * of(*a) + STEP,
        Op::If(_, a, b) => of(*a).max(of(*b)),
        Op::Max(items) | Op::Min(items) => items.iter().map(|&item| of(item)).fold(0.0, f64::max),
        Op::Compensated(_) => COMPENSATED,
        Op::Residual(_) | Op::PositiveRoot(_) => f64::INFINITY,
    };
    known.insert(node, error);
    error
}
