//! Numbers to try: nasty ones by hand, and reproducible random ones.

use rug::Float;

pub use crate::random::Random;

/// Enough bits for sums and products of everything tried here to be exact.
pub const EXACT: u32 = 4300;

/// `value`, in a precision where arithmetic on it is exact.
pub fn exact(value: f64) -> Float {
    Float::with_val(EXACT, value)
}

impl Random {
    /// Of either sign, its magnitude from 2^-`spread` to 2^`spread`, with many trailing zeros or ones at times.
    pub fn number(&mut self, spread: u64) -> f64 {
        let low_ones = (1 << self.below(52)) - 1;
        let pattern = match self.below(4) {
            0 => self.bits() & !low_ones,
            1 => self.bits() | low_ones,
            _ => self.bits(),
        };
        let exponent = 1023 - spread + self.below(2 * spread);
        f64::from_bits((pattern & 0x800f_ffff_ffff_ffff) | (exponent << 52))
    }

    /// A number close to `value`, of the other sign at times: their sum cancels.
    pub fn near(&mut self, value: f64) -> f64 {
        let width = self.below(40);
        let steps = self.below(1 << width);
        let near = f64::from_bits(value.to_bits() ^ steps);
        if self.below(2) == 0 { -near } else { near }
    }
}
