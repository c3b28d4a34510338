//! A kernel as a tree, checked and with its names resolved.

use closedform_arith::{Function, Precision, Relation};
use proc_macro2::{Ident, Span};
use std::fmt;
use syn::{Attribute, Visibility};

/// A straight-line function: conditions on its inputs, then one `let` a step, then its results.
#[derive(Clone)]
pub struct Kernel {
    /// What stands above the function besides `#[kernel]`: documentation, `cfg`, lints.
    pub attributes: Vec<Attribute>,
    /// How far it is visible.
    pub visibility: Visibility,
    /// Its name.
    pub name: Ident,
    /// What is known of it besides its code.
    pub meta: Meta,
    /// Its inputs; at least one, at most [`MAX_INPUTS`](closedform_arith::limits::MAX_INPUTS).
    pub inputs: Vec<Input>,
    /// The conditions that inputs must meet, besides being finite.
    pub requires: Vec<Require>,
    /// The steps, in order.
    pub lets: Vec<Let>,
    /// What it returns.
    pub output: Output,
}

// By hand, because the attributes of syn print themselves only with its feature `extra-traits`: every user of `#[kernel]`
// would wait for that to compile.
impl fmt::Debug for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { attributes: _, visibility: _, name, meta, inputs, requires, lets, output } = self;
        let mut parts = f.debug_struct("Kernel");
        parts.field("name", name).field("meta", meta).field("inputs", inputs).field("requires", requires);
        parts.field("lets", lets).field("output", output).finish_non_exhaustive()
    }
}

/// What the attribute `#[kernel(..)]` tells.
#[derive(Clone, Debug)]
pub struct Meta {
    /// The worksheet that it belongs to.
    pub family: Option<String>,
    /// The closed form as Maxima text.
    pub maxima: Option<String>,
    /// The closed form as LaTeX.
    pub latex: Option<String>,
    /// Where the formula is derived.
    pub source: Option<String>,
    /// The first paragraph of the documentation, in one line.
    pub summary: String,
    /// The rewrites that keep its digits.
    pub rules: Vec<String>,
    /// What its function computes in.
    pub precision: Precision,
    /// One entry a result, in the order of the output.
    pub results: Vec<ResultMeta>,
    /// A call that its documentation shows.
    pub example: Option<Example>,
    /// Where bounds are stated, if any are.
    pub bound_place: Option<Span>,
    /// What shows that they were proved; read by [`certified`](crate::certified).
    pub certificate: Option<Certificate>,
}

/// A call, and what is known of its results from elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// The kernel as users of its crate name it: `family::name`.
    pub path: String,
    /// The inputs, in order.
    pub inputs: Vec<f64>,
    /// The results, in order; none where nothing is known of them.
    pub results: Vec<f64>,
}

/// What is written as the certificate of bounds.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// The text.
    pub text: String,
    /// Where it stands.
    pub place: Span,
}

/// What is known of a result.
#[derive(Clone, Debug)]
pub struct ResultMeta {
    /// Its field, or the name of a kernel that returns a number.
    pub name: Ident,
    /// The function of the worksheet that defines it.
    pub worksheet: Option<String>,
    /// Its unit.
    pub unit: Option<String>,
    /// The error in ulp that it never exceeds.
    pub bound: Option<f64>,
}

/// An input.
#[derive(Clone, Debug)]
pub struct Input {
    /// Its name in Rust.
    pub name: Ident,
    /// Its name in the worksheet.
    pub maxima: Option<String>,
    /// Its unit.
    pub unit: Option<String>,
    /// What it is, in Markdown; empty where nothing is said.
    pub doc: String,
    /// The range of magnitudes to expect.
    pub typical: Option<(f64, f64)>,
}

/// `require!(condition, "text")`
#[derive(Clone, Debug)]
pub struct Require {
    /// What must hold.
    pub condition: Condition,
    /// How errors name it; the condition itself where no text is given.
    pub text: String,
}

/// `let name = value;`
#[derive(Clone, Debug)]
pub struct Let {
    /// The name; never that of an input or another step.
    pub name: Ident,
    /// The value.
    pub value: Expr,
}

/// What a kernel returns.
#[derive(Clone, Debug)]
pub enum Output {
    /// A number.
    Value(Expr),
    /// A struct of numbers.
    Struct {
        /// The struct, declared beside the function.
        name: Ident,
        /// Its fields, in the order of the literal.
        fields: Vec<(Ident, Expr)>,
    },
}

impl Output {
    /// The expressions of all results, in order.
    pub fn values(&self) -> impl Iterator<Item = &Expr> {
        let (value, fields) = match self {
            Output::Value(value) => (Some(value), &[][..]),
            Output::Struct { fields, .. } => (None, &fields[..]),
        };
        value.into_iter().chain(fields.iter().map(|(_, value)| value))
    }
}

/// An expression.
#[derive(Clone, Debug)]
pub enum Expr {
    /// `2.0`
    Literal {
        /// The number.
        value: f64,
        /// Where it stands.
        span: Span,
    },
    /// An input or an earlier step.
    Name(Name),
    /// `PI`
    Pi(Span),
    /// `-e`
    Neg(Box<Expr>),
    /// `left op right`
    Binary {
        /// The operator.
        op: BinaryOp,
        /// The left operand.
        left: Box<Expr>,
        /// The right operand.
        right: Box<Expr>,
    },
    /// `function(e)`
    Call(Function, Box<Expr>),
    /// `max(e, e, ..)` or `min(e, e, ..)`
    Extreme {
        /// Whether it is the largest one.
        largest: bool,
        /// Two values or more.
        items: Vec<Expr>,
    },
    /// `if condition { then } else { otherwise }`
    If {
        /// The condition.
        condition: Box<Condition>,
        /// The value where it holds.
        then: Box<Expr>,
        /// The value where it does not hold.
        otherwise: Box<Expr>,
    },
    /// `compensated!(e)`
    Compensated(CompensatedExpr),
    /// `residual!(e)`; `e` consists of literals, names, `+ - *` and unary `-`.
    Residual(Box<Expr>),
    /// `positive_root([c0, c1, ..])`
    PositiveRoot(Vec<Expr>),
}

/// What stands in `compensated!`, and how it is evaluated where a pair cannot tell its digits.
#[derive(Clone, Debug)]
pub struct CompensatedExpr {
    /// The compensated expression: literals, names, `+ - *` and unary `-`.
    pub value: Box<Expr>,
    /// Its literals and names, each once.
    pub operands: Vec<Expr>,
    /// The compact form of its terms, products of operands.
    pub(crate) terms: Vec<u8>,
    /// The compact form of the steps that it is written as.
    pub(crate) factored: Vec<u8>,
    /// How much larger than this times the sum of its terms' magnitudes it must be in double-double to be right.
    pub threshold: f64,
}

/// A name in an expression, resolved.
#[derive(Clone, Debug)]
pub struct Name {
    /// As written.
    pub ident: Ident,
    /// Its position among all inputs followed by all steps.
    pub slot: usize,
}

/// An arithmetic operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

/// A condition.
#[derive(Clone, Debug)]
pub enum Condition {
    /// `left op right`
    Compare {
        /// How they compare.
        op: Relation,
        /// The left operand.
        left: Expr,
        /// The right operand.
        right: Expr,
    },
    /// `left && right`
    And(Box<Condition>, Box<Condition>),
    /// `left || right`
    Or(Box<Condition>, Box<Condition>),
    /// `!condition`
    Not(Box<Condition>),
}
