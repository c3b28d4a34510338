//! The natural logarithm.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The natural logarithm, of positive numbers.
pub(super) struct Log;

impl Definition for Log {
    const PROPERTIES: Properties = Properties {
        name: "log",
        noun: "logarithm",
        maxima: "log(x)",
        exponent: None,
        domain: Domain::Positive,
        signs: [signs::NO_VALUE, signs::NO_VALUE, signs::ANY],
        parity: Parity::None,
        increases: true,
        derivative: Some("1.0 / x"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(20),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::log(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, ln)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.ln()
    }

    /// The slope is 1/x, which is largest at the lower end.
    #[inline(always)]
    fn spread(x: f64, _: f64, error: f64) -> f64 {
        if error < x { error / (x - error) } else { f64::INFINITY }
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.ln_mut();
    }
}
