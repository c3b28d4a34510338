//! What some nodes need: every step that they reach through operands.

use super::{Graph, Node};
use std::collections::BTreeSet;

/// The nodes, and everything that they need.
#[must_use]
pub fn reached(graph: &Graph, nodes: impl IntoIterator<Item = Node>) -> BTreeSet<Node> {
    let mut found = BTreeSet::new();
    let mut open: Vec<Node> = nodes.into_iter().collect();
    while let Some(node) = open.pop() {
        if found.insert(node) {
            open.extend(graph.operands(node));
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
        let root = graph.sqrt(sum);
        let beside = graph.mul(sum, z);
        assert_eq!(reached(&graph, [root]), BTreeSet::from([x, y, sum, root]));
        assert_eq!(reached(&graph, [root, beside]).len(), 6);
        assert!(reached(&graph, []).is_empty());
    }
}
