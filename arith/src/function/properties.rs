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
    /// The p of |f(x)| = |x|^p, as a fraction. A relative error of the argument becomes p of it, and magnitudes follow. (A
    /// function that is no power will make this optional, and ask all who read it what they do without.)
    pub exponent: (u32, u32),
    /// The sign of its value at numbers below zero, at zero and above; `None` where it has no value.
    pub signs: [Option<Ordering>; 3],
    /// Whether a larger argument has a larger value, wherever it has one.
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
