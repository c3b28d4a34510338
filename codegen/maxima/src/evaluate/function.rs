//! The functions that have a value.

use std::ops::Range;

use rug::Float;

use crate::ast::Expr;

use super::error::EvalError;
use super::scope::{Result, Scope};
use super::{root, step};

/// The binary exponent up to which angles are reduced.
pub(super) const LARGEST_ANGLE: i32 = 1 << 16;

/// The value of `name(arguments)`.
pub(super) fn call(scope: &Scope, name: &str, arguments: &[Expr], span: &Range<usize>) -> Result<Float> {
    let count = |expected| EvalError::ArgumentCount {
        name: name.to_owned(),
        expected,
        found: arguments.len(),
        span: span.clone(),
    };
    match (name, arguments) {
        ("max" | "min", []) => Err(count("at least one argument")),
        ("max", _) => extreme(scope, arguments, |best, next| best.max(next)),
        ("min", _) => extreme(scope, arguments, |best, next| best.min(next)),
        ("atan2", [y, x]) => Ok(scope.value(y)?.atan2(&scope.value(x)?)),
        ("mod", [x, y]) => remainder(scope, x, y),
        ("positive_root", [polynomial, variable]) => root::positive_root(scope, polynomial, variable),
        ("atan2" | "mod" | "positive_root", _) => Err(count("two arguments")),
        (_, [argument]) if let Some(function) = step::named(name) => {
            Ok(step::value(scope.notes, function, scope.value(argument)?))
        }
        _ if step::named(name).is_some() => Err(count("one argument")),
        _ => match (simple(name), arguments) {
            (Some(function), [argument]) => {
                within_reach(name, scope.value(argument)?, span).map(|argument| scope.reached(function(argument)))
            }
            (Some(_), _) => Err(count("one argument")),
            (None, _) => Err(EvalError::UnknownFunction { name: name.to_owned(), span: span.clone() }),
        },
    }
}

fn extreme(scope: &Scope, arguments: &[Expr], better: fn(Float, &Float) -> Float) -> Result<Float> {
    let mut best = scope.value(&arguments[0])?;
    for argument in &arguments[1..] {
        best = better(best, &scope.value(argument)?);
    }
    Ok(best)
}

/// What a multiple of `y` leaves of `x`, of the sign of `y`.
fn remainder(scope: &Scope, x: &Expr, y: &Expr) -> Result<Float> {
    let (dividend, divisor) = (scope.value(x)?, scope.value(y)?);
    if divisor.is_zero() {
        return Err(EvalError::DivisionByZero { span: y.span.clone() });
    }
    let whole = step::value(scope.notes, Float::floor, dividend.clone() / &divisor);
    Ok(dividend - divisor * whole)
}

/// The argument, unless the function is periodic and the argument so large that reducing it takes for ever.
fn within_reach(name: &str, argument: Float, span: &Range<usize>) -> Result<Float> {
    if is_periodic(name) && argument.get_exp().is_some_and(|exponent| exponent > LARGEST_ANGLE) {
        return Err(EvalError::NotFinite { span: span.clone() });
    }
    Ok(argument)
}

/// Whether a function reduces its argument.
pub(super) fn is_periodic(name: &str) -> bool {
    matches!(name, "sin" | "cos" | "tan")
}

/// The functions of one argument.
fn simple(name: &str) -> Option<fn(Float) -> Float> {
    Some(match name {
        "sqrt" => Float::sqrt,
        "abs" => Float::abs,
        "exp" => Float::exp,
        "log" => Float::ln,
        "sin" => Float::sin,
        "cos" => Float::cos,
        "tan" => Float::tan,
        "asin" => Float::asin,
        "acos" => Float::acos,
        "atan" => Float::atan,
        "sinh" => Float::sinh,
        "cosh" => Float::cosh,
        "tanh" => Float::tanh,
        "asinh" => Float::asinh,
        "acosh" => Float::acosh,
        "atanh" => Float::atanh,
        "signum" => |value| if value.is_zero() { value } else { value.signum() },
        _ => return None,
    })
}
