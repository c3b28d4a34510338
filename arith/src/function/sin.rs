//! The sine.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The sine of an angle in radians.
pub(super) struct Sin;

impl Definition for Sin {
    const PROPERTIES: Properties = Properties {
        name: "sin",
        noun: "sine",
        maxima: "sin(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::ANY, signs::ZERO, signs::ANY],
        parity: Parity::Odd,
        increases: false,
        derivative: Some("cos(x)"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(20),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::sin(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, sin)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.sin()
    }

    /// The slope is at most 1.
    #[inline(always)]
    fn spread(_: f64, _: f64, error: f64) -> f64 {
        error
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.sin_mut();
    }
}
