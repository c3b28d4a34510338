//! Conditions as Maxima writes them, read once into exact form; everything else takes that form.

use closedform_maxima::{BinaryOperator, Expr as Ast, ExprKind, Relation, UnaryOperator, parse_expression};
use rug::Rational;

use super::condition::{Comparison, Condition};
use super::error::ConditionError;
use super::exact::Exact;
use super::magnitude;
use crate::construct::integer;
use crate::expression::{Expr, LowerError, lower};
use crate::worksheet::any;

/// The largest power a condition may contain; exact arithmetic would never finish beyond.
const MAX_POWER: i32 = 64;

impl Condition {
    /// Reads a condition on inputs with these Maxima names.
    pub fn parse(text: &str, variables: &[String]) -> Result<Self, ConditionError> {
        let expression = parse_expression(text)
            .map_err(|error| ConditionError::Syntax { message: error.to_string(), span: Some(error.span()) })?;
        Self::read(&expression, variables)
    }

    /// The exact form of a condition that stands as a Maxima expression.
    pub(crate) fn read(expression: &Ast, variables: &[String]) -> Result<Self, ConditionError> {
        let both = |left, right| -> Result<Vec<Self>, ConditionError> {
            Ok(vec![Self::read(left, variables)?, Self::read(right, variables)?])
        };
        match &expression.kind {
            ExprKind::Binary { operator: BinaryOperator::And, left, right } => Ok(Self::And(both(left, right)?)),
            ExprKind::Binary { operator: BinaryOperator::Or, left, right } => Ok(Self::Or(both(left, right)?)),
            ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
                match magnitude::without_one(*relation, left, right) {
                    Some(without) => Self::read(&without, variables),
                    None => comparison(*relation, left, right, variables).map(Self::Compare),
                }
            }
            ExprKind::Unary { operator: UnaryOperator::Not, operand } => Ok(Self::read(operand, variables)?.turned()),
            _ => Err(ConditionError::NotComparison { span: expression.span.clone() }),
        }
    }
}

fn comparison(relation: Relation, lhs: &Ast, rhs: &Ast, variables: &[String]) -> Result<Comparison, ConditionError> {
    let compared = |relation, lhs: &Ast, rhs: &Ast| {
        let (left, right) = (rational(lhs, variables)?, rational(rhs, variables)?);
        Comparison::new(relation, left, right, variables)
            .ok_or_else(|| ConditionError::NotRational { span: lhs.span.clone() })
    };
    let whole = compared(relation, lhs, rhs)?;
    let divisors = divisors_in(lhs).into_iter().chain(divisors_in(rhs)).collect::<Vec<_>>();
    let first = (0..divisors.len()).filter(|&at| !divisors[..at].contains(&divisors[at]));
    let not_zero = first.map(|at| compared(Relation::NotEqual, divisors[at], &integer(0))).collect::<Result<_, _>>()?;
    Ok(whole.divided_by(not_zero))
}

/// An expression as a rational function of the variables.
fn rational(expression: &Ast, variables: &[String]) -> Result<Expr, ConditionError> {
    check(expression, variables)?;
    lower(expression).map_err(|LowerError { what, span, .. }| ConditionError::NoValue { what, span })
}

/// Says where an expression is no rational function of the variables.
fn check(expression: &Ast, variables: &[String]) -> Result<(), ConditionError> {
    let not_rational = || ConditionError::NotRational { span: expression.span.clone() };
    let demand = |holds: bool| if holds { Ok(()) } else { Err(not_rational()) };
    match &expression.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) => demand(lower(expression).is_ok()),
        ExprKind::Symbol(name) if variables.contains(name) => Ok(()),
        ExprKind::Symbol(name) => {
            Err(ConditionError::UnknownVariable { name: name.clone(), span: expression.span.clone() })
        }
        ExprKind::Unary { operator: UnaryOperator::Plus | UnaryOperator::Minus, operand } => check(operand, variables),
        ExprKind::Binary { operator, left, right } => {
            check(left, variables)?;
            check(right, variables)?;
            demand(match operator {
                BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply | BinaryOperator::Divide => {
                    true
                }
                BinaryOperator::Power => constant(right).is_some_and(is_small_integer),
                _ => false,
            })
        }
        _ => Err(not_rational()),
    }
}

fn is_small_integer(exponent: Rational) -> bool {
    exponent.is_integer() && exponent.abs() <= MAX_POWER
}

/// Everything that a rational function divides by as it is written, what stands inside before what it stands in.
fn divisors_in(function: &Ast) -> Vec<&Ast> {
    match &function.kind {
        ExprKind::Unary { operand, .. } => divisors_in(operand),
        ExprKind::Binary { operator, left, right } => {
            let mut divisors = [divisors_in(left), divisors_in(right)].concat();
            let own: Option<&Ast> = match operator {
                BinaryOperator::Divide => Some(right),
                BinaryOperator::Power => constant(right).is_some_and(|exponent| exponent < 0).then_some(left),
                _ => None,
            };
            divisors.extend(own.filter(|divisor| constant(divisor).is_none_or(|value| value.is_zero())));
            divisors
        }
        _ => Vec::new(),
    }
}

/// The value of a function that names no input.
fn constant(function: &Ast) -> Option<Rational> {
    if any(function, &|part| part.as_symbol().is_some()) {
        return None;
    }
    Exact::of(&lower(function).ok()?, &[])?.at(&[])
}
