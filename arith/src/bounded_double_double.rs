//! `BoundedDoubleDouble`: double-double that knows how large its terms are, hence when it cannot tell its own digits.

use core::ops::{Add, Mul, Neg};

use crate::double_double::DoubleDouble;
use crate::error_free::product_is_error_free;
use crate::range;

/// A compensated expression in double-double, and the sum of the magnitudes of its terms.
///
/// With an n that the operations make ([`compensated`](crate::error_model::compensated)), |value - exact| is at most
/// n u^2 size, where products add [`UNDERFLOW`] to the size: that much of it, times u^2, is more than a product loses when
/// parts of it underflow. Overflow, and operands too large to split, end in a size that is infinite or a value that is
/// NaN: both are [fail the rounding test](Self::passes).
#[derive(Clone, Copy, Debug)]
pub struct BoundedDoubleDouble {
    value: DoubleDouble,
    size: f64,
}

const UNDERFLOW: f64 = range::power_of_two(range::UNDERFLOW);

impl BoundedDoubleDouble {
    /// `a + b`, exactly.
    #[inline(always)]
    pub(crate) fn two_sum(a: f64, b: f64) -> Self {
        BoundedDoubleDouble { value: DoubleDouble::two_sum(a, b), size: a.abs() + b.abs() }
    }

    /// `a * b`, exactly.
    #[inline(always)]
    pub(crate) fn two_product(a: f64, b: f64) -> Self {
        BoundedDoubleDouble { value: DoubleDouble::two_product(a, b), size: (a * b).abs() + UNDERFLOW }
    }

    /// The value in double-double.
    #[inline(always)]
    pub(crate) fn value(self) -> DoubleDouble {
        self.value
    }

    /// The value rounded.
    #[inline(always)]
    pub(crate) fn round(self) -> f64 {
        self.value.round()
    }

    /// Whether the value is larger than `threshold` times its size; never of NaN.
    #[inline(always)]
    pub(crate) fn passes(self, threshold: f64) -> bool {
        self.round().abs() > threshold * self.size
    }

    /// A product of numbers with these leading parts: of infinite size, and so below the rounding test in all that it becomes part of,
    /// where a product of them may not be error-free, on some targets or on all.
    #[inline(always)]
    pub(crate) fn watched(self, a: f64, b: f64) -> Self {
        let size = if product_is_error_free(a, b) { self.size } else { f64::INFINITY };
        BoundedDoubleDouble { size, ..self }
    }

    /// Whether nothing overflowed, and no [watched](Self::watched) product lost an error.
    #[inline(always)]
    pub(crate) fn whole(self) -> bool {
        self.size.is_finite()
    }
}

impl Neg for BoundedDoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        BoundedDoubleDouble { value: -self.value, size: self.size }
    }
}

impl Add<f64> for BoundedDoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: f64) -> Self {
        BoundedDoubleDouble { value: self.value + other, size: self.size + other.abs() }
    }
}

impl Add for BoundedDoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        BoundedDoubleDouble { value: self.value + other.value, size: self.size + other.size }
    }
}

impl Mul<f64> for BoundedDoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        BoundedDoubleDouble { value: self.value * other, size: self.size * other.abs() + UNDERFLOW }
    }
}

impl Mul for BoundedDoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        BoundedDoubleDouble { value: self.value * other.value, size: self.size * other.size + UNDERFLOW }
    }
}
