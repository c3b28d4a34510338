//! What a program costs: its operations, counted once however often a step is used.

use super::reach::reached;
use super::{CompensatedExpr, Graph, Node, Op};

/// Operation counts of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Roots of numbers.
    pub roots: usize,
    /// Double-double operations.
    pub double_double: usize,
}

/// The cost of everything that some nodes need.
#[must_use]
pub fn cost(graph: &Graph, nodes: &[Node]) -> Cost {
    let mut cost = Cost::default();
    for node in reached(graph, nodes.iter().copied()) {
        match graph.op(node) {
            Op::Add(..) | Op::Sub(..) => cost.additions += 1,
            Op::Mul(..) => cost.multiplications += 1,
            Op::Div(..) => cost.divisions += 1,
            Op::Call(function, _) if !function.is_exact() => cost.roots += 1,
            Op::Compensated(expression) | Op::Residual(expression) => cost.double_double += operations(expression),
            Op::Input(_) | Op::Literal(_) | Op::Pi | Op::Neg(_) | Op::Call(..) | Op::If(..) => {}
            Op::Max(_) | Op::Min(_) | Op::PositiveRoot(_) => {}
        }
    }
    cost
}

fn operations(expression: &CompensatedExpr) -> usize {
    match expression {
        CompensatedExpr::Leaf(_) => 0,
        CompensatedExpr::Neg(a) => operations(a),
        CompensatedExpr::Add(a, b) | CompensatedExpr::Sub(a, b) | CompensatedExpr::Mul(a, b) => {
            1 + operations(a) + operations(b)
        }
    }
}
