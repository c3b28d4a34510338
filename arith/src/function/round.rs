//! The nearest integer.

use core::cmp::Ordering;

use super::stepped::Stepped;
use super::{Parity, signs};
use crate::double_double::DoubleDoubleWith;
use crate::step::Step;

/// The nearest integer; of two that are as near, the even one.
pub(super) struct Round;

impl Stepped for Round {
    const NAME: &'static str = "round";
    const NOUN: &'static str = "nearest integer";
    const MAXIMA: &'static str = "round(x)";
    const SIGNS: [&'static [Ordering]; 3] = [signs::NOT_POSITIVE, signs::ZERO, signs::NOT_NEGATIVE];
    const PARITY: Parity = Parity::Odd;
    const STEP: Step = Step::Round;

    #[inline(always)]
    fn in_double(x: f64) -> f64 {
        libm::rint(x)
    }

    /// Where the high part lies in the middle between two integers the low one decides.
    fn of_parts<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> fn(f64) -> f64 {
        let (high, low) = (x.round(), x.low());
        match (high - libm::trunc(high)).abs() {
            0.5 if low < 0.0 => libm::floor,
            0.5 if low > 0.0 => libm::ceil,
            _ => libm::rint,
        }
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn in_mpfr(x: &mut rug::Float) {
        x.round_even_mut();
    }
}
