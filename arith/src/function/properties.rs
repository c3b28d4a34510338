//! `Properties`: what holds of a function, whatever evaluates it.

use core::cmp::Ordering;

use super::cost::Cost;
use crate::error_model::Units;

/// What holds of a function.
#[derive(Clone, Copy, Debug)]
pub struct Properties {
    /// Its name in the kernel language.
    pub name: &'static str,
    /// What its value is called.
    pub noun: &'static str,
    /// How worksheets write it, of `x`.
    pub maxima: &'static str,
    /// The p of |f(x)| = |x|^p, as a fraction, of a function that is a power. A relative error of the argument becomes p of it, and
    /// magnitudes follow.
    pub exponent: Option<(u32, u32)>,
    /// Where it has a value.
    pub domain: Domain,
    /// The signs that its value can have at numbers below zero, at zero and above; none where it has no value.
    pub signs: [&'static [Ordering]; 3],
    /// What becomes of its value when the argument turns its sign.
    pub parity: Parity,
    /// Whether a larger argument never has a smaller value, wherever it has one.
    pub increases: bool,
    /// The derivative, in the kernel language, of the argument `x` and the value `y`; `None` where it has none everywhere.
    pub derivative: Option<&'static str>,
    /// The error of its value in `f64`.
    pub error: Units,
    /// The error of its value in double-double, in units of u^2.
    pub double_double_error: f64,
    /// What it costs.
    pub cost: Cost,
}

/// Where a function has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Everywhere.
    All,
    /// At 0 and above.
    NotNegative,
    /// Above 0.
    Positive,
    /// From -1 to 1.
    Unit,
}

impl Domain {
    /// Whether the number is in it.
    #[inline(always)]
    #[must_use]
    pub fn holds(self, x: f64) -> bool {
        match self {
            Self::All => true,
            Self::NotNegative => x >= 0.0,
            Self::Positive => x > 0.0,
            Self::Unit => x.abs() <= 1.0,
        }
    }
}

/// What becomes of a function's value when the argument turns its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// It stays.
    Even,
    /// It turns its sign.
    Odd,
    /// Neither.
    None,
}
