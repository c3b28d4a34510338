//! Expressions to MPFR numbers.

mod error;
mod function;
mod power;
mod root;
mod scope;
mod stable;

use std::cell::Cell;
use std::collections::BTreeMap;

use rug::Float;
use rug::float::{prec_max, prec_min};

use crate::ast::Expr;

pub use error::EvalError;
pub use stable::{PRECISION_LIMIT, evaluate_stable};

use scope::Scope;

/// The value of the expression, every operation rounded to `precision` bits.
///
/// Digits may cancel: `evaluate_stable` raises the precision until they do not.
///
/// # Errors
///
/// A name without value, something that has no real value, or what this evaluator does not know.
pub fn evaluate(expression: &Expr, inputs: &BTreeMap<String, Float>, precision: u32) -> Result<Float, EvalError> {
    evaluate_reaching(expression, inputs, precision).0
}

/// The same, and how far the values of functions in it are from 1 at most, as a power of two.
fn evaluate_reaching(
    expression: &Expr,
    inputs: &BTreeMap<String, Float>,
    precision: u32,
) -> (Result<Float, EvalError>, u32) {
    let reach = Cell::new(0);
    let value = Scope::new(inputs, precision.clamp(prec_min(), prec_max()), &reach).value(expression);
    (value, reach.get())
}
