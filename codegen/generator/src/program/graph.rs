//! The graph of steps: equal steps are one node, and each knows its sign and a bound of its relative error.

use crate::field::Sign;
use closedform_arith::{Relation, error_model};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::HashMap;

/// A node of a [`Graph`], by position; operands come before the nodes that use them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node(pub usize);

/// A condition on nodes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// A node compared with another one.
    Compare(Node, Relation, Node),
    /// Both hold.
    And(Box<Condition>, Box<Condition>),
    /// One holds.
    Or(Box<Condition>, Box<Condition>),
    /// It does not hold.
    Not(Box<Condition>),
}

/// A polynomial that is evaluated in double-double and rounded once.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Wide {
    /// An operand that counts as exact.
    Leaf(Node),
    /// The negative.
    Neg(Box<Wide>),
    /// The sum.
    Add(Box<Wide>, Box<Wide>),
    /// The difference.
    Sub(Box<Wide>, Box<Wide>),
    /// The product.
    Mul(Box<Wide>, Box<Wide>),
}

/// What a step does.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// An input, by position.
    Input(usize),
    /// A constant that `f64` holds exactly.
    Literal(BigRational),
    /// The circle constant.
    Pi,
    /// The negative.
    Neg(Node),
    /// The sum.
    Add(Node, Node),
    /// The difference.
    Sub(Node, Node),
    /// The product.
    Mul(Node, Node),
    /// The quotient.
    Div(Node, Node),
    /// The square root.
    Sqrt(Node),
    /// The magnitude.
    Abs(Node),
    /// One of two values.
    If(Condition, Node, Node),
    /// The largest of some values.
    Max(Vec<Node>),
    /// The smallest of some values.
    Min(Vec<Node>),
    /// A polynomial that may cancel, to all digits.
    Compensated(Wide),
    /// A polynomial at an iterate of its root, in double-double.
    Residual(Wide),
    /// The one positive root of a polynomial, from its coefficients, lowest power first.
    PositiveRoot(Vec<Node>),
}

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

/// The power of two by which an integer beyond all literals is divided.
const STEP_OF_TWOS: usize = 512;

/// How far a `compensated!` slice may be off, in units of 2^-53.
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
        let known = self.index.get(&op).or_else(|| self.index.get(&swapped(&op)?));
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

    /// The square root.
    pub fn sqrt(&mut self, a: Node) -> Node {
        let sign = self.sign(a) & Sign::NONNEGATIVE;
        let error = 0.5 * self.error(a) + ROUNDING;
        self.push(Op::Sqrt(a), sign, error)
    }

    /// The magnitude, without a step where the sign is known.
    pub fn abs(&mut self, a: Node) -> Node {
        match self.sign(a) {
            sign if sign.is(Sign::NONNEGATIVE) => a,
            sign if sign.is(Sign::NONPOSITIVE) => self.neg(a),
            sign => self.push(Op::Abs(a), sign.power(2), self.error(a)),
        }
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
    pub fn compensated(&mut self, wide: Wide, sign: Sign) -> Node {
        self.push(Op::Compensated(wide), sign, COMPENSATED)
    }

    /// A polynomial in double-double, rounded once; its error has no bound of its own.
    pub fn residual(&mut self, wide: Wide) -> Node {
        self.push(Op::Residual(wide), Sign::ANY, f64::INFINITY)
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
    pub fn polynomial(&self, node: Node) -> Option<Wide> {
        let both = |a, b| Some((Box::new(self.polynomial(a)?), Box::new(self.polynomial(b)?)));
        match *self.op(node) {
            Op::Input(_) | Op::Literal(_) if self.error(node) == 0.0 => Some(Wide::Leaf(node)),
            Op::Neg(a) => Some(Wide::Neg(Box::new(self.polynomial(a)?))),
            Op::Add(a, b) => both(a, b).map(|(a, b)| Wide::Add(a, b)),
            Op::Sub(a, b) => both(a, b).map(|(a, b)| Wide::Sub(a, b)),
            Op::Mul(a, b) => both(a, b).map(|(a, b)| Wide::Mul(a, b)),
            Op::Compensated(ref wide) => Some(wide.clone()),
            _ => None,
        }
    }

    /// The operands of a node, in order.
    #[must_use]
    pub fn operands(&self, node: Node) -> Vec<Node> {
        match self.op(node) {
            Op::Input(_) | Op::Literal(_) | Op::Pi => Vec::new(),
            Op::Neg(a) | Op::Sqrt(a) | Op::Abs(a) => vec![*a],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) => vec![*a, *b],
            Op::If(condition, a, b) => {
                let mut nodes = condition.nodes();
                nodes.extend([*a, *b]);
                nodes
            }
            Op::Compensated(wide) | Op::Residual(wide) => wide.leaves(),
            Op::Max(nodes) | Op::Min(nodes) | Op::PositiveRoot(nodes) => nodes.clone(),
        }
    }
}

/// A sum or product in the other order, which has the same bits.
fn swapped(op: &Op) -> Option<Op> {
    match *op {
        Op::Add(a, b) => Some(Op::Add(b, a)),
        Op::Mul(a, b) => Some(Op::Mul(b, a)),
        _ => None,
    }
}

impl Condition {
    /// The nodes that are compared.
    #[must_use]
    pub fn nodes(&self) -> Vec<Node> {
        match self {
            Self::Compare(a, _, b) => vec![*a, *b],
            Self::And(a, b) | Self::Or(a, b) => [a.nodes(), b.nodes()].concat(),
            Self::Not(a) => a.nodes(),
        }
    }
}

impl Wide {
    /// The operands.
    #[must_use]
    pub fn leaves(&self) -> Vec<Node> {
        match self {
            Self::Leaf(node) => vec![*node],
            Self::Neg(a) => a.leaves(),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) => [a.leaves(), b.leaves()].concat(),
        }
    }
}

/// Whether `f64` holds the number exactly, well inside its range.
#[must_use]
pub fn is_exact(value: &BigRational) -> bool {
    let bits = value.numer().bits();
    let trailing = value.numer().trailing_zeros().unwrap_or(0);
    is_power_of_two(&BigRational::from_integer(value.denom().clone()))
        && bits - trailing <= 53
        && bits <= 1_024
        && value.denom().bits() <= 1_023
}

/// The leading 53 bits of an integer, so that the rest has its sign; `None` beyond all literals.
#[must_use]
pub fn leading_bits(value: &BigRational) -> Option<BigRational> {
    let integer = value.to_integer();
    let less = integer.bits().saturating_sub(53) as usize;
    let leading = BigRational::from_integer((integer.abs() >> less << less) * integer.signum());
    Some(leading).filter(is_exact)
}

/// An integer beyond all literals as `step*high + rest`, with a power of two for a step.
#[must_use]
pub fn beyond_literals(value: &BigRational) -> (BigRational, BigRational, BigRational) {
    let step = BigRational::from_integer(BigInt::one() << STEP_OF_TWOS);
    let high = (value / &step).trunc();
    let rest = value - &high * &step;
    (step, high, rest)
}

/// Whether the number is a power of two, or the negative of one.
#[must_use]
pub fn is_power_of_two(value: &BigRational) -> bool {
    let single_bit = |n: &num_bigint::BigInt| n.abs().magnitude().count_ones() == 1;
    !value.is_zero() && single_bit(value.numer()) && single_bit(value.denom())
}
