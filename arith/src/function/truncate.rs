//! The integer part of a number.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDouble;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
use crate::step::{self, Step};

/// The integer part: the nearest integer on the way to zero.
pub(super) struct Truncate;

impl Definition for Truncate {
    const PROPERTIES: Properties = Properties {
        name: "truncate",
        noun: "integer part",
        maxima: "truncate(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::NOT_POSITIVE, signs::ZERO, signs::NOT_NEGATIVE],
        parity: Parity::Odd,
        increases: true,
        derivative: None,
        error: Units::NONE,
        double_double_error: 0.0,
        cost: Cost::FREE,
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::trunc(x)
    }

    fn double_double(x: DoubleDouble) -> DoubleDouble {
        let way = if x.round() < 0.0 { libm::ceil } else { libm::floor };
        step::double_double(x, way)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.stepped(Step::Truncate)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.stepped(Step::Truncate)
    }

    #[inline(always)]
    fn spread(x: f64, y: f64, error: f64) -> f64 {
        step::spread(x, y, error, Self::double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.trunc_mut();
    }
}
