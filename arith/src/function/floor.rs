//! The largest integer that is not larger than a number.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDouble;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
use crate::step::{self, Step};

/// The largest integer that is not larger.
pub(super) struct Floor;

impl Definition for Floor {
    const PROPERTIES: Properties = Properties {
        name: "floor",
        noun: "floor",
        maxima: "floor(x)",
        exponent: None,
        domain: Domain::All,
        signs: [signs::NEGATIVE, signs::ZERO, signs::NOT_NEGATIVE],
        parity: Parity::None,
        increases: true,
        derivative: None,
        error: Units::NONE,
        double_double_error: 0.0,
        cost: Cost::FREE,
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        libm::floor(x)
    }

    fn double_double(x: DoubleDouble) -> DoubleDouble {
        step::double_double(x, Self::double)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.stepped(Step::Floor)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.stepped(Step::Floor)
    }

    #[inline(always)]
    fn spread(x: f64, y: f64, error: f64) -> f64 {
        step::spread(x, y, error, Self::double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.floor_mut();
    }
}
