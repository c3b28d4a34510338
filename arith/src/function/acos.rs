//! The arc cosine.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The angle from 0 to pi of a cosine.
pub(super) struct Acos;

impl Definition for Acos {
    const PROPERTIES: Properties = Properties {
        name: "acos",
        noun: "angle",
        maxima: "acos(x)",
        exponent: None,
        domain: Domain::Unit,
        signs: [signs::POSITIVE, signs::POSITIVE, signs::NOT_NEGATIVE],
        parity: Parity::None,
        increases: false,
        derivative: Some("-1.0 / sqrt(1.0 - x * x)"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(30),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::acos(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, acos)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.acos()
    }

    /// The slope is that of the arc sine, but for its sign.
    #[inline(always)]
    fn spread(x: f64, _: f64, error: f64) -> f64 {
        elementary::steepest(x, error)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.acos_mut();
    }
}
