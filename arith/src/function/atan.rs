//! The arc tangent.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The angle from -pi/2 to pi/2 of a tangent.
pub(super) struct Atan;

impl Definition for Atan {
    const PROPERTIES: Properties = Properties {
        name: "atan",
        noun: "angle",
        maxima: "atan(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::NEGATIVE, signs::ZERO, signs::POSITIVE],
        parity: Parity::Odd,
        increases: true,
        derivative: Some("1.0 / (1.0 + x * x)"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(25),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::atan(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, atan)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.atan()
    }

    /// The slope is at most 1.
    #[inline(always)]
    fn spread(_: f64, _: f64, error: f64) -> f64 {
        error
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.atan_mut();
    }
}
