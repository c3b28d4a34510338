//! Binding powers and kinds of operands: Maxima's own tables (`lbp`, `rbp`, `lpos`, `rpos`, `pos`).

use closedform_arith::Relation;

use crate::ast::{BinaryOperator, Expr, ExprKind, LoopWord, UnaryOperator};

/// How strongly an operator binds; the greater, the tighter.
pub(crate) type Power = u16;

/// Of what follows a closing bracket, a comma or a terminator: binds nothing.
pub(crate) const DELIMITER: Power = 5;
/// Of a comma: elements of lists, arguments and sequences bind tighter.
pub(crate) const COMMA: Power = 10;
/// Of what follows `then`, `else` and `do`.
pub(crate) const BODY: Power = 25;
/// Of a condition after `if`, `while`, `unless`.
pub(crate) const CONDITION: Power = 45;
/// Of the operand of a prefix `+` or `-`.
pub(crate) const SIGN: Power = 134;
/// Of `!` and `!!` to what stands before them.
pub(crate) const POSTFIX: Power = 160;
/// Of what follows a quote.
pub(crate) const QUOTE: Power = 190;
/// Of a call or subscript to what stands before it.
pub(crate) const APPLICATION: Power = 200;

/// What Maxima lets stand as an operand without parentheses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Everything.
    Any,
    /// A quantity: an operand of `+`, `*`, `<`.
    Algebraic,
    /// A condition: an operand of `and`.
    Logical,
}

impl Mode {
    /// Whether an expression of mode `self` may stand where `wanted` is.
    pub(crate) fn fits(self, wanted: Mode) -> bool {
        self == wanted || self == Mode::Any || wanted == Mode::Any
    }
}

/// The mode of an expression that stands without parentheses.
pub(crate) fn mode(expression: &Expr) -> Mode {
    match &expression.kind {
        ExprKind::Unary { operator, .. } => operator.mode(),
        ExprKind::Binary { operator, .. } => operator.result(),
        _ => Mode::Any,
    }
}

impl UnaryOperator {
    /// How the operator is written.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Not => "not",
            Self::Factorial => "!",
            Self::DoubleFactorial => "!!",
        }
    }

    /// Whether the operator stands behind its operand.
    #[must_use]
    pub fn is_postfix(self) -> bool {
        matches!(self, Self::Factorial | Self::DoubleFactorial)
    }

    /// How strongly it binds its operand.
    pub(crate) fn power(self) -> Power {
        match self {
            Self::Plus | Self::Minus => SIGN,
            Self::Not => 70,
            Self::Factorial | Self::DoubleFactorial => POSTFIX,
        }
    }

    /// What its operand must be, and what it is itself.
    pub(crate) fn mode(self) -> Mode {
        match self {
            Self::Not => Mode::Logical,
            _ => Mode::Algebraic,
        }
    }

    /// The prefix operator written as `mark`.
    pub(crate) fn prefix(mark: &str) -> Option<Self> {
        [Self::Plus, Self::Minus, Self::Not].into_iter().find(|operator| operator.symbol() == mark)
    }

    /// The postfix operator written as `mark`.
    pub(crate) fn postfix(mark: &str) -> Option<Self> {
        [Self::Factorial, Self::DoubleFactorial].into_iter().find(|operator| operator.symbol() == mark)
    }
}

impl BinaryOperator {
    /// Every operator.
    pub const ALL: [Self; 20] = [
        Self::Add,
        Self::Subtract,
        Self::Multiply,
        Self::Divide,
        Self::Power,
        Self::Dot,
        Self::DotPower,
        Self::Compare(Relation::Equal),
        Self::Compare(Relation::NotEqual),
        Self::Compare(Relation::Less),
        Self::Compare(Relation::LessOrEqual),
        Self::Compare(Relation::Greater),
        Self::Compare(Relation::GreaterOrEqual),
        Self::And,
        Self::Or,
        Self::Assign,
        Self::AssignValue,
        Self::Define,
        Self::DefineMacro,
        Self::Field,
    ];

    /// How the operator is written.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        self.row().0
    }

    /// How strongly it binds what stands before it.
    pub(crate) fn left_power(self) -> Power {
        self.row().1
    }

    /// How strongly it binds what stands after it.
    pub(crate) fn right_power(self) -> Power {
        self.row().2
    }

    fn row(self) -> (&'static str, Power, Power) {
        match self {
            Self::Add => ("+", 100, 100),
            Self::Subtract => ("-", 100, 100),
            Self::Multiply => ("*", 120, 120),
            Self::Divide => ("/", 120, 120),
            Self::Power => ("^", 140, 139),
            Self::Dot => (".", 130, 129),
            Self::DotPower => ("^^", 140, 139),
            Self::Compare(relation) => (relation.maxima(), 80, 80),
            Self::And => ("and", 65, 65),
            Self::Or => ("or", 60, 60),
            Self::Assign => (":", 180, 20),
            Self::AssignValue => ("::", 180, 20),
            Self::Define => (":=", 180, 20),
            Self::DefineMacro => ("::=", 180, 20),
            Self::Field => ("@", 200, 201),
        }
    }

    /// Whether the operator compares two quantities.
    #[must_use]
    pub fn is_comparison(self) -> bool {
        matches!(self, Self::Compare(_))
    }

    /// What its operands must be.
    pub(crate) fn operands(self) -> Mode {
        match self.left_power() {
            60 | 65 => Mode::Logical,
            180 | 200 => Mode::Any,
            _ => Mode::Algebraic,
        }
    }

    /// What it is itself.
    pub(crate) fn result(self) -> Mode {
        if self.is_comparison() { Mode::Logical } else { self.operands() }
    }

    /// The operator written as `mark`.
    pub(crate) fn infix(mark: &str) -> Option<Self> {
        let mark = if mark == "**" { "^" } else { mark };
        Self::ALL.into_iter().find(|operator| operator.symbol() == mark)
    }
}

impl LoopWord {
    /// How the word is written.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::For => "for",
            Self::From => "from",
            Self::In => "in",
            Self::Step => "step",
            Self::Next => "next",
            Self::Thru => "thru",
            Self::While => "while",
            Self::Unless => "unless",
        }
    }

    /// The word, except `in`, which is one only behind `for i`.
    pub(crate) fn reserved(mark: &str) -> Option<Self> {
        [Self::For, Self::From, Self::Step, Self::Next, Self::Thru, Self::While, Self::Unless]
            .into_iter()
            .find(|word| word.symbol() == mark)
    }

    /// How strongly it binds what follows it.
    pub(crate) fn power(self) -> Power {
        match self {
            Self::For => APPLICATION,
            Self::From | Self::In | Self::Step | Self::Thru => 95,
            Self::Next | Self::While | Self::Unless => CONDITION,
        }
    }

    /// What must follow it.
    pub(crate) fn mode(self) -> Mode {
        match self {
            Self::While | Self::Unless => Mode::Logical,
            Self::Step | Self::Thru => Mode::Algebraic,
            Self::For | Self::From | Self::In | Self::Next => Mode::Any,
        }
    }
}
