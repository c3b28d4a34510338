//! The arithmetic of arbitrary precision in which judges run programs.

use core::cmp::Ordering;

use rug::Float;
use rug::float::Constant;
use rug::ops::NegAssign;

use crate::function::Function;
use crate::limits::MAX_DEGREE;
use crate::real::Real;
use crate::root::{Term, bound, steps, terms};
use crate::terms::Terms;

/// A number of arbitrary precision, correctly rounded to nearest by every operation.
///
/// A result takes the larger precision of its operands. A compensated expression is evaluated at that same precision:
/// raise the precision until the result stops changing.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Mpfr(pub Float);

impl Mpfr {
    /// `value` (exactly, if `precision` is at least 53 bits) at `precision` bits.
    pub fn new(precision: u32, value: f64) -> Self {
        Mpfr(Float::with_val(precision, value))
    }

    /// At the larger precision of `self` and `other`, what `combine` makes of the two.
    fn with(&self, other: &Self, combine: impl Fn(&mut Float, &Float)) -> Self {
        let mut result = Float::with_val(self.0.prec().max(other.0.prec()), &self.0);
        combine(&mut result, &other.0);
        Mpfr(result)
    }
}

impl From<Float> for Mpfr {
    fn from(value: Float) -> Self {
        Mpfr(value)
    }
}

impl Real for Mpfr {
    type Extended = Mpfr;

    fn literal(&self, value: f64) -> Self {
        Mpfr::new(self.0.prec(), value)
    }

    fn pi(&self) -> Self {
        Mpfr(Float::with_val(self.0.prec(), Constant::Pi))
    }

    fn nan(&self) -> Self {
        Mpfr::new(self.0.prec(), f64::NAN)
    }

    fn add(&self, other: &Self) -> Self {
        self.with(other, |a, b| *a += b)
    }

    fn sub(&self, other: &Self) -> Self {
        self.with(other, |a, b| *a -= b)
    }

    fn mul(&self, other: &Self) -> Self {
        self.with(other, |a, b| *a *= b)
    }

    fn div(&self, other: &Self) -> Self {
        self.with(other, |a, b| *a /= b)
    }

    fn neg(&self) -> Self {
        self.with(self, |a, _| a.neg_assign())
    }

    fn call(&self, function: Function) -> Self {
        self.with(self, |a, _| function.mpfr(a))
    }

    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        let precision = coefficients.iter().map(|c| c.0.prec()).fold(self.0.prec(), u32::max);
        let root = bound_of(coefficients).map(|bound| fall(coefficients, bound, precision));
        Mpfr(Float::with_val(precision, root.unwrap_or_else(|| Float::with_val(precision, f64::NAN))))
    }

    fn two_sum(&self, other: &Self) -> Mpfr {
        self.add(other)
    }

    fn two_product(&self, other: &Self) -> Mpfr {
        self.mul(other)
    }

    fn extended_neg(extended: &Mpfr) -> Mpfr {
        extended.neg()
    }

    fn extended_add_exact(extended: &Mpfr, exact: &Self) -> Mpfr {
        extended.add(exact)
    }

    fn extended_add(left: &Mpfr, right: &Mpfr) -> Mpfr {
        left.add(right)
    }

    fn extended_mul_exact(extended: &Mpfr, exact: &Self) -> Mpfr {
        extended.mul(exact)
    }

    fn extended_mul(left: &Mpfr, right: &Mpfr) -> Mpfr {
        left.mul(right)
    }

    fn compensated(extended: &Mpfr, _: f64, _: &[&Self], _: Terms) -> Self {
        extended.clone()
    }

    fn residual(extended: &Mpfr) -> Self {
        extended.clone()
    }
}

/// The exponent of a power of two above the root, where there is one.
fn bound_of(coefficients: &[Mpfr]) -> Option<i64> {
    if coefficients.len() > MAX_DEGREE + 1 || !coefficients.iter().all(Mpfr::is_finite) {
        return None;
    }
    // MPFR counts exponents from the point before the leading bit.
    let term = |c: &Mpfr| Some(Term { negative: c.0.is_sign_negative(), exponent: i64::from(c.0.get_exp()?) - 1 });
    bound(&terms(coefficients, term))
}

/// Falls from 2^bound onto the root, in some digits more than asked for.
fn fall(coefficients: &[Mpfr], bound: i64, precision: u32) -> Float {
    const GUARD_BITS: u32 = 32;
    let working = precision + GUARD_BITS;
    let mut x = Float::with_val(working, 1) << i32::try_from(bound).unwrap_or(i32::MAX);
    // Each step in the end doubles the digits, of which `steps` counts on 64.
    for _ in 0..steps(coefficients.len()) + working.ilog2() as usize {
        let (value, slope) = horner(coefficients, &x);
        let next = Float::with_val(working, &x - value / slope);
        if next.partial_cmp(&x) != Some(Ordering::Less) {
            break;
        }
        x = next;
    }
    x
}

/// The polynomial and its derivative at `x`.
fn horner(coefficients: &[Mpfr], x: &Float) -> (Float, Float) {
    let zero = || Float::with_val(x.prec(), 0);
    coefficients.iter().rev().fold((zero(), zero()), |(value, slope), c| (value.clone() * x + &c.0, slope * x + value))
}
