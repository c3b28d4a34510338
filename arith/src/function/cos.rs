//! The cosine.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The cosine of an angle in radians.
pub(super) struct Cos;

impl Definition for Cos {
    const PROPERTIES: Properties = Properties {
        name: "cos",
        noun: "cosine",
        maxima: "cos(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::ANY, signs::POSITIVE, signs::ANY],
        parity: Parity::Even,
        increases: false,
        derivative: Some("-sin(x)"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(20),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::cos(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, cos)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.cos()
    }

    /// The slope is at most 1.
    #[inline(always)]
    fn spread(_: f64, _: f64, error: f64) -> f64 {
        error
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.cos_mut();
    }
}
