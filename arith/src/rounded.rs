//! `Rounded`: a result in `f64`, and what rounding made of it.

use crate::soft_float::SoftFloat;

/// A result in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounded {
    /// The number: infinite where it overflows, NaN where there is none.
    pub value: f64,
    /// What rounding made of it.
    pub fate: Fate,
}

/// What rounding to `f64` makes of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It has the digits that were promised.
    Kept,
    /// It is beyond the largest number.
    Overflows,
    /// It loses digits below the smallest normal number.
    Underflows,
    /// The formula has no value: it divides by zero, or takes the root of a negative number.
    Missing,
    /// The largest balls do not tell it, or whether its inputs lie in the domain.
    Undecided,
}

impl Rounded {
    /// Nothing is known.
    pub(crate) const UNDECIDED: Self = Rounded { value: f64::NAN, fate: Fate::Undecided };

    /// A number that is the result, to its digits.
    pub(crate) fn kept(value: f64) -> Self {
        Rounded { value, fate: Fate::Kept }
    }

    pub(crate) fn of(result: SoftFloat) -> Self {
        let value = result.to_f64();
        Self::to_nearest(value, result == SoftFloat::from_f64(value))
    }

    /// A number that was rounded to nearest, and whether that left it as it was; NaN where there was none.
    pub(crate) fn to_nearest(value: f64, exact: bool) -> Self {
        let fate = match value {
            _ if value.is_nan() => Fate::Missing,
            _ if value.is_infinite() => Fate::Overflows,
            _ if !value.is_normal() && !exact => Fate::Underflows,
            _ => Fate::Kept,
        };
        Rounded { value, fate }
    }
}

/// A result in `f64`, and how far it may be from the exact one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified {
    /// The result.
    pub rounded: Rounded,
    /// A bound of its error; infinite or NaN where there is none.
    pub error: f64,
}

impl Default for Certified {
    fn default() -> Self {
        Self::UNDECIDED
    }
}

impl Certified {
    /// Nothing is known.
    pub(crate) const UNDECIDED: Self = Certified { rounded: Rounded::UNDECIDED, error: f64::NAN };
}
