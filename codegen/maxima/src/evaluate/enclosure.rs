//! The value of an expression between two numbers, whatever cancels on the way.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use rug::Float;

use crate::ast::{BinaryOperator, Branch, Expr, ExprKind, UnaryOperator};
use crate::exact;

use super::interval::{Interval, Result, Unknown};
use super::{power, step};

/// Angles beyond this power of two are not reduced.
const LARGEST_ANGLE: i32 = 1 << 16;

/// Two numbers between which the expression has its value at exactly these inputs, computed with so many bits.
pub(super) fn enclosure(expression: &Expr, inputs: &BTreeMap<String, Float>, precision: u32) -> Result<Interval> {
    Enclosing { inputs, precision }.value(expression)
}

/// The inputs, and the precision to work with.
struct Enclosing<'a> {
    inputs: &'a BTreeMap<String, Float>,
    precision: u32,
}

impl Enclosing<'_> {
    fn value(&self, expression: &Expr) -> Result<Interval> {
        match &expression.kind {
            ExprKind::Integer(value) => Interval::rounded(self.precision, &power::integer(value)),
            ExprKind::Float(text) => self.float(exact::double(text).ok_or(Unknown::Unsupported)?),
            ExprKind::Symbol(name) => match (self.inputs.get(name), name.as_str()) {
                (Some(value), _) => Interval::rounded(self.precision, value),
                (None, "%pi") => Interval::pi(self.precision),
                (None, "%e") => self.float(1.0)?.function("exp"),
                _ => Err(Unknown::Unsupported),
            },
            ExprKind::Unary { operator: UnaryOperator::Plus, operand } => self.value(operand),
            ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Ok(self.value(operand)?.neg()),
            ExprKind::Binary { operator: BinaryOperator::Power, left, right } => self.power(left, right),
            ExprKind::Binary { operator, left, right } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                match operator {
                    BinaryOperator::Add => left.add(&right),
                    BinaryOperator::Subtract => left.sub(&right),
                    BinaryOperator::Multiply => left.mul(&right),
                    BinaryOperator::Divide => left.div(&right),
                    _ => Err(Unknown::Unsupported),
                }
            }
            ExprKind::Call { .. } => match expression.as_call() {
                Some((name, arguments)) => self.call(name, arguments),
                None => Err(Unknown::Unsupported),
            },
            ExprKind::If { branches, otherwise } => self.branch(branches, otherwise.as_deref()),
            _ => Err(Unknown::Unsupported),
        }
    }

    fn float(&self, value: f64) -> Result<Interval> {
        Interval::rounded(self.precision, value)
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Result<Interval> {
        if base.as_symbol() == Some("%e") && !self.inputs.contains_key("%e") {
            return self.value(exponent)?.function("exp");
        }
        let value = self.value(base)?;
        let Some(exponent) = power::constant(exponent) else {
            return value.real_power(&self.value(exponent)?);
        };
        let numerator = power::integer(exponent.numer());
        let degree = power::integer(exponent.denom()).to_u32().ok_or(Unknown::Unsupported)?;
        match (numerator.cmp0(), degree) {
            (Ordering::Equal, _) => Err(Unknown::Unsupported),
            (_, 1) => value.power(&numerator),
            _ => value.root(degree)?.power(&numerator),
        }
    }

    fn call(&self, name: &str, arguments: &[Expr]) -> Result<Interval> {
        match (name, arguments) {
            ("max" | "min", [first, others @ ..]) => {
                let turned = |value: Interval| if name == "min" { value.neg() } else { value };
                let best = others
                    .iter()
                    .try_fold(turned(self.value(first)?), |best, next| Ok(best.max(&turned(self.value(next)?))))?;
                Ok(turned(best))
            }
            ("atan2", [y, x]) => Interval::angle(&self.value(y)?, &self.value(x)?),
            ("mod", [x, y]) => {
                let (x, y) = (self.value(x)?, self.value(y)?);
                x.sub(&y.mul(&x.div(&y)?.step(Float::floor)?)?)
            }
            (_, [argument]) => {
                let value = self.value(argument)?;
                match step::named(name) {
                    Some(function) => value.step(function),
                    None if value.is_beyond(LARGEST_ANGLE) && matches!(name, "sin" | "cos" | "tan") => {
                        Err(Unknown::Unsupported)
                    }
                    None => value.function(name),
                }
            }
            _ => Err(Unknown::Unsupported),
        }
    }

    fn branch(&self, branches: &[Branch], otherwise: Option<&Expr>) -> Result<Interval> {
        for branch in branches {
            if self.holds(&branch.condition)? {
                return self.value(&branch.value);
            }
        }
        self.value(otherwise.ok_or(Unknown::Unsupported)?)
    }

    /// Whether the condition is true.
    fn holds(&self, condition: &Expr) -> Result<bool> {
        match &condition.kind {
            ExprKind::Symbol(name) if name == "true" => Ok(true),
            ExprKind::Symbol(name) if name == "false" => Ok(false),
            ExprKind::Unary { operator: UnaryOperator::Not, operand } => Ok(!self.holds(operand)?),
            ExprKind::Binary { operator: BinaryOperator::And, left, right } => {
                Ok(self.holds(left)? && self.holds(right)?)
            }
            ExprKind::Binary { operator: BinaryOperator::Or, left, right } => {
                Ok(self.holds(left)? || self.holds(right)?)
            }
            ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
                let order = self.value(left)?.order(&self.value(right)?).ok_or(Unknown::Undecided)?;
                Ok(relation.holds(order))
            }
            _ => Err(Unknown::Unsupported),
        }
    }
}
