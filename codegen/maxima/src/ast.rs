//! The tree of a Maxima expression, every node with the place it was read from.

use std::ops::Range;

use closedform_arith::Relation;
use num_bigint::BigInt;

/// An expression and the bytes of the text it was read from.
///
/// Two expressions are equal when their kinds are: spans are not compared.
#[derive(Debug, Clone, Eq)]
pub struct Expr {
    /// What the expression is.
    pub kind: ExprKind,
    /// Where it stands in the text; parentheses around it belong to it.
    pub span: Range<usize>,
}

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

impl Expr {
    /// An expression read from `span`.
    #[must_use]
    pub fn new(kind: ExprKind, span: Range<usize>) -> Self {
        Self { kind, span }
    }

    /// The name, if the expression is a symbol.
    #[must_use]
    pub fn as_symbol(&self) -> Option<&str> {
        match &self.kind {
            ExprKind::Symbol(name) => Some(name),
            _ => None,
        }
    }

    /// Name and arguments, if the expression calls a function by its name.
    #[must_use]
    pub fn as_call(&self) -> Option<(&str, &[Expr])> {
        match &self.kind {
            ExprKind::Call { function, arguments } => Some((function.as_symbol()?, arguments)),
            _ => None,
        }
    }
}

impl From<ExprKind> for Expr {
    /// An expression that was not read from a text: its span is empty.
    fn from(kind: ExprKind) -> Self {
        Self::new(kind, 0..0)
    }
}

/// What an expression is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ExprKind {
    /// `12`, also `12.`; a number read from text is never negative.
    Integer(BigInt),
    /// `1.5`, `.5`, `1e-3`, `1d0`, as written.
    Float(String),
    /// `1.5b-3`, as written.
    BigFloat(String),
    /// `"text"`, without quotes and escapes.
    String(String),
    /// `x`, `%pi`, `?lisp`, without escapes.
    Symbol(String),
    /// `'x`, `'(x)`, `''x`, `''(x)`.
    Quote {
        /// Which of the four.
        quoting: Quoting,
        /// What is quoted.
        expression: Box<Expr>,
    },
    /// `f(x)`, `f[i](x)`, `lambda([x],x)(1)`.
    Call {
        /// What is called: mostly a symbol.
        function: Box<Expr>,
        /// What it is called with.
        arguments: Vec<Expr>,
    },
    /// `a[1]`, `m[i,j]`.
    Subscript {
        /// What is indexed.
        array: Box<Expr>,
        /// At least one index.
        indices: Vec<Expr>,
    },
    /// `[a,b]`.
    List(Vec<Expr>),
    /// `{a,b}`.
    Set(Vec<Expr>),
    /// `(a,b)`: evaluated in turn, worth the last one. Always at least two when read from text.
    Sequence(Vec<Expr>),
    /// An operator with one operand.
    Unary {
        /// The operator.
        operator: UnaryOperator,
        /// Its operand.
        operand: Box<Expr>,
    },
    /// An operator between two operands; chains lean left or right as in Maxima.
    Binary {
        /// The operator.
        operator: BinaryOperator,
        /// The operand before it.
        left: Box<Expr>,
        /// The operand after it.
        right: Box<Expr>,
    },
    /// `if a then b elseif c then d else e`.
    If {
        /// Conditions with their values; at least one.
        branches: Vec<Branch>,
        /// The value after `else`.
        otherwise: Option<Box<Expr>>,
    },
    /// `for i:1 step 2 thru 9 while c do body`.
    Loop {
        /// The words before `do`, in order.
        clauses: Vec<LoopClause>,
        /// What is repeated.
        body: Box<Expr>,
    },
    /// `expression, x=1` at the top of a statement: short for `ev(expression,x=1)`.
    Ev {
        /// What is evaluated.
        expression: Box<Expr>,
        /// Under which equations and flags; at least one.
        options: Vec<Expr>,
    },
}

/// The marks before a quoted expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quoting {
    /// `'f(x)`: the noun form.
    Noun,
    /// `'(f(x))`: not evaluated at all.
    Expression,
    /// `''f(x)`: the verb form.
    Verb,
    /// `''(f(x))`: evaluated when read.
    Value,
}

/// `condition then value` of an `if`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Branch {
    /// When.
    pub condition: Expr,
    /// What.
    pub value: Expr,
}

/// One word of a loop with what follows it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoopClause {
    /// The word.
    pub word: LoopWord,
    /// What follows it.
    pub value: Expr,
}

/// The words that steer a loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoopWord {
    /// `for i`
    For,
    /// `: 1` or `from 1`
    From,
    /// `in list`
    In,
    /// `step 2`
    Step,
    /// `next i*2`
    Next,
    /// `thru 9`
    Thru,
    /// `while condition`
    While,
    /// `unless condition`
    Unless,
}

/// An operator with one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `+a`
    Plus,
    /// `-a`
    Minus,
    /// `not a`
    Not,
    /// `a!`
    Factorial,
    /// `a!!`
    DoubleFactorial,
}

/// An operator between two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOperator {
    /// `a+b`
    Add,
    /// `a-b`
    Subtract,
    /// `a*b`
    Multiply,
    /// `a/b`
    Divide,
    /// `a^b` or `a**b`
    Power,
    /// `a . b`: the noncommutative product
    Dot,
    /// `a^^b`: the noncommutative power
    DotPower,
    /// `a=b`, `a#b`, `a<b`, `a<=b`, `a>b` or `a>=b`
    Compare(Relation),
    /// `a and b`
    And,
    /// `a or b`
    Or,
    /// `a:b`
    Assign,
    /// `a::b`: assigns to the value of `a`
    AssignValue,
    /// `f(x):=b`
    Define,
    /// `f(x)::=b`
    DefineMacro,
    /// `a@b`: a field of a structure
    Field,
}

/// What ends a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Terminator {
    /// `;`: Maxima prints the result.
    Show,
    /// `$`: Maxima keeps quiet.
    Hide,
}

/// An expression of a worksheet with what ends it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The `%i12` or `%o12` in parentheses before it, where text was copied from a transcript.
    pub label: Option<String>,
    /// What is stated.
    pub expression: Expr,
    /// How it ends.
    pub terminator: Terminator,
}
