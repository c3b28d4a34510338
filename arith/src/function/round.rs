//! The nearest integer.

use super::{Cost, Definition, Domain, Parity, Properties, signs};
use crate::ball::Ball;
use crate::double_double::DoubleDouble;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
use crate::step::{self, Step};

/// The nearest integer; of two that are as near, the even one.
pub(super) struct Round;

impl Definition for Round {
    const PROPERTIES: Properties = Properties {
        name: "round",
        noun: "nearest integer",
        maxima: "round(x)",
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
        libm::rint(x)
    }

    fn double_double(x: DoubleDouble) -> DoubleDouble {
        let (high, low) = (x.round(), x.low());
        // the low part decides where the high one lies in the middle between two integers
        let way = match (high - libm::trunc(high)).abs() {
            0.5 if low < 0.0 => libm::floor,
            0.5 if low > 0.0 => libm::ceil,
            _ => libm::rint,
        };
        step::double_double(x, way)
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.stepped(Step::Round)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.stepped(Step::Round)
    }

    #[inline(always)]
    fn spread(x: f64, y: f64, error: f64) -> f64 {
        step::spread(x, y, error, Self::double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        x.round_even_mut();
    }
}
