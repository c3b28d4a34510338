//! Digits: true values in as many decimal digits as are asked for.

use rug::Float;

/// The most digits that can be asked for: references settle far below the highest precision that they are tried with.
pub const MAX_DIGITS: u32 = 1000;

/// Bits of a value beyond its digits, so that rounding it to decimal is right.
const SPARE_BITS: u32 = 16;

/// How many bits of a value make so many digits of it right, but never fewer than an error in ulp needs.
pub fn bits(digits: u32) -> u32 {
    // log2(10) < 10/3
    (digits * 10 / 3 + SPARE_BITS).max(closedform_measure::accuracy::REFERENCE_BITS)
}

/// The value in decimal, rounded to so many digits.
pub fn decimal(value: &Float, digits: u32) -> String {
    if value.is_zero() { "0".to_owned() } else { value.to_string_radix(10, Some(digits as usize)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_rounded() {
        let third = Float::with_val(bits(5), 2) / 3;
        assert_eq!(decimal(&third, 5), "6.6667e-1");
        assert_eq!(decimal(&Float::new(100), 5), "0");
    }
}
