//! The integer part of a number.

use core::cmp::Ordering;

use super::stepped::Stepped;
use super::{Parity, signs};
use crate::double_double::DoubleDoubleWith;
use crate::step::Step;

/// The integer part: the nearest integer on the way to zero.
pub(super) struct Truncate;

impl Stepped for Truncate {
    const NAME: &'static str = "truncate";
    const NOUN: &'static str = "integer part";
    const MAXIMA: &'static str = "truncate(x)";
    const SIGNS: [&'static [Ordering]; 3] = [signs::NOT_POSITIVE, signs::ZERO, signs::NOT_NEGATIVE];
    const PARITY: Parity = Parity::Odd;
    const STEP: Step = Step::Truncate;

    #[inline(always)]
    fn in_double(x: f64) -> f64 {
        libm::trunc(x)
    }

    fn of_parts<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> fn(f64) -> f64 {
        if x.round() < 0.0 { libm::ceil } else { libm::floor }
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn in_mpfr(x: &mut rug::Float) {
        x.trunc_mut();
    }
}
