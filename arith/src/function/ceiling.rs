//! The smallest integer that is not smaller than a number.

use core::cmp::Ordering;

use super::stepped::Stepped;
use super::{Parity, signs};
use crate::step::Step;

/// The smallest integer that is not smaller.
pub(super) struct Ceiling;

impl Stepped for Ceiling {
    const NAME: &'static str = "ceiling";
    const NOUN: &'static str = "ceiling";
    const MAXIMA: &'static str = "ceiling(x)";
    const SIGNS: [&'static [Ordering]; 3] = [signs::NOT_POSITIVE, signs::ZERO, signs::POSITIVE];
    const PARITY: Parity = Parity::None;
    const STEP: Step = Step::Ceiling;

    #[inline(always)]
    fn in_double(x: f64) -> f64 {
        libm::ceil(x)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn in_mpfr(x: &mut rug::Float) {
        x.ceil_mut();
    }
}
