//! Number literals as the exact rational they stand for.

use std::ops::Range;

use miette::Diagnostic;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Zero};
use thiserror::Error;

use crate::ast::{Expr, ExprKind};

/// The largest power of ten that is written out.
pub const EXPONENT_LIMIT: i64 = 10_000;

/// Why an expression has no exact value.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[non_exhaustive]
pub enum ExactError {
    /// The expression is no number literal.
    #[error("not a number")]
    #[diagnostic(help("write an integer, a float or a bigfloat"))]
    NotANumber {
        /// Where it stands.
        #[label("not a number")]
        span: Range<usize>,
    },
    /// The number is beyond all doubles, or has an exponent beyond reason.
    #[error("number too large")]
    #[diagnostic(help("floats end at 1.8e308, exponents of bigfloats at {EXPONENT_LIMIT}"))]
    TooLarge {
        /// Where it stands.
        #[label("too large")]
        span: Range<usize>,
    },
}

/// The exact value of a number literal: of a float the binary double Maxima rounds it to, of a bigfloat its decimals.
///
/// # Errors
///
/// The expression is no number literal, or one that is too large to be written out.
pub fn rational(expression: &Expr) -> Result<BigRational, ExactError> {
    let span = expression.span.clone();
    match &expression.kind {
        ExprKind::Integer(value) => Ok(BigRational::from_integer(value.clone())),
        ExprKind::Float(text) => double(text).and_then(BigRational::from_float).ok_or(ExactError::TooLarge { span }),
        ExprKind::BigFloat(text) => decimal(text).ok_or(ExactError::TooLarge { span }),
        _ => Err(ExactError::NotANumber { span }),
    }
}

/// The double that the text of a `Float` stands for: `1.5`, `1d0`, `2.e3`; none beyond all doubles.
#[must_use]
pub fn double(text: &str) -> Option<f64> {
    let text = text.replace(|c: char| c.is_ascii_alphabetic(), "e");
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

/// The decimal value of the text of a number, whatever its exponent letter.
fn decimal(text: &str) -> Option<BigRational> {
    let (mantissa, exponent) = text.split_once(|c: char| c.is_ascii_alphabetic()).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
    let exponent: i64 = exponent.parse().ok().filter(|e: &i64| e.abs() <= EXPONENT_LIMIT)?;
    Some(scaled(digits, exponent - i64::try_from(fraction.len()).ok()?))
}

/// `digits * 10^exponent`
fn scaled(digits: BigInt, exponent: i64) -> BigRational {
    if digits.is_zero() {
        return BigRational::zero();
    }
    let power = BigInt::from(10).pow(exponent.unsigned_abs());
    if exponent < 0 { BigRational::new(digits, power) } else { BigRational::from_integer(digits * power) }
}
