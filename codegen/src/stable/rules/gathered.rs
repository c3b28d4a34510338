//! Rule `gathered`: a polynomial of the inputs that takes several roundings becomes one slice.

use super::{Rule, distributed};
use crate::field::Sign;
use crate::program::{Condition, Graph, Node, Op, Wide, is_exact};
use crate::stable::builder::Builder;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
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

/// The most terms of a slice, multiplied out, and the most factors of one.
const LARGEST: (usize, usize) = (2_000, 16);

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

/// A slice of a product without its sign, and the product: one literal and then the other factors in one order, so that
/// equal slices, and those of other signs, are one step. A product of two takes one rounding anyway.
pub fn in_order(graph: &mut Graph, wide: Wide, sign: Sign) -> (Node, Node) {
    let (mut negative, mut factors) = (false, Vec::new());
    split(wide, &mut negative, &mut factors);
    let literal = |factor: &Wide| if let Wide::Leaf(leaf) = factor { graph.literal(*leaf).cloned() } else { None };
    let (literals, mut rest): (Vec<Wide>, Vec<Wide>) =
        factors.into_iter().partition(|factor| literal(factor).is_some());
    let mut constants: Vec<BigRational> = literals.iter().filter_map(literal).collect();
    negative ^= constants.iter().filter(|constant| constant.is_negative()).count() % 2 == 1;
    constants.iter_mut().for_each(|constant| *constant = constant.abs());
    let folded: BigRational = constants.iter().product();
    if is_exact(&folded) {
        constants = if folded.is_one() && !rest.is_empty() { Vec::new() } else { vec![folded] };
    }
    rest.sort_by_key(|factor| if let Wide::Leaf(leaf) = factor { leaf.0 } else { usize::MAX });
    let leading: Vec<Wide> = constants.iter().map(|constant| Wide::Leaf(graph.constant(constant))).collect();
    let product = leading.into_iter().chain(rest).reduce(|a, b| Wide::Mul(a.into(), b.into()));
    let product = product.unwrap_or_else(|| Wide::Leaf(graph.constant(&BigRational::one())));
    let slice = match two_leaves(&product) {
        Some((a, b)) => graph.mul(a, b),
        None => graph.compensated(product, if negative { -sign } else { sign }),
    };
    (slice, if negative { graph.neg(slice) } else { slice })
}

fn two_leaves(wide: &Wide) -> Option<(Node, Node)> {
    let Wide::Mul(a, b) = wide else { return None };
    let (Wide::Leaf(a), Wide::Leaf(b)) = (&**a, &**b) else { return None };
    Some((*a, *b))
}

/// The factors of a product, without their signs.
fn split(wide: Wide, negative: &mut bool, factors: &mut Vec<Wide>) {
    match wide {
        Wide::Mul(a, b) => [a, b].into_iter().for_each(|factor| split(*factor, negative, factors)),
        Wide::Neg(a) => {
            *negative = !*negative;
            split(*a, negative, factors);
        }
        factor => factors.push(factor),
    }
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
    let both = |builder: &mut Builder, a: Condition, b: Condition, known: &mut HashMap<Node, Node>| {
        [decided(builder, a, known), decided(builder, b, known)].map(Box::new)
    };
    match condition {
        Condition::Compare(a, order, b) => {
            let (a, b) = (gathered(builder, a, known), gathered(builder, b, known));
            let with_zero = builder.graph.literal(b).is_some_and(Zero::is_zero);
            if with_zero { builder.compare_with_zero(a, order) } else { Condition::Compare(a, order, b) }
        }
        Condition::And(a, b) => {
            let [a, b] = both(builder, *a, *b, known);
            Condition::And(a, b)
        }
        Condition::Or(a, b) => {
            let [a, b] = both(builder, *a, *b, known);
            Condition::Or(a, b)
        }
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

/// Whether a slice may be so large.
pub fn fits(wide: &Wide) -> bool {
    let (terms, factors) = size(wide);
    terms <= LARGEST.0 && factors <= LARGEST.1
}

/// How many terms a slice has when it is multiplied out, and how many factors the longest of them.
fn size(wide: &Wide) -> (usize, usize) {
    match wide {
        Wide::Leaf(_) => (1, 1),
        Wide::Neg(a) => size(a),
        Wide::Add(a, b) | Wide::Sub(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0 + b.0, a.1.max(b.1))
        }
        Wide::Mul(a, b) => {
            let (a, b) = (size(a), size(b));
            (a.0.saturating_mul(b.0), a.1 + b.1)
        }
    }
}
