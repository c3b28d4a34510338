//! The magnitude.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;

/// The magnitude of a number.
pub(super) struct Abs;

impl Definition for Abs {
    const PROPERTIES: Properties = Properties {
        name: "abs",
        noun: "magnitude",
        maxima: "abs(x)",
        exponent: Some((1, 1)),
        domain: Domain::All,
        signs: [signs::POSITIVE, signs::ZERO, signs::POSITIVE],
        parity: Parity::Even,
        increases: false,
        derivative: None,
        error: Units::NONE,
        double_double_error: 0.0,
        cost: Cost::FREE,
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        x.abs()
    }

    #[inline(always)]
    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        if x.round() < 0.0 { -x } else { x }
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.magnitude()
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.magnitude()
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.abs_mut();
    }
}
