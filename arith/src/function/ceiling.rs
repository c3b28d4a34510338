//! The smallest integer that is not smaller than a number.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDouble;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
use crate::step::{self, Step};

/// The smallest integer that is not smaller.
pub(super) struct Ceiling;

impl Definition for Ceiling {
    const PROPERTIES: Properties = Properties {
        name: "ceiling",
        noun: "ceiling",
        maxima: "ceiling(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::NOT_POSITIVE, signs::ZERO, signs::POSITIVE],
        parity: Parity::None,
        increases: true,
        derivative: None,
        error: Units::NONE,
        double_double_error: 0.0,
        cost: Cost::FREE,
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::ceil(x)
    }

    fn double_double(x: DoubleDouble) -> DoubleDouble {
        step::double_double(x, Self::double)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.stepped(Step::Ceiling)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.stepped(Step::Ceiling)
    }

    #[inline(always)]
    fn spread(x: f64, y: f64, error: f64) -> f64 {
        step::spread(x, y, error, Self::double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.ceil_mut();
    }
}
