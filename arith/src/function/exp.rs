//! The exponential function.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The exponential function.
pub(super) struct Exp;

impl Definition for Exp {
    const PROPERTIES: Properties = Properties {
        name: "exp",
        noun: "exponential function",
        maxima: "exp(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::POSITIVE, signs::POSITIVE, signs::POSITIVE],
        parity: Parity::None,
        increases: true,
        derivative: Some("y"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(20),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::exp(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::exp(x)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.exp()
    }

    /// e^(x + d) - e^x = e^x (e^d - 1), and |e^d - 1| <= |d| (1 + |d|) for |d| <= 1.
    #[inline(always)]
    fn spread(_: f64, y: f64, error: f64) -> f64 {
        if error <= 1.0 { y * error * (1.0 + error) } else { f64::INFINITY }
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.exp_mut();
    }
}
