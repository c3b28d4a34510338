//! What a program knows of the signs of its steps, against their values.

use super::BITS;
use closedform_generator::field::Sign;
use closedform_generator::program::{CompensatedExpr, Condition, Graph, Node, Op, reached};
use num_bigint::BigInt;
use num_rational::BigRational;
use rug::float::Constant;
use rug::{Float, Integer};
use std::cmp::Ordering;
use std::collections::HashMap;

/// A step on the way to the results whose value at a point is not of the sign that the program knows of it, if there is
/// one. Behind the root of a polynomial nothing is looked at.
pub fn wrong_sign(graph: &Graph, results: &[Node], point: &[f64]) -> Option<String> {
    let mut walk = Walk { graph, point, known: HashMap::new() };
    results.iter().for_each(|&result| _ = walk.value(result));
    let wrong = |(&node, value): (&Node, &Option<Float>)| {
        let (value, sign) = (value.as_ref()?, graph.sign(node));
        let wrong = !sign_of(value).is(sign);
        wrong.then(|| format!("{:?} has the value {value:.6e}, not {sign}, at {point:?}", graph.op(node)))
    };
    walk.known.iter().find_map(wrong)
}

/// A compensated expression of a form that is positive nowhere, if there is one: of p and -p, both share the positive one.
pub fn turned(graph: &Graph, results: &[Node]) -> Option<String> {
    let of_a_form = |node: &Node| matches!(graph.op(*node), Op::Compensated(_)) && !graph.is_fused(*node);
    let steps = reached(graph, results.iter().copied()).into_iter();
    let turned = steps.filter(of_a_form).find(|&node| graph.sign(node).is(Sign::NONPOSITIVE));
    turned.map(|node| format!("{:?} is never positive", graph.op(node)))
}

/// The sign of a value; what has cancelled to nothing is zero.
fn sign_of(value: &Float) -> Sign {
    if value.clone().abs() < 1e-100 {
        Sign::ZERO
    } else if value.is_sign_negative() {
        Sign::NEGATIVE
    } else {
        Sign::POSITIVE
    }
}

/// The steps that are taken at a point: of an `if` the side that is chosen.
struct Walk<'g> {
    graph: &'g Graph,
    point: &'g [f64],
    known: HashMap<Node, Option<Float>>,
}

impl Walk<'_> {
    fn value(&mut self, node: Node) -> Option<Float> {
        if let Some(known) = self.known.get(&node) {
            return known.clone();
        }
        let value = self.taken(node).filter(Float::is_finite);
        self.known.insert(node, value.clone());
        value
    }

    fn taken(&mut self, node: Node) -> Option<Float> {
        Some(match self.graph.op(node).clone() {
            Op::Input(at) => Float::with_val(BITS, self.point[at]),
            Op::Literal(number) => quotient(&number),
            Op::Pi => Float::with_val(BITS, Constant::Pi),
            Op::Neg(a) => -self.value(a)?,
            Op::Add(a, b) => self.value(a)? + self.value(b)?,
            Op::Sub(a, b) => self.value(a)? - self.value(b)?,
            Op::Mul(a, b) => self.value(a)? * self.value(b)?,
            Op::Div(a, b) => self.value(a)? / self.value(b)?,
            Op::Call(function, a) => {
                let mut value = self.value(a)?;
                function.mpfr(&mut value);
                value
            }
            Op::If(condition, then, otherwise) => {
                let side = if self.holds(&condition)? { then } else { otherwise };
                self.value(side)?
            }
            Op::Max(items) => self.extreme(&items, Ordering::Greater)?,
            Op::Min(items) => self.extreme(&items, Ordering::Less)?,
            Op::Compensated(expression) => self.compensated(&expression)?,
            Op::Residual(_) | Op::PositiveRoot(_) => return None,
        })
    }

    fn extreme(&mut self, items: &[Node], wanted: Ordering) -> Option<Float> {
        let values: Option<Vec<Float>> = items.iter().map(|&item| self.value(item)).collect();
        values?.into_iter().reduce(|a, b| if a.partial_cmp(&b) == Some(wanted) { a } else { b })
    }

    fn holds(&mut self, condition: &Condition) -> Option<bool> {
        Some(match condition {
            Condition::Compare(a, relation, b) => {
                let difference = self.value(*a)? - self.value(*b)?;
                sign_of(&difference).is(Sign::of_relation(*relation))
            }
            Condition::And(a, b) => self.holds(a)? && self.holds(b)?,
            Condition::Or(a, b) => self.holds(a)? || self.holds(b)?,
            Condition::Not(a) => !self.holds(a)?,
        })
    }

    fn compensated(&mut self, expression: &CompensatedExpr) -> Option<Float> {
        Some(match expression {
            CompensatedExpr::Leaf(node) => self.value(*node)?,
            CompensatedExpr::Neg(a) => -self.compensated(a)?,
            CompensatedExpr::Add(a, b) => self.compensated(a)? + self.compensated(b)?,
            CompensatedExpr::Sub(a, b) => self.compensated(a)? - self.compensated(b)?,
            CompensatedExpr::Mul(a, b) => self.compensated(a)? * self.compensated(b)?,
        })
    }
}

fn quotient(number: &BigRational) -> Float {
    let integer = |value: &BigInt| value.to_string().parse::<Integer>().expect("the digits of an integer");
    Float::with_val(BITS, integer(number.numer())) / integer(number.denom())
}
