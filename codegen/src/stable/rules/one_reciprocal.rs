//! Rule `one-reciprocal`: quotients whose denominators have factors in common share one division.

use super::Rule;
use crate::program::{Graph, Node, Op};
use crate::stable::builder::Builder;
use num_rational::BigRational;
use num_traits::One;
use std::collections::BTreeMap;

/// The rule.
pub const RULE: Rule = Rule {
    name: "one-reciprocal",
    statement: "a/p, b/q, .. = a*(d/p)*r, b*(d/q)*r, .. where d is the least common multiple of p, q, .. and r = 1/d",
    condition: "the contract asks for one division: it costs each result the roundings of d/p and r",
};

/// The powers of the factors of a product.
type Factors = BTreeMap<Node, usize>;

/// The results, those that are quotients through one reciprocal.
pub fn apply(builder: &mut Builder, results: &[Node]) -> Vec<Node> {
    let graph = &mut builder.graph;
    let quotients: Vec<Option<(Node, Node)>> = results.iter().map(|&result| quotient(graph, result)).collect();
    let mut common = Factors::new();
    for (_, denominator) in quotients.iter().flatten() {
        for (factor, power) in factors(graph, *denominator) {
            let largest = common.entry(factor).or_default();
            *largest = power.max(*largest);
        }
    }
    if quotients.iter().flatten().count() < 2 {
        return results.to_vec();
    }
    let one = graph.constant(&BigRational::one());
    let whole = product(graph, &common).unwrap_or(one);
    let reciprocal = graph.div(one, whole);
    builder.apply(&RULE, reciprocal);
    let graph = &mut builder.graph;
    let through = |(&result, quotient): (&Node, &Option<(Node, Node)>)| match *quotient {
        None => result,
        Some((numerator, denominator)) => {
            let mut rest = common.clone();
            for (factor, power) in factors(graph, denominator) {
                rest.entry(factor).and_modify(|left| *left -= power);
            }
            let scaled = match product(graph, &rest) {
                Some(rest) => graph.mul(numerator, rest),
                None => numerator,
            };
            graph.mul(scaled, reciprocal)
        }
    };
    results.iter().zip(&quotients).map(through).collect()
}

/// Numerator and denominator.
fn quotient(graph: &mut Graph, node: Node) -> Option<(Node, Node)> {
    match *graph.op(node) {
        Op::Div(numerator, denominator) => Some((numerator, denominator)),
        Op::Neg(inner) => {
            let (numerator, denominator) = quotient(graph, inner)?;
            Some((graph.neg(numerator), denominator))
        }
        _ => None,
    }
}

fn factors(graph: &Graph, node: Node) -> Factors {
    let mut found = Factors::new();
    let mut open = vec![node];
    while let Some(node) = open.pop() {
        match *graph.op(node) {
            Op::Mul(a, b) => open.extend([a, b]),
            _ => *found.entry(node).or_default() += 1,
        }
    }
    found
}

/// `None` of no factors.
fn product(graph: &mut Graph, factors: &Factors) -> Option<Node> {
    let repeated = factors.iter().flat_map(|(&factor, &power)| std::iter::repeat_n(factor, power));
    repeated.reduce(|a, b| graph.mul(a, b))
}
