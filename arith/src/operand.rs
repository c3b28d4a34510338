//! `Operand`: what compensated expressions are made of, a number of 53 bits with any exponent.

use crate::float;

/// An operand: an integer times a power of two.
#[derive(Clone, Copy)]
pub(crate) struct Operand {
    pub(crate) negative: bool,
    /// At most 53 bits.
    pub(crate) significand: u64,
    pub(crate) exponent: i64,
}

impl Operand {
    /// `None` unless finite.
    pub(crate) fn of(value: f64) -> Option<Self> {
        let (significand, exponent) = float::significand(value);
        let exponent = exponent.into();
        value.is_finite().then_some(Operand { negative: value < 0.0, significand, exponent })
    }
}
