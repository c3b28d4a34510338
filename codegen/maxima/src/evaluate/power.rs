//! Powers, with exact exponents where they are written as numbers.

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use rug::integer::Order;
use rug::ops::Pow;
use rug::{Float, Integer};

use crate::ast::{BinaryOperator, Expr, ExprKind, UnaryOperator};

use super::error::EvalError;
use super::scope::{Result, Scope};

/// The same integer for MPFR.
pub(super) fn integer(value: &BigInt) -> Integer {
    let magnitude = Integer::from_digits(&value.magnitude().to_u64_digits(), Order::Lsf);
    if value.sign() == Sign::Minus { -magnitude } else { magnitude }
}

/// `base^exponent`; an odd root of a negative number is the real one, as in Maxima.
pub(super) fn power(scope: &Scope, base: &Expr, exponent: &Expr) -> Result<Float> {
    let value = scope.value(base)?;
    match constant(exponent) {
        Some(exponent) => rational_power(scope, value, &exponent, base),
        None => {
            let exponent = scope.value(exponent)?;
            if value.is_zero() && !exponent.is_sign_positive() {
                return Err(EvalError::DivisionByZero { span: base.span.clone() });
            }
            Ok(scope.reached(value.pow(exponent)))
        }
    }
}

fn rational_power(scope: &Scope, value: Float, exponent: &BigRational, base: &Expr) -> Result<Float> {
    let not_real = || EvalError::NotReal { span: base.span.clone() };
    if exponent.is_zero() {
        // x^0 is 1 for every x, as Maxima simplifies it; 0^0 is an error there
        let zero = constant(base).is_some_and(|base| base.is_zero());
        return if zero { Err(not_real()) } else { Ok(scope.float(1)) };
    }
    if value.is_zero() && *exponent < BigRational::zero() {
        return Err(EvalError::DivisionByZero { span: base.span.clone() });
    }
    let degree = exponent.denom().to_u32().ok_or_else(not_real)?;
    if degree % 2 == 0 && value.is_sign_negative() && !value.is_zero() {
        return Err(not_real());
    }
    let root = if degree == 1 { value } else { value.root(degree) };
    Ok(if exponent.numer().is_one() { root } else { scope.float(Pow::pow(&root, &integer(exponent.numer()))) })
}

/// The value of an exponent that is written with integers, signs and quotients only.
pub(super) fn constant(expression: &Expr) -> Option<BigRational> {
    match &expression.kind {
        ExprKind::Integer(value) => Some(BigRational::from_integer(value.clone())),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(-constant(operand)?),
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right } => {
            let divisor = constant(right).filter(|divisor| !divisor.is_zero())?;
            Some(constant(left)? / divisor)
        }
        _ => None,
    }
}
