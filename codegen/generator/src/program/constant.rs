//! Constants: which numbers `f64` holds, and of what it holds others are made.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The power of two by which an integer beyond all literals is divided.
const STEP_OF_TWOS: usize = 512;

/// Whether `f64` holds the number exactly, well inside its range.
#[must_use]
pub fn is_exact(value: &BigRational) -> bool {
    let bits = value.numer().bits();
    let trailing = value.numer().trailing_zeros().unwrap_or(0);
    is_power_of_two(&BigRational::from_integer(value.denom().clone()))
        && bits - trailing <= 53
        && bits <= 1_024
        && value.denom().bits() <= 1_023
}

/// The leading 53 bits of an integer, so that the rest has its sign; `None` beyond all literals.
#[must_use]
pub fn leading_bits(value: &BigRational) -> Option<BigRational> {
    let integer = value.to_integer();
    let less = integer.bits().saturating_sub(53) as usize;
    let leading = BigRational::from_integer((integer.abs() >> less << less) * integer.signum());
    Some(leading).filter(is_exact)
}

/// An integer beyond all literals as `step*high + rest`, with a power of two for a step.
#[must_use]
pub fn beyond_literals(value: &BigRational) -> (BigRational, BigRational, BigRational) {
    let step = BigRational::from_integer(BigInt::one() << STEP_OF_TWOS);
    let high = (value / &step).trunc();
    let rest = value - &high * &step;
    (step, high, rest)
}

/// Whether the number is a power of two, or the negative of one.
#[must_use]
pub fn is_power_of_two(value: &BigRational) -> bool {
    let single_bit = |n: &num_bigint::BigInt| n.abs().magnitude().count_ones() == 1;
    !value.is_zero() && single_bit(value.numer()) && single_bit(value.denom())
}
