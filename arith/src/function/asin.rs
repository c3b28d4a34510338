//! The arc sine.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The angle from -pi/2 to pi/2 of a sine.
pub(super) struct Asin;

impl Definition for Asin {
    const PROPERTIES: Properties = Properties {
        name: "asin",
        noun: "angle",
        maxima: "asin(x)",
        exponent: None,
        domain: Domain::Unit,
        signs: [signs::NEGATIVE, signs::ZERO, signs::POSITIVE],
        parity: Parity::Odd,
        increases: true,
        derivative: Some("1.0 / sqrt(1.0 - x * x)"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(30),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::asin(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, asin)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.asin()
    }

    /// The slope is 1/sqrt(1 - x^2), which is at most 1/sqrt(1 - |x|).
    #[inline(always)]
    fn spread(x: f64, _: f64, error: f64) -> f64 {
        elementary::steepest(x, error)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.asin_mut();
    }
}
