//! Expressions to MPFR numbers.

mod error;
mod function;
mod power;
mod root;
mod scope;
mod stable;

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
    Scope::new(inputs, precision.clamp(prec_min(), prec_max())).value(expression)
}
