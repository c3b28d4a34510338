//! The graph of steps: equal steps are one node, and each knows its sign and a bound of its relative error.

use super::constant::{beyond_literals, is_exact, is_power_of_two, leading_bits};
use super::op::{CompensatedExpr, Condition, Node, Op};
use crate::field::Sign;
use closedform_arith::error_model;
use closedform_syntax::Function;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::HashMap;

#[derive(Clone, Debug)]
struct Step {
    op: Op,
    sign: Sign,
    error: f64,
    rules: Vec<&'static str>,
    fused: bool,
    origins: Vec<Node>,
}

/// The steps of a kernel.
#[derive(Clone, Default)]
pub struct Graph {
    steps: Vec<Step>,
    index: HashMap<Op, Node>,
}

/// What a rounding to nearest adds to a relative error, in units of 2^-53.
const ROUNDING: f64 = error_model::ROUNDING.to_f64();

/// How far a `compensated!` expression may be off, in units of 2^-53.
const COMPENSATED: f64 = error_model::COMPENSATED.to_f64();

impl Graph {
    /// What a node does.
    #[must_use]
    pub fn op(&self, node: Node) -> &Op {
        &self.steps[node.0].op
    }

    /// The sign of a node on the domain.
    #[must_use]
    pub fn sign(&self, node: Node) -> Sign {
        self.steps[node.0].sign
    }

    /// A bound of the relative error of a node, in units of 2^-53, barring overflow and underflow.
    #[must_use]
    pub fn error(&self, node: Node) -> f64 {
        self.steps[node.0].error
    }

    /// The rules that made a node, in the order of their use.
    #[must_use]
    pub fn rules(&self, node: Node) -> &[&'static str] {
        &self.steps[node.0].rules
    }

    /// Records that a rule made a node.
    pub fn mark(&mut self, node: Node, rule: &'static str) {
        let rules = &mut self.steps[node.0].rules;
        if !rules.contains(&rule) {
            rules.push(rule);
        }
        // a minus may go into another step: what it stands before is made by the rule too
        if let Op::Neg(inner) = *self.op(node) {
            self.replace(node, inner);
        }
    }

    /// Records that a node stands for several steps, fused into one rounding.
    pub fn fuse(&mut self, node: Node) {
        self.steps[node.0].fused = true;
    }

    /// Whether a node stands for several steps, fused into one rounding.
    #[must_use]
    pub fn is_fused(&self, node: Node) -> bool {
        self.steps[node.0].fused
    }

    /// Records that a node takes the place of another one, whose rules have made it too.
    pub fn replace(&mut self, origin: Node, node: Node) {
        self.steps[node.0].origins.push(origin);
    }

    /// The nodes whose place a node takes.
    #[must_use]
    pub fn origins(&self, node: Node) -> &[Node] {
        &self.steps[node.0].origins
    }

    fn push(&mut self, op: Op, sign: Sign, error: f64) -> Node {
        let known = self.index.get(&op).or_else(|| self.index.get(&op.swapped()?));
        if let Some(&node) = known {
            let step = &mut self.steps[node.0];
            step.sign = step.sign & sign;
            step.error = step.error.min(error);
            return node;
        }
        let node = Node(self.steps.len());
        self.index.insert(op.clone(), node);
        self.steps.push(Step { op, sign, error, rules: Vec::new(), fused: false, origins: Vec::new() });
        node
    }

    /// Intersects what is known of a node's sign.
    pub fn learn(&mut self, node: Node, sign: Sign) {
        self.steps[node.0].sign = self.steps[node.0].sign & sign;
    }

    /// An input.
    pub fn input(&mut self, index: usize, sign: Sign) -> Node {
        self.push(Op::Input(index), sign, 0.0)
    }

    /// The circle constant, rounded.
    pub fn pi(&mut self) -> Node {
        self.push(Op::Pi, Sign::POSITIVE, ROUNDING)
    }

    /// A constant, as a literal where `f64` holds it exactly and as a quotient of literals otherwise.
    pub fn constant(&mut self, value: &BigRational) -> Node {
        if is_exact(value) {
            return self.push(Op::Literal(value.clone()), Sign::of(value), 0.0);
        }
        let numerator = self.integer_constant(&BigRational::from_integer(value.numer().clone()));
        let denominator = self.integer_constant(&BigRational::from_integer(value.denom().clone()));
        self.div(numerator, denominator)
    }

    /// An integer of any size: one beyond 53 bits is a sum.
    fn integer_constant(&mut self, value: &BigRational) -> Node {
        if is_exact(value) {
            return self.push(Op::Literal(value.clone()), Sign::of(value), 0.0);
        }
        let (leading, rest) = match leading_bits(value) {
            Some(leading) => (self.integer_constant(&leading), value - leading),
            None => self.beyond_literals(value),
        };
        if rest.is_zero() {
            return leading;
        }
        let rest = self.integer_constant(&rest);
        let sum = self.add(leading, rest);
        self.learn(sum, Sign::of(value));
        sum
    }

    /// The leading part of an integer that no literal reaches, as a product with a power of two, and the rest.
    fn beyond_literals(&mut self, value: &BigRational) -> (Node, BigRational) {
        let (step, high, rest) = beyond_literals(value);
        let (step, high) = (self.integer_constant(&step), self.integer_constant(&high));
        (self.push(Op::Mul(step, high), Sign::of(value), self.error(high)), rest)
    }

    /// The value of a literal.
    #[must_use]
    pub fn literal(&self, node: Node) -> Option<&BigRational> {
        match self.op(node) {
            Op::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// The negative, without a step where another sign of the operands does it.
    pub fn neg(&mut self, a: Node) -> Node {
        match self.op(a).clone() {
            Op::Literal(value) => self.constant(&-value),
            Op::Neg(inner) => inner,
            Op::Mul(x, y) if self.leads_with_literal(x) || self.begins_with_minus(a) => {
                let turned = self.neg(x);
                self.mul(turned, y)
            }
            Op::Div(x, y) if self.begins_with_minus(x) => {
                let turned = self.neg(x);
                self.div(turned, y)
            }
            Op::Sub(x, y) => {
                let turned = self.sub(y, x);
                self.with_error(turned, -self.sign(a), self.error(a))
            }
            _ => self.push(Op::Neg(a), -self.sign(a), self.error(a)),
        }
    }

    fn leads_with_literal(&self, node: Node) -> bool {
        match *self.op(node) {
            Op::Literal(_) => true,
            Op::Mul(first, _) => self.leads_with_literal(first),
            _ => false,
        }
    }

    /// The sum. Its error bound holds if the terms have one sign, or if both are exact.
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        match (self.op(a).clone(), self.op(b).clone()) {
            (_, Op::Neg(b)) => self.sub(a, b),
            (Op::Neg(a), _) => self.sub(b, a),
            (_, Op::Literal(value)) if value.is_negative() => {
                let magnitude = self.constant(&-value);
                self.sub(a, magnitude)
            }
            _ => {
                let error = self.error_of_sum(a, b, self.sign(a).plus(self.sign(b)).is_definite());
                self.push(Op::Add(a, b), self.sign(a).plus(self.sign(b)), error)
            }
        }
    }

    /// The difference. Its error bound holds if the terms have opposite signs, or if both are exact.
    pub fn sub(&mut self, a: Node, b: Node) -> Node {
        if let Op::Neg(b) = *self.op(b) {
            return self.add(a, b);
        }
        let sign = self.sign(a).plus(-self.sign(b));
        let error = self.error_of_sum(a, b, sign.is_definite());
        self.push(Op::Sub(a, b), sign, error)
    }

    /// The sum of two terms that the caller knows to have this sign, or to be zero.
    pub fn add_of_one_sign(&mut self, a: Node, b: Node, sign: Sign) -> Node {
        let node = self.add(a, b);
        let error = self.error(a).max(self.error(b)) + ROUNDING;
        self.with_error(node, sign, error)
    }

    fn error_of_sum(&self, a: Node, b: Node, same_sign: bool) -> f64 {
        let worst = self.error(a).max(self.error(b));
        if worst == 0.0 || same_sign { worst + ROUNDING } else { f64::INFINITY }
    }

    /// The product.
    pub fn mul(&mut self, a: Node, b: Node) -> Node {
        for (one, other) in [(a, b), (b, a)] {
            if let Op::Neg(inner) = *self.op(other) {
                let product = self.mul(one, inner);
                return self.neg(product);
            }
            if let Some(value) = self.literal(one) {
                if value.is_one() {
                    return other;
                }
                if (-value).is_one() {
                    return self.neg(other);
                }
            }
        }
        if let (Some(x), Some(y)) = (self.literal(a), self.literal(b)) {
            let product = x * y;
            if is_exact(&product) {
                return self.constant(&product);
            }
        }
        let exact = self.is_power_of_two(a) || self.is_power_of_two(b);
        let error = self.error(a) + self.error(b) + if exact { 0.0 } else { ROUNDING };
        self.push(Op::Mul(a, b), self.sign(a) * self.sign(b), error)
    }

    /// The quotient.
    pub fn div(&mut self, a: Node, b: Node) -> Node {
        if let Some(value) = self.literal(b) {
            if value.is_one() {
                return a;
            }
            if self.is_power_of_two(b) {
                let reciprocal = value.recip();
                let reciprocal = self.constant(&reciprocal);
                return self.mul(reciprocal, a);
            }
        }
        if self.begins_with_minus(a) && self.begins_with_minus(b) {
            let (a, b) = (self.neg(a), self.neg(b));
            return self.div(a, b);
        }
        let error = self.error(a) + self.error(b) + ROUNDING;
        self.push(Op::Div(a, b), self.sign(a) * self.sign(b), error)
    }

    fn begins_with_minus(&self, node: Node) -> bool {
        match self.op(node) {
            Op::Neg(_) => true,
            Op::Literal(value) => value.is_negative(),
            Op::Mul(first, _) => self.begins_with_minus(*first),
            _ => false,
        }
    }

    /// A function, without a step where the value is the argument but for a sign that is known.
    pub fn call(&mut self, function: Function, a: Node) -> Node {
        let sign = self.sign(a).called(function);
        if function.is_exact() && (sign == self.sign(a) || sign == -self.sign(a)) && sign.is_definite() {
            return if sign == self.sign(a) { a } else { self.neg(a) };
        }
        let error = function.carried(self.error(a)) + function.properties().error.to_f64();
        self.push(Op::Call(function, a), sign, error)
    }

    /// One of two values.
    pub fn select(&mut self, condition: Condition, then: Node, otherwise: Node) -> Node {
        if then == otherwise {
            return then;
        }
        let sign = self.sign(then).or(self.sign(otherwise));
        let error = self.error(then).max(self.error(otherwise));
        self.push(Op::If(condition, then, otherwise), sign, error)
    }

    /// The largest or smallest of some values: no farther from the true one, relative to it, than the worst of them is
    /// from its own.
    pub fn extreme(&mut self, largest: bool, items: Vec<Node>) -> Node {
        let worst = items.iter().map(|&item| self.error(item)).fold(0.0, f64::max);
        let sign = items.iter().map(|&item| self.sign(item)).reduce(Sign::or).unwrap_or(Sign::ANY);
        self.push(if largest { Op::Max(items) } else { Op::Min(items) }, sign, worst)
    }

    /// A polynomial to all digits; its leaves count as exact.
    pub fn compensated(&mut self, expression: CompensatedExpr, sign: Sign) -> Node {
        self.push(Op::Compensated(expression), sign, COMPENSATED)
    }

    /// A polynomial in double-double, rounded once; its error has no bound of its own.
    pub fn residual(&mut self, expression: CompensatedExpr) -> Node {
        self.push(Op::Residual(expression), Sign::ANY, f64::INFINITY)
    }

    /// The one positive root of a polynomial; `error` bounds its relative error.
    pub fn positive_root(&mut self, coefficients: Vec<Node>, error: f64) -> Node {
        self.push(Op::PositiveRoot(coefficients), Sign::POSITIVE, error)
    }

    /// A step whose error bound has another proof than its operands' bounds.
    pub fn with_error(&mut self, node: Node, sign: Sign, error: f64) -> Node {
        self.steps[node.0].sign = sign;
        self.steps[node.0].error = error;
        node
    }

    fn is_power_of_two(&self, node: Node) -> bool {
        self.literal(node).is_some_and(is_power_of_two)
    }

    /// The polynomial of the inputs that a node is worth, if it is one: its steps, without their roundings.
    #[must_use]
    pub fn polynomial(&self, node: Node) -> Option<CompensatedExpr> {
        let both = |a, b| Some((Box::new(self.polynomial(a)?), Box::new(self.polynomial(b)?)));
        match *self.op(node) {
            Op::Input(_) | Op::Literal(_) if self.error(node) == 0.0 => Some(CompensatedExpr::Leaf(node)),
            Op::Neg(a) => Some(CompensatedExpr::Neg(Box::new(self.polynomial(a)?))),
            Op::Add(a, b) => both(a, b).map(|(a, b)| CompensatedExpr::Add(a, b)),
            Op::Sub(a, b) => both(a, b).map(|(a, b)| CompensatedExpr::Sub(a, b)),
            Op::Mul(a, b) => both(a, b).map(|(a, b)| CompensatedExpr::Mul(a, b)),
            Op::Compensated(ref expression) => Some(expression.clone()),
            _ => None,
        }
    }

    /// The operands of a node, in order.
    #[must_use]
    pub fn operands(&self, node: Node) -> Vec<Node> {
        self.op(node).operands()
    }
}
