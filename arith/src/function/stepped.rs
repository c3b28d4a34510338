//! What functions whose values are integers share as entries of the table.

use core::cmp::Ordering;

use super::{Cost, Definition, Domain, Parity, Properties};
use crate::ball::Ball;
use crate::double_double::DoubleDoubleWith;
use crate::error_model::Units;
use crate::soft_float::SoftFloat;
use crate::step::{self, Step};

/// A function whose values are integers: exact in every arithmetic, never decreasing, without a derivative.
pub(super) trait Stepped {
    const NAME: &'static str;
    const NOUN: &'static str;
    const MAXIMA: &'static str;
    const SIGNS: [&'static [Ordering]; 3];
    const PARITY: Parity;

    /// Which integer it is.
    const STEP: Step;

    /// In `f64`.
    fn in_double(x: f64) -> f64;

    /// What makes integers of both parts of a double-double.
    #[inline(always)]
    fn of_parts<const FUSED: bool>(_: DoubleDoubleWith<FUSED>) -> fn(f64) -> f64 {
        Self::in_double
    }

    /// In MPFR.
    #[cfg(any(test, feature = "mpfr"))]
    fn in_mpfr(x: &mut rug::Float);
}

impl<F: Stepped> Definition for F {
    const PROPERTIES: Properties = Properties {
        name: F::NAME,
        noun: F::NOUN,
        maxima: F::MAXIMA,
        exponent: None,
        domain: Domain::All,
        signs: F::SIGNS,
        parity: F::PARITY,
        increases: true,
        derivative: None,
        error: Units::NONE,
        double_double_error: 0.0,
        cost: Cost::FREE,
    };

    #[inline(always)]
    fn double(x: f64) -> f64 {
        F::in_double(x)
    }

    fn double_double<const FUSED: bool>(x: DoubleDoubleWith<FUSED>) -> DoubleDoubleWith<FUSED> {
        step::double_double(x, F::of_parts(x))
    }

    fn soft(x: SoftFloat) -> SoftFloat {
        x.stepped(F::STEP)
    }

    fn ball<'a, const L: usize>(x: &Ball<'a, L>) -> Ball<'a, L> {
        x.stepped(F::STEP)
    }

    #[inline(always)]
    fn spread(x: f64, y: f64, error: f64) -> f64 {
        step::spread(x, y, error, F::in_double)
    }

    #[cfg(any(test, feature = "mpfr"))]
    fn mpfr(x: &mut rug::Float) {
        F::in_mpfr(x);
    }
}
