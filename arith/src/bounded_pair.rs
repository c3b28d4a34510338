//! `BoundedPair`: pair arithmetic that knows how large its terms are, hence when it cannot tell its own digits.
//!
//! A pair is the unevaluated sum of two `f64`, as a number in double-double is; but nothing makes the second one small beside
//! the first after each operation, which takes half of the time of double-double and more. What its error is: M. Lange,
//! S. M. Rump, "Faithfully rounded floating-point computations", ACM TOMS 46(3), 2020, and
//! [here](crate::error_model::compensated).

use core::ops::{Add, Mul, Neg};

use crate::double_double::DoubleDoubleWith;
use crate::error_free::{self, product_is_error_free, two_product, two_sum};
use crate::range;

/// A part of a compensated expression, and the sum of the magnitudes of its terms.
///
/// Not `WATCHED`, it is for operands of ordinary magnitudes: products of them are error-free.
///
/// With an n that the operations make ([`Part`](crate::error_model::compensated::Part)), |value - exact| is at most
/// n u^2 size, where products that are watched add 2^[`UNDERFLOW`](range::UNDERFLOW) to the size: that much of it, times u^2,
/// is more than a product loses when parts of it underflow. Overflow, and operands too large to split, end in a size that is
/// infinite or a value that is NaN: both [fail the rounding test](Self::passes).
#[derive(Clone, Copy, Debug)]
pub struct BoundedPair<const WATCHED: bool, const FUSED: bool = { error_free::FUSED }> {
    /// What `f64` makes of the expression.
    high: f64,
    /// What that lost, to the digits of `f64`.
    low: f64,
    size: f64,
}

/// What a product adds to the size.
const fn underflow(watched: bool) -> f64 {
    if watched { range::power_of_two(range::UNDERFLOW) } else { -0.0 }
}

impl<const WATCHED: bool, const FUSED: bool> BoundedPair<WATCHED, FUSED> {
    /// `a + b`, exactly.
    #[inline(always)]
    pub(crate) fn two_sum(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        BoundedPair { high, low, size: a.abs() + b.abs() }
    }

    /// `a * b`, exactly.
    #[inline(always)]
    pub(crate) fn two_product(a: f64, b: f64) -> Self {
        let (high, low) = two_product::<FUSED>(a, b);
        BoundedPair { high, low, size: Self::size_of_product(high.abs(), a, b) }
    }

    /// `a * power`, a power of two: exact but for what underflows.
    #[inline(always)]
    pub(crate) fn scaled(a: f64, power: f64) -> Self {
        let high = a * power;
        // minus zero, since compilers leave out a sum with it
        BoundedPair { high, low: -0.0, size: high.abs() + underflow(WATCHED) }
    }

    /// The product with a power of two: rounds nothing, but for what underflows.
    #[inline(always)]
    pub(crate) fn times_power(self, power: f64) -> Self {
        let size = self.size * power.abs() + underflow(WATCHED);
        BoundedPair { high: self.high * power, low: self.low * power, size }
    }

    /// The same value in double-double, exactly; zero is positive.
    #[inline(always)]
    pub(crate) fn value(self) -> DoubleDoubleWith<FUSED> {
        DoubleDoubleWith::two_sum(self.high + 0.0, self.low)
    }

    /// The value rounded; zero is positive, as exact sums make it.
    #[inline(always)]
    pub(crate) fn round(self) -> f64 {
        self.high + self.low + 0.0
    }

    /// Whether the value is at least `threshold` times its size: then it is right to its digits, and exact where it is zero, since all
    /// terms are, or no operation rounds. (Where the product underflows, only numbers are added that are too small to be rounded.)
    /// Never of NaN.
    #[inline(always)]
    pub(crate) fn passes(self, threshold: f64) -> bool {
        self.round().abs() >= threshold * self.size
    }

    /// The size of a product with these high parts: infinite, and so below the rounding test in all that it becomes part of,
    /// where the product of them may not be error-free, on some targets or on all.
    #[inline(always)]
    fn size_of_product(size: f64, a: f64, b: f64) -> f64 {
        if !WATCHED || product_is_error_free(a, b) { size + underflow(WATCHED) } else { f64::INFINITY }
    }

    /// Whether nothing overflowed, and no product that is watched lost an error.
    #[inline(always)]
    pub(crate) fn whole(self) -> bool {
        self.size.is_finite()
    }
}

impl<const WATCHED: bool, const FUSED: bool> Neg for BoundedPair<WATCHED, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        BoundedPair { high: -self.high, low: -self.low, size: self.size }
    }
}

impl<const WATCHED: bool, const FUSED: bool> Add<f64> for BoundedPair<WATCHED, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: f64) -> Self {
        let (high, error) = two_sum(self.high, other);
        BoundedPair { high, low: self.low + error, size: self.size + other.abs() }
    }
}

impl<const WATCHED: bool, const FUSED: bool> Add for BoundedPair<WATCHED, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        BoundedPair { high, low: (self.low + other.low) + error, size: self.size + other.size }
    }
}

impl<const WATCHED: bool, const FUSED: bool> Mul<f64> for BoundedPair<WATCHED, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let (high, error) = two_product::<FUSED>(self.high, other);
        let size = Self::size_of_product(self.size * other.abs(), self.high, other);
        BoundedPair { high, low: self.low * other + error, size }
    }
}

impl<const WATCHED: bool, const FUSED: bool> Mul for BoundedPair<WATCHED, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product::<FUSED>(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        let size = Self::size_of_product(self.size * other.size, self.high, other.high);
        BoundedPair { high, low: cross + error, size }
    }
}

#[cfg(all(test, feature = "mpfr"))]
mod tests;
