//! Steps: what each does, and to which others.

use closedform_syntax::{Function, Relation};
use num_rational::BigRational;

/// A node of a [`Graph`](super::Graph), by position; operands come before the nodes that use them.
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

/// A polynomial that is evaluated in pairs of `f64` and rounded once.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum CompensatedExpr {
    /// An operand that counts as exact.
    Leaf(Node),
    /// The negative.
    Neg(Box<CompensatedExpr>),
    /// The sum.
    Add(Box<CompensatedExpr>, Box<CompensatedExpr>),
    /// The difference.
    Sub(Box<CompensatedExpr>, Box<CompensatedExpr>),
    /// The product.
    Mul(Box<CompensatedExpr>, Box<CompensatedExpr>),
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
    /// A function of a value.
    Call(Function, Node),
    /// One of two values.
    If(Condition, Node, Node),
    /// The largest of some values.
    Max(Vec<Node>),
    /// The smallest of some values.
    Min(Vec<Node>),
    /// A polynomial that may cancel, to all digits.
    Compensated(CompensatedExpr),
    /// A polynomial at an iterate of its root, in double-double.
    Residual(CompensatedExpr),
    /// The one positive root of a polynomial, from its coefficients, lowest power first.
    PositiveRoot(Vec<Node>),
}

impl Op {
    /// The operands, in order.
    #[must_use]
    pub fn operands(&self) -> Vec<Node> {
        match self {
            Self::Input(_) | Self::Literal(_) | Self::Pi => Vec::new(),
            Self::Neg(a) | Self::Call(_, a) => vec![*a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![*a, *b],
            Self::If(condition, a, b) => {
                let mut nodes = condition.nodes();
                nodes.extend([*a, *b]);
                nodes
            }
            Self::Compensated(expression) | Self::Residual(expression) => expression.leaves(),
            Self::Max(nodes) | Self::Min(nodes) | Self::PositiveRoot(nodes) => nodes.clone(),
        }
    }

    /// A sum or product in the other order, which has the same bits.
    #[must_use]
    pub fn swapped(&self) -> Option<Self> {
        match *self {
            Self::Add(a, b) => Some(Self::Add(b, a)),
            Self::Mul(a, b) => Some(Self::Mul(b, a)),
            _ => None,
        }
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

impl CompensatedExpr {
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
