//! Between which magnitudes the theorems of the error model hold, as exponents of two.

/// A product in this range of numbers up to 2^[`FACTOR`] is error-free: one of 2^-969 or more has an error of no bits below
/// the smallest number, 2^-1074, and one of 2^1022 or less has parts that do not overflow.
pub const PRODUCT: (i64, i64) = (-969, 1022);

/// The largest factor whose split, some 2^27 times as large, is finite.
pub const FACTOR: i64 = 996;

/// A step in double-double from numbers in this range to one in it loses no digits.
pub const STEP: (i64, i64) = (-450, 450);

/// What a product adds to the sum of the magnitudes of its terms: times u^2, still some 2^8 times what one underflow loses.
pub const UNDERFLOW: i64 = -960;

/// Whether a number is a normal power of two, or the negative of one.
#[must_use]
pub const fn is_power_of_two(value: f64) -> bool {
    value.is_normal() && value.to_bits() << 12 == 0
}

/// 2^`exponent`, a normal number.
#[must_use]
pub const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
