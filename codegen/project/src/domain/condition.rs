//! One condition: comparisons of rational functions, joined by `and`, `or` and `not`.
//!
//! A comparison has no value where something that is written in it divides by zero, and then neither holds nor fails.
//! `and` fails where one part does, `or` holds where one does, `not` holds where its part fails (Kleene's logic): so
//! `not` moves to the comparisons and turns them, and what is left holds by comparisons whose divisors are not zero.

use std::cmp::Ordering;
use std::ops::Range;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, parse_expression};
use rug::{Integer, Rational};
use thiserror::Error;

use super::exact::Exact;
use super::magnitude;

/// The largest power a condition may contain; exact arithmetic would never finish beyond.
const MAX_POWER: i32 = 64;

/// A condition on the inputs of a kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// A comparison.
    Compare(Comparison),
    /// All hold.
    And(Vec<Condition>),
    /// One holds at least.
    Or(Vec<Condition>),
}

/// Two rational functions compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// How.
    pub operator: ComparisonOperator,
    /// The side before the operator.
    pub lhs: Expr,
    /// The side after the operator.
    pub rhs: Expr,
    difference: Exact,
    divisors: Vec<Comparison>,
}

/// The comparisons a condition may make.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ComparisonOperator {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `=`
    Equal,
    /// `#`
    NotEqual,
}

/// Why a text is no condition.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ConditionError {
    /// Not Maxima.
    #[error("the domain condition cannot be read: {message}")]
    Syntax {
        /// What the parser says.
        message: String,
        /// Where, if it knows.
        span: Option<Range<usize>>,
    },
    /// No truth value.
    #[error("the domain condition is not a comparison")]
    NotComparison {
        /// Where.
        span: Range<usize>,
    },
    /// Something that the kernel does not take.
    #[error("the domain condition names `{name}`, which is not an input of this kernel")]
    UnknownVariable {
        /// The name.
        name: String,
        /// Where.
        span: Range<usize>,
    },
    /// Something that cannot be decided exactly.
    #[error("a side of the domain condition is not a rational function")]
    NotRational {
        /// Where.
        span: Range<usize>,
    },
}

impl ConditionError {
    /// Where in the condition.
    pub fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::Syntax { span, .. } => span.clone(),
            Self::NotComparison { span } | Self::UnknownVariable { span, .. } | Self::NotRational { span } => {
                Some(span.clone())
            }
        }
    }

    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "write a Maxima comparison such as a2Max > 0",
            Self::NotComparison { .. } => "compare with < <= > >= = #, and join comparisons with and, or, not",
            Self::UnknownVariable { .. } => "add it to the kernel's `inputs`, or correct its name",
            Self::NotRational { .. } => "use only + - * /, abs, numbers and small integer powers; square away roots",
        }
    }

    /// What a caret says.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "here",
            Self::NotComparison { .. } => "neither true nor false",
            Self::UnknownVariable { .. } => "not an input of this kernel",
            Self::NotRational { .. } => "not rational",
        }
    }
}

impl Condition {
    /// Reads a condition on inputs with these Maxima names.
    pub fn parse(text: &str, variables: &[String]) -> Result<Self, ConditionError> {
        let expression = parse_expression(text)
            .map_err(|error| ConditionError::Syntax { message: error.to_string(), span: Some(error.span()) })?;
        Self::from_expression(&expression, variables)
    }

    fn from_expression(expression: &Expr, variables: &[String]) -> Result<Self, ConditionError> {
        let both = |left, right| -> Result<Vec<Self>, ConditionError> {
            Ok(vec![Self::from_expression(left, variables)?, Self::from_expression(right, variables)?])
        };
        match &expression.kind {
            ExprKind::Binary { operator: BinaryOperator::And, left, right } => Ok(Self::And(both(left, right)?)),
            ExprKind::Binary { operator: BinaryOperator::Or, left, right } => Ok(Self::Or(both(left, right)?)),
            ExprKind::Binary { operator, left, right } => match ComparisonOperator::of(*operator) {
                Some(comparison) => match magnitude::without_one(*operator, left, right) {
                    Some(without) => Self::from_expression(&without, variables),
                    None => Comparison::new(comparison, left, right, variables).map(Self::Compare),
                },
                None => Err(ConditionError::NotComparison { span: expression.span.clone() }),
            },
            ExprKind::Unary { operator: UnaryOperator::Not, operand } => {
                Ok(Self::from_expression(operand, variables)?.turned())
            }
            _ => Err(ConditionError::NotComparison { span: expression.span.clone() }),
        }
    }

    /// Whether the condition holds at a point, one coordinate a variable.
    pub fn holds(&self, point: &[Rational]) -> bool {
        match self {
            Self::Compare(comparison) => comparison.holds(point),
            Self::And(parts) => parts.iter().all(|part| part.holds(point)),
            Self::Or(parts) => parts.iter().any(|part| part.holds(point)),
        }
    }

    /// The condition that holds where this one fails: neither does where a comparison that matters has no value.
    fn turned(&self) -> Self {
        let each = |parts: &[Self]| parts.iter().map(Self::turned).collect();
        match self {
            Self::Compare(comparison) => Self::Compare(comparison.turned()),
            Self::And(parts) => Self::Or(each(parts)),
            Self::Or(parts) => Self::And(each(parts)),
        }
    }

    /// Every comparison in the condition, those of divisors with zero before the one in which they stand.
    pub fn comparisons(&self) -> Vec<&Comparison> {
        match self {
            Self::Compare(comparison) => comparison.divisors.iter().chain([comparison]).collect(),
            Self::And(parts) | Self::Or(parts) => parts.iter().flat_map(Self::comparisons).collect(),
        }
    }
}

impl Comparison {
    fn new(operator: ComparisonOperator, lhs: &Expr, rhs: &Expr, variables: &[String]) -> Result<Self, ConditionError> {
        let compared = |operator, lhs: &Expr, rhs: &Expr| -> Result<Self, ConditionError> {
            let difference = rational(lhs, variables)?.minus(rational(rhs, variables)?);
            Ok(Self { operator, lhs: lhs.clone(), rhs: rhs.clone(), difference, divisors: Vec::new() })
        };
        let zero = ExprKind::Integer(0.into()).into();
        let not_zero = |divisor: &Expr| compared(ComparisonOperator::NotEqual, divisor, &zero);
        let mut comparison = compared(operator, lhs, rhs)?;
        let divisors = divisors_in(lhs).into_iter().chain(divisors_in(rhs)).collect::<Vec<_>>();
        let first = |at: usize| !divisors[..at].contains(&divisors[at]);
        comparison.divisors =
            (0..divisors.len()).filter(|at| first(*at)).map(|at| not_zero(divisors[at])).collect::<Result<_, _>>()?;
        Ok(comparison)
    }

    /// What is divided by in the comparison, each compared with zero: where one of these fails, the comparison has no
    /// value.
    pub fn divisors(&self) -> &[Comparison] {
        &self.divisors
    }

    /// The comparison that holds where this one fails.
    fn turned(&self) -> Self {
        Self { operator: self.operator.turned(), ..self.clone() }
    }

    /// Whether the comparison holds at a point.
    pub fn holds(&self, point: &[Rational]) -> bool {
        self.difference(point).is_some_and(|difference| self.operator.accepts(difference.cmp0()))
    }

    /// `lhs - rhs` at a point; `None` at a pole.
    pub fn difference(&self, point: &[Rational]) -> Option<Rational> {
        self.difference.at(point)
    }

    /// Whether the comparison names a variable, given by its position.
    pub fn uses(&self, variable: usize) -> bool {
        self.difference.uses(variable)
    }
}

impl ComparisonOperator {
    fn of(operator: BinaryOperator) -> Option<Self> {
        Some(match operator {
            BinaryOperator::Less => Self::Less,
            BinaryOperator::LessEqual => Self::LessEqual,
            BinaryOperator::Greater => Self::Greater,
            BinaryOperator::GreaterEqual => Self::GreaterEqual,
            BinaryOperator::Equal => Self::Equal,
            BinaryOperator::NotEqual => Self::NotEqual,
            _ => return None,
        })
    }

    /// Whether the comparison is true of sides in this order.
    pub fn accepts(self, sides: Ordering) -> bool {
        match self {
            Self::Less => sides.is_lt(),
            Self::LessEqual => sides.is_le(),
            Self::Greater => sides.is_gt(),
            Self::GreaterEqual => sides.is_ge(),
            Self::Equal => sides.is_eq(),
            Self::NotEqual => sides.is_ne(),
        }
    }

    /// The operator that is true where this one is false.
    fn turned(self) -> Self {
        match self {
            Self::Less => Self::GreaterEqual,
            Self::LessEqual => Self::Greater,
            Self::Greater => Self::LessEqual,
            Self::GreaterEqual => Self::Less,
            Self::Equal => Self::NotEqual,
            Self::NotEqual => Self::Equal,
        }
    }
}

/// An expression as a rational function of the variables.
fn rational(expression: &Expr, variables: &[String]) -> Result<Exact, ConditionError> {
    let not_rational = || ConditionError::NotRational { span: expression.span.clone() };
    match &expression.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) => closedform_maxima::exact::rational(expression)
            .ok()
            .and_then(|value| number(&value))
            .ok_or_else(not_rational),
        ExprKind::Symbol(name) => variable(name, variables)
            .ok_or_else(|| ConditionError::UnknownVariable { name: name.clone(), span: expression.span.clone() }),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => rational(operand, variables),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Ok(rational(operand, variables)?.negated()),
        ExprKind::Binary { operator, left, right } => {
            binary(*operator, rational(left, variables)?, rational(right, variables)?).ok_or_else(not_rational)
        }
        _ => Err(not_rational()),
    }
}

/// The number in the arithmetic of conditions, which is GMP's because sampling decides many of them.
fn number(value: &num_rational::BigRational) -> Option<Exact> {
    let integer = |number: &num_bigint::BigInt| number.to_string().parse::<Integer>().ok();
    Some(Exact::Number(Rational::from((integer(value.numer())?, integer(value.denom())?))))
}

fn variable(name: &str, variables: &[String]) -> Option<Exact> {
    variables.iter().position(|variable| variable == name).map(Exact::Variable)
}

fn binary(operator: BinaryOperator, left: Exact, right: Exact) -> Option<Exact> {
    Some(match operator {
        BinaryOperator::Add => Exact::Sum(vec![left, right]),
        BinaryOperator::Subtract => left.minus(right),
        BinaryOperator::Multiply => Exact::Product(vec![left, right]),
        BinaryOperator::Divide => Exact::Product(vec![left, Exact::Power(Box::new(right), -1)]),
        BinaryOperator::Power => Exact::Power(Box::new(left), small_integer(&right)?),
        _ => return None,
    })
}

fn small_integer(exponent: &Exact) -> Option<i32> {
    let value = exponent.at(&[])?;
    let value = if value.is_integer() { value.numer().to_i32()? } else { return None };
    (value.abs() <= MAX_POWER).then_some(value)
}

/// Everything that a rational function divides by as it is written, what stands inside before what it stands in.
fn divisors_in(function: &Expr) -> Vec<&Expr> {
    match &function.kind {
        ExprKind::Unary { operand, .. } => divisors_in(operand),
        ExprKind::Binary { operator, left, right } => {
            let mut divisors = [divisors_in(left), divisors_in(right)].concat();
            match operator {
                BinaryOperator::Divide => divisors.push(right),
                BinaryOperator::Power if is_negative(right) => divisors.push(left),
                _ => {}
            }
            divisors.retain(|divisor| constant(divisor).is_none_or(|value| value.is_zero()));
            divisors
        }
        _ => Vec::new(),
    }
}

fn is_negative(exponent: &Expr) -> bool {
    constant(exponent).is_some_and(|exponent| exponent < 0)
}

/// The value of a function that names no input.
fn constant(function: &Expr) -> Option<Rational> {
    rational(function, &[]).ok()?.at(&[])
}
