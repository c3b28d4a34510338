//! The largest integer that is not larger than a number.

use core::cmp::Ordering;

use super::stepped::Stepped;
use super::{Parity, signs};
use crate::step::Step;

/// The largest integer that is not larger.
pub(super) struct Floor;

impl Stepped for Floor {
    const NAME: &'static str = "floor";
    const NOUN: &'static str = "floor";
    const MAXIMA: &'static str = "floor(x)";
    const SIGNS: [&'static [Ordering]; 3] = [signs::NEGATIVE, signs::ZERO, signs::NOT_NEGATIVE];
    const PARITY: Parity = Parity::None;
    const STEP: Step = Step::Floor;

    #[inline(always)]
    fn in_double(x: f64) -> f64 {
        libm::floor(x)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn in_mpfr(x: &mut rug::Float) {
        x.floor_mut();
    }
}
