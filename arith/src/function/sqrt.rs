//! The square root.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ROUNDING, double_double};
use crate::float;
use crate::soft_float::SoftFloat;

/// The square root; none below zero.
pub(super) struct Sqrt;

/// The root of a number in `f64`, which the processor computes.
const IN_DOUBLE: u32 = 10;

impl Definition for Sqrt {
    const PROPERTIES: Properties = Properties {
        name: "sqrt",
        noun: "square root",
        maxima: "sqrt(x)",
        exponent: Some((1, 2)),
        domain: Domain::NotNegative,
        signs: [signs::NO_VALUE, signs::ZERO, signs::POSITIVE],
        parity: Parity::None,
        increases: true,
        derivative: Some("1.0 / (2.0 * y)"),
        error: ROUNDING,
        double_double_error: double_double::ROOT,
        cost: Cost { double: IN_DOUBLE, double_double: 9 + Cost::DIVISION + IN_DOUBLE, ball: 1_100 },
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        float::sqrt(x)
    }

    #[inline(always)]
    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        x.sqrt()
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.root(2, float::sqrt)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.root(2, float::sqrt)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.sqrt_mut();
    }
}
