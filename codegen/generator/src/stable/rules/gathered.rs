//! Rule `gathered`: a polynomial of the inputs that takes several roundings becomes one slice.

use super::{Rule, distributed};
use crate::program::{Condition, Graph, Node, Op, Wide};
use crate::stable::builder::Builder;
use crate::stable::slices::{fits, in_order};
use num_traits::Zero;
use std::collections::HashMap;

/// The rule.
pub const RULE: Rule = Rule {
    name: "gathered",
    statement: "steps that make a polynomial of the inputs are evaluated in double-double and rounded once",
    condition: "a result of the kernel would have a bound of more than 4.5 ulp otherwise, or the contract asks for few \
                roundings: it costs time",
};

/// A bound that is small enough, in units of 2^-53.
pub const ENOUGH: f64 = 4.5;

/// The results, those with many roundings by slices.
pub fn apply(builder: &mut Builder, results: &[Node], few_roundings: bool) -> Vec<Node> {
    let worst = results.iter().map(|&result| builder.graph.error(result)).fold(0.0, f64::max);
    if worst <= ENOUGH && !few_roundings {
        return results.to_vec();
    }
    let mut known = HashMap::new();
    results.iter().map(|&result| gathered(builder, result, &mut known)).collect()
}

/// The error of a result, in units of 2^-53, once it is gathered.
pub fn error(builder: &mut Builder, result: Node) -> f64 {
    let gathered = gathered(builder, result, &mut HashMap::new());
    builder.graph.error(gathered)
}

fn gathered(builder: &mut Builder, node: Node, known: &mut HashMap<Node, Node>) -> Node {
    if let Some(&done) = known.get(&node) {
        return done;
    }
    let done = match slice(&builder.graph, node) {
        Some(wide) => {
            let sign = builder.graph.sign(node);
            let (slice, value) = in_order(&mut builder.graph, wide, sign);
            builder.apply(&RULE, slice);
            value
        }
        None => in_parts(builder, node, known),
    };
    known.insert(node, done);
    done
}

/// The polynomial of a step that takes more than one rounding.
fn slice(graph: &Graph, node: Node) -> Option<Wide> {
    // what is one rounding from exact gains nothing
    let worth = graph.error(node) > 1.5 && !matches!(graph.op(node), Op::Compensated(_));
    graph.polynomial(node).filter(|wide| worth && fits(wide))
}

fn in_parts(builder: &mut Builder, node: Node, known: &mut HashMap<Node, Node>) -> Node {
    let made = match builder.graph.op(node).clone() {
        Op::Neg(a) => {
            let a = gathered(builder, a, known);
            builder.graph.neg(a)
        }
        Op::Sqrt(a) => {
            let a = gathered(builder, a, known);
            builder.graph.sqrt(a)
        }
        Op::Abs(a) => {
            let a = gathered(builder, a, known);
            builder.graph.abs(a)
        }
        Op::Add(a, b) => {
            let [a, b] = terms(builder, [a, b], known);
            let sum = builder.graph.add(a, b);
            uncancelled(builder, sum, [a, b], node)
        }
        Op::Sub(a, b) => {
            let [a, b] = terms(builder, [a, b], known);
            let difference = builder.graph.sub(a, b);
            uncancelled(builder, difference, [a, b], node)
        }
        Op::Mul(a, b) => {
            let (a, b) = (gathered(builder, a, known), gathered(builder, b, known));
            distributed::apply(builder, a, b).unwrap_or_else(|| builder.graph.mul(a, b))
        }
        Op::Div(a, b) => {
            let (a, b) = (gathered(builder, a, known), gathered(builder, b, known));
            builder.graph.div(a, b)
        }
        Op::If(condition, a, b) => {
            let condition = decided(builder, condition, known);
            let (a, b) = (gathered(builder, a, known), gathered(builder, b, known));
            builder.graph.select(condition, a, b)
        }
        _ => return node,
    };
    let sign = builder.graph.sign(node);
    builder.graph.learn(made, sign);
    let rules = builder.graph.rules(node).to_vec();
    rules.into_iter().for_each(|rule| builder.graph.mark(made, rule));
    made
}

/// The terms of a sum, gathered where that makes the larger of their errors less.
fn terms(builder: &mut Builder, plain: [Node; 2], known: &mut HashMap<Node, Node>) -> [Node; 2] {
    let [a, b] = plain.map(|term| gathered(builder, term, known));
    let needed = |plain: Node, gathered: Node, other: Node| {
        if builder.graph.error(plain) <= builder.graph.error(other) { plain } else { gathered }
    };
    [needed(plain[0], a, b), needed(plain[1], b, a)]
}

/// The condition on what is gathered, so that nothing is computed twice.
fn decided(builder: &mut Builder, condition: Condition, known: &mut HashMap<Node, Node>) -> Condition {
    match condition {
        Condition::Compare(a, order, b) => {
            let (a, b) = (gathered(builder, a, known), gathered(builder, b, known));
            let with_zero = builder.graph.literal(b).is_some_and(Zero::is_zero);
            if with_zero { builder.compare_with_zero(a, order) } else { Condition::Compare(a, order, b) }
        }
        Condition::And(a, b) => Condition::And(decided(builder, *a, known).into(), decided(builder, *b, known).into()),
        Condition::Or(a, b) => Condition::Or(decided(builder, *a, known).into(), decided(builder, *b, known).into()),
        Condition::Not(inner) => Condition::Not(decided(builder, *inner, known).into()),
    }
}

/// A sum that does not cancel, because the sum of the same terms that it stands for does not.
fn uncancelled(builder: &mut Builder, sum: Node, terms: [Node; 2], before: Node) -> Node {
    let graph = &mut builder.graph;
    if graph.error(sum).is_finite() || !graph.error(before).is_finite() {
        return sum;
    }
    let error = terms.map(|term| graph.error(term)).into_iter().fold(0.0, f64::max) + 1.0;
    graph.with_error(sum, graph.sign(before), error)
}
