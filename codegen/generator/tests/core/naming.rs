//! Names: every step that is shared has one, and no two of them, nor one of them and an input, are the same.

use super::graphs::{INPUTS, graph, steps};
use super::values::cases;
use closedform_generator::field::Sign;
use closedform_generator::program::{Graph, Node, Op, name_steps};
use closedform_syntax::Function;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Inputs that are called as steps would be.
const TAKEN: [&str; 8] = ["sum", "product", "root", "difference2", "quotient", "cancelling", "magnitude", "largest"];

/// How often each node is used by those that some outputs need, once for each step that uses it.
fn uses(graph: &Graph, outputs: &[Node]) -> BTreeMap<Node, usize> {
    let mut uses: BTreeMap<Node, usize> = outputs.iter().map(|&output| (output, 0)).collect();
    let mut open: Vec<Node> = uses.keys().copied().collect();
    while let Some(node) = open.pop() {
        for operand in graph.operands(node) {
            let known = uses.contains_key(&operand);
            *uses.entry(operand).or_default() += 1;
            if !known {
                open.push(operand);
            }
        }
    }
    uses
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn names_do_not_clash(steps in steps()) {
        let (graph, nodes) = graph([Sign::POSITIVE; INPUTS], &steps);
        let outputs = &nodes[nodes.len().saturating_sub(3)..];
        let taken = TAKEN.map(str::to_owned);
        let program = name_steps(&graph, outputs, &taken);
        let names: Vec<&str> = program.lets.iter().map(|step| step.name.as_str()).collect();
        prop_assert_eq!(names.iter().chain(&TAKEN).collect::<BTreeSet<_>>().len(), names.len() + TAKEN.len());
        prop_assert!(program.lets.windows(2).all(|pair| pair[0].node < pair[1].node), "operands come first");
        prop_assert_eq!(&program.outputs[..], outputs);
        for (node, count) in uses(&graph, outputs) {
            let trivial = matches!(graph.op(node), Op::Input(_) | Op::Literal(_) | Op::Pi | Op::Neg(_));
            prop_assert!(program.name_of(node).is_none() || !trivial);
            prop_assert!(count < 2 || trivial || program.name_of(node).is_some(), "{:?}", graph.op(node));
        }
    }
}

#[test]
fn names_say_what_a_step_is() {
    let mut graph = Graph::default();
    let [x, y] = [0, 1].map(|index| graph.input(index, Sign::POSITIVE));
    let sum = graph.add(x, y);
    let root = graph.call(Function::Sqrt, sum);
    let product = graph.mul(root, sum);
    let program = name_steps(&graph, &[product], &["sum".to_owned()]);
    assert_eq!(program.name_of(sum), Some("sum2"));
    assert_eq!(program.name_of(root), Some("root"));
    assert_eq!(program.name_of(product), None, "a result that nothing else uses");
}
