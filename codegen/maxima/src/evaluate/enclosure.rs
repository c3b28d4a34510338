//! The value of an expression between two numbers, whatever cancels on the way.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use rug::Float;

use crate::ast::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use crate::exact;

use super::condition::Comparing;
use super::interval::{Interval, Result, Unknown};
use super::{function, power, step};

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
            ExprKind::If { branches, otherwise } => {
                self.value(self.side(branches, otherwise.as_deref())?.ok_or(Unknown::Unsupported)?)
            }
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
                    None if function::is_periodic(name) && value.is_beyond(function::LARGEST_ANGLE) => {
                        Err(Unknown::Unsupported)
                    }
                    None => value.function(name),
                }
            }
            _ => Err(Unknown::Unsupported),
        }
    }
}

impl Comparing for Enclosing<'_> {
    type Error = Unknown;

    fn order(&self, _: &Expr, left: &Expr, right: &Expr) -> Result<Ordering> {
        self.value(left)?.order(&self.value(right)?).ok_or(Unknown::Undecided)
    }

    fn no_condition(&self, _: &Expr) -> Unknown {
        Unknown::Unsupported
    }
}
