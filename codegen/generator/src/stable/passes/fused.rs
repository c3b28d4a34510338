//! Rule `fused`: a polynomial of the inputs that takes several roundings becomes one compensated expression.

use super::products::{fits, in_order};
use super::{Pass, Product};
use crate::program::{CompensatedExpr, Condition, Graph, Node, Op};
use crate::stable::candidate::Candidate;
use crate::stable::comparison::compared_with_zero;
use crate::stable::rule::Rule;
use num_traits::Zero;
use std::collections::HashMap;

/// The rule.
pub const RULE: Rule = Rule {
    name: "fused",
    statement: "steps that make a polynomial of the inputs are evaluated in pairs of f64 and rounded once",
    condition: "a result of the kernel would be off by more than 4.5 ulp otherwise, or few roundings are asked for: it costs time",
};

/// A bound that is small enough, in units of 2^-53.
pub const ENOUGH: f64 = 4.5;

/// Takes polynomials of many roundings as compensated expressions.
pub struct Fused {
    /// Whether it is done however few roundings the results have.
    pub always: bool,
    /// How products of what is fused are made.
    pub product: Product,
}

impl Pass for Fused {
    fn apply(&self, candidate: &Candidate) -> Option<Candidate> {
        if candidate.worst_error() <= ENOUGH && !self.always {
            return None;
        }
        let mut made = candidate.clone();
        let mut walk = Walk { graph: &mut made.graph, product: self.product, known: HashMap::new() };
        made.outputs = candidate.outputs.iter().map(|&output| walk.fused(output)).collect();
        Some(made)
    }
}

/// Records that a compensated expression is fused.
pub fn mark(graph: &mut Graph, expression: Node) {
    graph.mark(expression, RULE.name);
    graph.fuse(expression);
}

/// The polynomial of a step that takes more than one rounding.
fn compensated_expression(graph: &Graph, node: Node) -> Option<CompensatedExpr> {
    // what is one rounding from exact gains nothing
    let worth = graph.error(node) > 1.5;
    graph.polynomial(node).filter(|expression| worth && fits(expression))
}

/// A walk over the steps, each of which is fused once.
struct Walk<'g> {
    graph: &'g mut Graph,
    product: Product,
    known: HashMap<Node, Node>,
}

impl Walk<'_> {
    fn fused(&mut self, node: Node) -> Node {
        if let Some(&done) = self.known.get(&node) {
            return done;
        }
        let done = match compensated_expression(self.graph, node) {
            Some(expression) => {
                let sign = self.graph.sign(node);
                let (expression, value) = in_order(self.graph, expression, sign);
                mark(self.graph, expression);
                self.graph.replace(node, expression);
                value
            }
            None => self.in_parts(node),
        };
        self.known.insert(node, done);
        done
    }

    fn in_parts(&mut self, node: Node) -> Node {
        let made = match self.graph.op(node).clone() {
            Op::Neg(a) => {
                let a = self.fused(a);
                self.graph.neg(a)
            }
            Op::Call(function, a) => {
                let a = self.fused(a);
                self.graph.call(function, a)
            }
            Op::Add(a, b) => {
                let [a, b] = self.terms([a, b]);
                let sum = self.graph.add(a, b);
                self.uncancelled(sum, [a, b], node)
            }
            Op::Sub(a, b) => {
                let [a, b] = self.terms([a, b]);
                let difference = self.graph.sub(a, b);
                self.uncancelled(difference, [a, b], node)
            }
            Op::Mul(a, b) => {
                let (a, b) = (self.fused(a), self.fused(b));
                (self.product)(self.graph, a, b).unwrap_or_else(|| self.graph.mul(a, b))
            }
            Op::Div(a, b) => {
                let (a, b) = (self.fused(a), self.fused(b));
                self.graph.div(a, b)
            }
            Op::If(condition, a, b) => {
                let condition = self.decided(condition);
                let (a, b) = (self.fused(a), self.fused(b));
                self.graph.select(condition, a, b)
            }
            _ => return node,
        };
        let sign = self.graph.sign(node);
        self.graph.learn(made, sign);
        let rules = self.graph.rules(node).to_vec();
        rules.into_iter().for_each(|rule| self.graph.mark(made, rule));
        made
    }

    /// The terms of a sum, fused where that makes the larger of their errors less.
    fn terms(&mut self, plain: [Node; 2]) -> [Node; 2] {
        let [a, b] = plain.map(|term| self.fused(term));
        let needed = |plain: Node, fused: Node, other: Node| {
            if self.graph.error(plain) <= self.graph.error(other) { plain } else { fused }
        };
        [needed(plain[0], a, b), needed(plain[1], b, a)]
    }

    /// The condition on what is fused, so that nothing is computed twice.
    fn decided(&mut self, condition: Condition) -> Condition {
        match condition {
            Condition::Compare(a, order, b) => {
                let (a, b) = (self.fused(a), self.fused(b));
                let with_zero = self.graph.literal(b).is_some_and(Zero::is_zero);
                if with_zero { compared_with_zero(self.graph, a, order) } else { Condition::Compare(a, order, b) }
            }
            Condition::And(a, b) => Condition::And(self.decided(*a).into(), self.decided(*b).into()),
            Condition::Or(a, b) => Condition::Or(self.decided(*a).into(), self.decided(*b).into()),
            Condition::Not(inner) => Condition::Not(self.decided(*inner).into()),
        }
    }

    /// A sum that does not cancel, because the sum of the same terms that it stands for does not.
    fn uncancelled(&mut self, sum: Node, terms: [Node; 2], before: Node) -> Node {
        let graph = &mut *self.graph;
        if graph.error(sum).is_finite() || !graph.error(before).is_finite() {
            return sum;
        }
        let error = terms.map(|term| graph.error(term)).into_iter().fold(0.0, f64::max) + 1.0;
        graph.with_error(sum, graph.sign(before), error)
    }
}
