//! Rule `distributed`: a factor goes into a sum whose terms take it without a rounding of their own.

use super::fused;
use super::products::{fits, in_order};
use crate::program::{CompensatedExpr, Graph, Node, Op};
use crate::stable::rule::Rule;

/// The rule.
pub const RULE: Rule = Rule {
    name: "distributed",
    statement: "p*(q*r + s) = (p*q)*r + p*s, where p*q and p*s are fused",
    condition: "p, q and s are polynomials of the inputs, p has one sign, the sum does not cancel, and it saves roundings",
};

/// The product of two steps with one of them in the sum that the other one is, if that has fewer roundings.
pub fn product(graph: &mut Graph, a: Node, b: Node) -> Option<Node> {
    let product = graph.mul(a, b);
    let found = [(a, b), (b, a)].into_iter().find_map(|(factor, sum)| inside(graph, factor, sum));
    let found = found.filter(|found| found.error < graph.error(product))?;
    let node = graph.with_error(found.node, graph.sign(product), found.error);
    for expression in found.expressions {
        if matches!(graph.op(expression), Op::Compensated(_)) {
            fused::mark(graph, expression);
        }
    }
    graph.mark(node, RULE.name);
    graph.replace(product, node);
    Some(node)
}

/// The sum with the factor in it.
struct Inside {
    node: Node,
    error: f64,
    expressions: [Node; 2],
}

fn inside(graph: &mut Graph, factor: Node, sum: Node) -> Option<Inside> {
    let (Op::Add(x, y) | Op::Sub(x, y)) = *graph.op(sum) else { return None };
    if !graph.error(sum).is_finite() || !graph.sign(factor).is_definite() {
        return None;
    }
    let ((one, left), (other, right)) = (times(graph, factor, x)?, times(graph, factor, y)?);
    let node = if matches!(graph.op(sum), Op::Add(..)) { graph.add(left, right) } else { graph.sub(left, right) };
    Some(Inside { node, error: graph.error(left).max(graph.error(right)) + 1.0, expressions: [one, other] })
}

/// What takes the factor, a polynomial in the term, and the term with it.
fn times(graph: &mut Graph, factor: Node, term: Node) -> Option<(Node, Node)> {
    if let Some(product) = fused_product(graph, factor, term) {
        return Some(product);
    }
    match *graph.op(term) {
        Op::Mul(u, v) => {
            let (taking, rest) = if graph.polynomial(u).is_some() { (u, v) } else { (v, u) };
            let (expression, product) = fused_product(graph, factor, taking)?;
            Some((expression, graph.mul(product, rest)))
        }
        Op::Call(function, _) if !function.is_exact() => Some((factor, graph.mul(factor, term))),
        _ => None,
    }
}

fn fused_product(graph: &mut Graph, a: Node, b: Node) -> Option<(Node, Node)> {
    let expression = CompensatedExpr::Mul(graph.polynomial(a)?.into(), graph.polynomial(b)?.into());
    let sign = graph.sign(a) * graph.sign(b);
    fits(&expression).then(|| in_order(graph, expression, sign))
}
