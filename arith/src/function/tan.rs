//! The tangent.

use super::{Cost, Definition, Domain, Parity, Properties, elementary, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::{ELEMENTARY, double_double};
use crate::soft_float::SoftFloat;

/// The tangent of an angle in radians.
pub(super) struct Tan;

impl Definition for Tan {
    const PROPERTIES: Properties = Properties {
        name: "tan",
        noun: "tangent",
        maxima: "tan(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::ANY, signs::ZERO, signs::ANY],
        parity: Parity::Odd,
        increases: false,
        derivative: Some("1.0 + y * y"),
        error: ELEMENTARY,
        double_double_error: double_double::ELEMENTARY,
        cost: Cost::of_elementary(30),
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::tan(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        elementary::double_double(x, Self::soft)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        elementary::soft!(x, tan)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.tan()
    }

    /// With t the tangent of d, |tan(x + d) - tan x| = |t| (1 + y^2)/|1 - y t|, and |t| <= 1.1 |d| for |d| <= 1/2.
    #[inline(always)]
    fn spread(_: f64, y: f64, error: f64) -> f64 {
        let (tangent, size) = (1.1 * error, y.abs());
        if error <= 0.5 && size * tangent <= 0.5 {
            tangent * (1.0 + size * size) / (1.0 - size * tangent)
        } else {
            f64::INFINITY
        }
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.tan_mut();
    }
}
