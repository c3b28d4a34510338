//! The names an expression sees, and its value among them.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::Range;

use rug::Float;
use rug::float::Constant;

use crate::ast::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use crate::exact;

use super::condition::Comparing;
use super::error::EvalError;
use super::notes::Notes;
use super::{function, power, step};

pub(super) type Result<T> = std::result::Result<T, EvalError>;

/// A name bound inside the expression.
pub(super) struct Local<'a> {
    /// The name.
    pub name: &'a str,
    /// Its value.
    pub value: &'a Float,
    /// The name bound around it.
    pub outer: Option<&'a Local<'a>>,
}

/// The names an expression sees, and the precision to work with.
#[derive(Clone, Copy)]
pub(super) struct Scope<'a> {
    inputs: &'a BTreeMap<String, Float>,
    local: Option<&'a Local<'a>>,
    /// Bits of every result.
    pub precision: u32,
    /// What is noted on the way.
    pub notes: &'a Notes,
}

impl<'a> Scope<'a> {
    pub(super) fn new(inputs: &'a BTreeMap<String, Float>, precision: u32, notes: &'a Notes) -> Self {
        Self { inputs, local: None, precision, notes }
    }

    /// Takes note of how far the value of a function that is no root is from 1, as a power of two: it is not seen in the inputs.
    pub(super) fn reached(&self, value: Float) -> Float {
        let exponent = value.get_exp().map_or(0, i32::unsigned_abs);
        self.notes.reach.set(self.notes.reach.get().max(exponent));
        value
    }

    /// The innermost name bound inside the expression.
    pub(super) fn local(&self) -> Option<&'a Local<'a>> {
        self.local
    }

    /// The same scope with one more name.
    pub(super) fn with<'b>(&self, local: &'b Local<'b>) -> Scope<'b>
    where
        'a: 'b,
    {
        Scope { inputs: self.inputs, local: Some(local), precision: self.precision, notes: self.notes }
    }

    /// `value` rounded to the precision.
    pub(super) fn float<T>(&self, value: T) -> Float
    where
        Float: rug::Assign<T>,
    {
        Float::with_val(self.precision, value)
    }

    /// The value of the expression: always finite.
    pub(super) fn value(&self, expression: &Expr) -> Result<Float> {
        let span = &expression.span;
        let value = match &expression.kind {
            ExprKind::Integer(value) => self.float(&power::integer(value)),
            ExprKind::Float(text) => self.float(exact::double(text).unwrap_or(f64::INFINITY)),
            ExprKind::BigFloat(text) => self.big_float(text),
            ExprKind::Symbol(name) => self.symbol(name, span)?,
            ExprKind::Unary { operator, operand } => self.unary(*operator, operand, span)?,
            ExprKind::Binary { operator, left, right } => self.binary(*operator, left, right, span)?,
            ExprKind::Call { .. } => self.call(expression)?,
            ExprKind::If { branches, otherwise } => {
                let side = self.side(branches, otherwise.as_deref())?;
                self.value(side.ok_or_else(|| EvalError::NoBranch { span: span.clone() })?)?
            }
            other => return Err(not_numeric(other, span)),
        };
        finite(value, span)
    }

    fn big_float(&self, text: &str) -> Float {
        let text = text.replace(['b', 'B'], "e");
        Float::parse(text).map_or_else(|_| self.float(f64::NAN), |parsed| self.float(parsed))
    }

    fn symbol(&self, name: &str, span: &Range<usize>) -> Result<Float> {
        let mut local = self.local;
        while let Some(bound) = local {
            if bound.name == name {
                return Ok(self.float(bound.value));
            }
            local = bound.outer;
        }
        match (self.inputs.get(name), name) {
            (Some(value), _) => Ok(self.float(value)),
            (None, "%pi") => Ok(self.float(Constant::Pi)),
            (None, "%e") => Ok(self.float(1).exp()),
            _ => Err(EvalError::UnknownVariable { name: name.to_owned(), span: span.clone() }),
        }
    }

    fn unary(&self, operator: UnaryOperator, operand: &Expr, span: &Range<usize>) -> Result<Float> {
        match operator {
            UnaryOperator::Plus => self.value(operand),
            UnaryOperator::Minus => Ok(-self.value(operand)?),
            UnaryOperator::Not => Err(EvalError::NotNumeric { what: "a condition", span: span.clone() }),
            UnaryOperator::Factorial | UnaryOperator::DoubleFactorial => {
                Err(EvalError::NotNumeric { what: "a factorial", span: span.clone() })
            }
        }
    }

    fn binary(&self, operator: BinaryOperator, left: &Expr, right: &Expr, span: &Range<usize>) -> Result<Float> {
        match operator {
            BinaryOperator::Add => Ok(self.value(left)? + self.value(right)?),
            BinaryOperator::Subtract => Ok(self.value(left)? - self.value(right)?),
            BinaryOperator::Multiply => Ok(self.value(left)? * self.value(right)?),
            BinaryOperator::Divide => self.quotient(left, right),
            BinaryOperator::Power => power::power(self, left, right),
            other if other.is_comparison() => Err(EvalError::NotNumeric { what: "a condition", span: span.clone() }),
            _ => Err(EvalError::NotNumeric { what: "an expression with this operator", span: span.clone() }),
        }
    }

    fn quotient(&self, left: &Expr, right: &Expr) -> Result<Float> {
        let (dividend, divisor) = (self.value(left)?, self.value(right)?);
        if divisor.is_zero() {
            return Err(EvalError::DivisionByZero { span: right.span.clone() });
        }
        Ok(dividend / divisor)
    }

    fn call(&self, expression: &Expr) -> Result<Float> {
        match expression.as_call() {
            Some((name, arguments)) => function::call(self, name, arguments, &expression.span),
            None => Err(EvalError::NotNumeric { what: "a call of an expression", span: expression.span.clone() }),
        }
    }
}

impl Comparing for Scope<'_> {
    type Error = EvalError;

    fn order(&self, comparison: &Expr, left: &Expr, right: &Expr) -> Result<Ordering> {
        let order = step::order(self.notes, &self.value(left)?, &self.value(right)?);
        order.ok_or_else(|| self.no_condition(comparison))
    }

    fn no_condition(&self, expression: &Expr) -> EvalError {
        EvalError::NotACondition { span: expression.span.clone() }
    }
}

fn finite(value: Float, span: &Range<usize>) -> Result<Float> {
    if value.is_nan() {
        return Err(EvalError::NotReal { span: span.clone() });
    }
    if value.is_infinite() {
        return Err(EvalError::NotFinite { span: span.clone() });
    }
    Ok(value)
}

fn not_numeric(kind: &ExprKind, span: &Range<usize>) -> EvalError {
    let what = match kind {
        ExprKind::String(_) => "a string",
        ExprKind::Quote { .. } => "a quoted expression",
        ExprKind::Subscript { .. } => "a subscripted name",
        ExprKind::List(_) => "a list",
        ExprKind::Set(_) => "a set",
        ExprKind::Loop { .. } => "a loop",
        ExprKind::Ev { .. } => "an evaluation with options",
        _ => "a sequence of statements",
    };
    EvalError::NotNumeric { what, span: span.clone() }
}
