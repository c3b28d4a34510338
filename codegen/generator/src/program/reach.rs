//! What some nodes need: every step that they reach through operands.

use super::{Graph, Node};
use std::collections::BTreeSet;

/// The nodes, and everything that they need.
#[must_use]
pub fn reached(graph: &Graph, nodes: impl IntoIterator<Item = Node>) -> BTreeSet<Node> {
    closure(nodes, |node| graph.operands(node))
}

/// The names of the rules that made some nodes and everything that they need, or what these take the place of.
#[must_use]
pub fn rules_reached(graph: &Graph, nodes: impl IntoIterator<Item = Node>) -> BTreeSet<&'static str> {
    let made = closure(nodes, |node| [graph.operands(node).as_slice(), graph.origins(node)].concat());
    made.into_iter().flat_map(|node| graph.rules(node)).copied().collect()
}

fn closure(nodes: impl IntoIterator<Item = Node>, next: impl Fn(Node) -> Vec<Node>) -> BTreeSet<Node> {
    let mut found = BTreeSet::new();
    let mut open: Vec<Node> = nodes.into_iter().collect();
    while let Some(node) = open.pop() {
        if found.insert(node) {
            open.extend(next(node));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Sign;

    #[test]
    fn steps_are_reached_through_operands_and_others_are_not() {
        let mut graph = Graph::default();
        let [x, y, z] = [0, 1, 2].map(|index| graph.input(index, Sign::POSITIVE));
        let sum = graph.add(x, y);
        let root = graph.call(closedform_syntax::Function::Sqrt, sum);
        let beside = graph.mul(sum, z);
        assert_eq!(reached(&graph, [root]), BTreeSet::from([x, y, sum, root]));
        assert_eq!(reached(&graph, [root, beside]).len(), 6);
        assert!(reached(&graph, []).is_empty());
    }
    #[test]
    fn rules_of_what_was_replaced_count() {
        let mut graph = Graph::default();
        let (x, y) = (graph.input(0, Sign::POSITIVE), graph.input(1, Sign::POSITIVE));
        let (sum, product) = (graph.add(x, y), graph.mul(x, y));
        graph.mark(sum, "factored");
        let root = graph.call(closedform_syntax::Function::Sqrt, sum);
        assert!(rules_reached(&graph, [product]).is_empty());
        graph.replace(root, product);
        assert_eq!(rules_reached(&graph, [product]), BTreeSet::from(["factored"]));
    }
    #[test]
    fn rules_of_a_minus_stay_where_it_goes_into_another_step() {
        let mut graph = Graph::default();
        let (x, y) = (graph.input(0, Sign::POSITIVE), graph.input(1, Sign::POSITIVE));
        let sum = graph.add(x, y);
        let turned = graph.neg(sum);
        graph.mark(turned, "known-sum");
        let difference = graph.sub(x, turned);
        assert_eq!(rules_reached(&graph, [difference]), BTreeSet::from(["known-sum"]));
    }
}
