//! Candidates: programs for the same results, which are made beside each other and compared by their errors.

use crate::program::{Graph, Node, Op, rules_reached};
use closedform_arith::error_model;
use closedform_syntax::Precision;
use std::collections::{BTreeSet, HashMap};

/// A program for the results of a kernel.
#[derive(Clone)]
pub struct Candidate {
    /// Its steps.
    pub graph: Graph,
    /// Its results, in order.
    pub outputs: Vec<Node>,
    /// What its steps are taken in.
    pub precision: Precision,
}

/// What a step in double-double adds to a relative error, in units of 2^-53.
const STEP: f64 = error_model::DOUBLE_DOUBLE_STEP.to_f64();

/// How far a `compensated!` expression may be off that is not rounded, in units of 2^-53.
const COMPENSATED: f64 = error_model::COMPENSATED_IN_DOUBLE_DOUBLE.to_f64();

impl Candidate {
    /// A program in `f64`.
    #[must_use]
    pub fn new(graph: Graph, outputs: Vec<Node>) -> Self {
        Self { graph, outputs, precision: Precision::Double }
    }

    /// A bound of the relative error of a result, in units of 2^-53, barring overflow and underflow.
    #[must_use]
    pub fn error(&self, output: Node) -> f64 {
        match self.precision {
            Precision::Double => self.graph.error(output),
            Precision::DoubleDouble | Precision::Certified => error_in_double_double(&self.graph, output),
        }
    }

    /// The largest error of a result.
    #[must_use]
    pub fn worst_error(&self) -> f64 {
        self.outputs.iter().map(|&output| self.error(output)).fold(0.0, f64::max)
    }

    /// The names of the rules that made its steps, and those that some conditions need.
    #[must_use]
    pub fn rules(&self, conditions: &[Node]) -> BTreeSet<&'static str> {
        rules_reached(&self.graph, self.outputs.iter().chain(conditions).copied())
    }
}

/// The relative error of a result in units of 2^-53 when its steps are taken in double-double, and it is rounded.
fn error_in_double_double(graph: &Graph, result: Node) -> f64 {
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
        Op::Neg(a) => of(*a),
        // the sum of what `f64` adds without cancellation does not cancel here either
        Op::Add(a, b) | Op::Sub(a, b) => of(*a).max(of(*b)) + STEP,
        Op::Mul(a, b) | Op::Div(a, b) => of(*a) + of(*b) + STEP,
        Op::Call(function, a) => function.carried(of(*a)) + if function.is_exact() { 0.0 } else { STEP },
        Op::If(_, a, b) => of(*a).max(of(*b)),
        Op::Max(items) | Op::Min(items) => items.iter().map(|&item| of(item)).fold(0.0, f64::max),
        Op::Compensated(_) => COMPENSATED,
        Op::Residual(_) | Op::PositiveRoot(_) => f64::INFINITY,
    };
    known.insert(node, error);
    error
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Sign;
    use closedform_syntax::Function;

    #[test]
    fn errors_of_factors_add_up_in_double_double_too() {
        let mut graph = Graph::default();
        let roots = [0, 1].map(|index| {
            let input = graph.input(index, Sign::POSITIVE);
            graph.call(Function::Sqrt, input)
        });
        let product = graph.mul(roots[0], roots[1]);
        let sum = graph.add(roots[0], roots[1]);
        let made = Candidate { precision: Precision::DoubleDouble, ..Candidate::new(graph, vec![product, sum]) };
        // two roots and what joins them; the larger of two roots, and what joins them
        assert!(made.error(product) > made.error(sum));
    }
}
