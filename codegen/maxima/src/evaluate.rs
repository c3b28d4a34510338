//! Expressions to MPFR numbers.

mod condition;
mod enclosure;
mod error;
mod function;
mod interval;
mod notes;
mod power;
mod root;
mod scope;
mod stable;
mod step;

use std::collections::BTreeMap;

use rug::Float;
use rug::float::{prec_max, prec_min};

use crate::ast::Expr;

pub use error::EvalError;
pub use stable::{PRECISION_LIMIT, evaluate_stable};

use notes::Notes;
use scope::Scope;

/// The value of the expression, every operation rounded to `precision` bits.
///
/// Digits may cancel, and a rounded number may lie on the other side of a step of `floor`: `evaluate_stable` raises the precision
/// until neither matters.
///
/// # Errors
///
/// A name without value, something that has no real value, or what this evaluator does not know.
pub fn evaluate(expression: &Expr, inputs: &BTreeMap<String, Float>, precision: u32) -> Result<Float, EvalError> {
    evaluate_noting(expression, inputs, precision, &Notes::default())
}

/// The same, with what is noted on the way.
fn evaluate_noting(
    expression: &Expr,
    inputs: &BTreeMap<String, Float>,
    precision: u32,
    notes: &Notes,
) -> Result<Float, EvalError> {
    Scope::new(inputs, precision.clamp(prec_min(), prec_max()), notes).value(expression)
}
