//! The order and the names of steps: which nodes become a `let`, and what it is called.

use super::{Graph, Node, Op};
use std::collections::{BTreeMap, BTreeSet};

/// A step with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Let {
    /// The name.
    pub name: String,
    /// The step.
    pub node: Node,
}

/// The named steps of a kernel, in order, and its results.
#[derive(Clone, Debug)]
pub struct Program {
    /// The named steps.
    pub lets: Vec<Let>,
    /// The results.
    pub outputs: Vec<Node>,
}

impl Program {
    /// The name of a node, if it has one.
    #[must_use]
    pub fn name_of(&self, node: Node) -> Option<&str> {
        self.lets.iter().find(|step| step.node == node).map(|step| step.name.as_str())
    }
}

/// Names every step that is used more than once, and those that readers look for: roots, selections, compensated
/// expressions that cancel.
#[must_use]
pub fn name_steps(graph: &Graph, outputs: &[Node], taken: &[String]) -> Program {
    let mut uses: BTreeMap<Node, usize> = BTreeMap::new();
    let mut seen = BTreeSet::new();
    for &output in outputs {
        *uses.entry(past_minus(graph, output)).or_default() += 1;
        count_uses(graph, output, &mut uses, &mut seen);
    }
    let mut names = Names::new(taken);
    let lets = uses
        .iter()
        .filter(|&(&node, &count)| deserves_name(graph, node, count, outputs))
        .map(|(&node, _)| Let { name: names.fresh(stem(graph, node)), node })
        .collect();
    Program { lets, outputs: outputs.to_vec() }
}

fn count_uses(graph: &Graph, node: Node, uses: &mut BTreeMap<Node, usize>, seen: &mut BTreeSet<Node>) {
    if !seen.insert(node) {
        return;
    }
    for operand in graph.operands(node) {
        let operand = past_minus(graph, operand);
        *uses.entry(operand).or_default() += 1;
        count_uses(graph, operand, uses, seen);
    }
}

/// A minus has no name of its own: what it stands before counts as used.
fn past_minus(graph: &Graph, node: Node) -> Node {
    match *graph.op(node) {
        Op::Neg(inner) => inner,
        _ => node,
    }
}

fn deserves_name(graph: &Graph, node: Node, uses: usize, outputs: &[Node]) -> bool {
    let only_result = uses == 1 && outputs.contains(&node);
    match graph.op(node) {
        Op::Input(_) | Op::Literal(_) | Op::Pi | Op::Neg(_) => false,
        Op::Call(function, _) if !function.is_exact() => !only_result,
        Op::If(..) | Op::Compensated(_) | Op::Residual(_) | Op::PositiveRoot(_) => !only_result,
        _ => uses > 1,
    }
}

fn stem(graph: &Graph, node: Node) -> &'static str {
    match graph.op(node) {
        Op::Input(_) | Op::Literal(_) | Op::Pi | Op::Neg(_) => "value",
        Op::Add(..) => "sum",
        Op::Sub(..) => "difference",
        Op::Mul(..) => "product",
        Op::Div(..) => "quotient",
        // their nouns are names of functions
        Op::Call(function, _) if function.has_steps() => "whole",
        Op::Call(function, _) => last_word(function.properties().noun),
        Op::If(..) => "chosen",
        Op::Compensated(_) if graph.is_fused(node) => "polynomial",
        Op::Compensated(_) => "cancelling",
        Op::Residual(_) => "remainder",
        Op::Max(_) => "largest",
        Op::Min(_) => "smallest",
        Op::PositiveRoot(_) => "start",
    }
}

/// The word that says what something is: of a square root, that it is a root.
fn last_word(noun: &'static str) -> &'static str {
    noun.rsplit(' ').next().unwrap_or(noun)
}

/// Names that are neither inputs nor given out before.
struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    fn new(taken: &[String]) -> Self {
        Self { taken: taken.iter().cloned().collect() }
    }

    fn fresh(&mut self, stem: &str) -> String {
        let mut name = stem.to_owned();
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{stem}{number}");
            number += 1;
        }
        name
    }
}
