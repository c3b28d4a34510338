//! Double-double arithmetic: a value as the unevaluated sum of two `f64`.
//!
//! The algorithms and their error bounds are those of the [error model](crate::error_model). None of them branches, so loops
//! over them vectorise.
//!
//! The bounds hold while nothing over- or underflows. A product of operands that are too large to be split, on targets
//! without a fused multiply-add, or so small that its error underflows loses its bound (see [`range`](crate::range)); beyond
//! the largest factor the value may become NaN, and the two ways to multiply differ. Programs therefore never use such a
//! product: see [`Filtered`](crate::Filtered) and [`FilteredDoubleDouble`](crate::FilteredDoubleDouble). It never panics.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::error_free;
use crate::float::sqrt;

/// A number of about 106 bits, with the products that are the fastest on every processor of the target.
pub type DoubleDouble = DoubleDoubleWith<{ error_free::FUSED }>;

/// A number of about 106 bits: `high + low`, where `high` is that sum rounded to `f64`. Products take a fused multiply-add where they
/// are `FUSED`, else they split their factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDoubleWith<const FUSED: bool> {
    high: f64,
    low: f64,
}

impl<const FUSED: bool> DoubleDoubleWith<FUSED> {
    /// `a + b`, exactly.
    #[inline(always)]
    pub fn two_sum(a: f64, b: f64) -> Self {
        Self::of(error_free::two_sum(a, b))
    }

    /// `a * b`, exactly.
    #[inline(always)]
    pub fn two_product(a: f64, b: f64) -> Self {
        Self::of(error_free::two_product::<FUSED>(a, b))
    }

    /// `a + b`, exactly, where `a` is zero or its exponent is not below that of `b`.
    #[inline(always)]
    fn fast_two_sum(a: f64, b: f64) -> Self {
        Self::of(error_free::fast_two_sum(a, b))
    }

    #[inline(always)]
    fn of((high, low): (f64, f64)) -> Self {
        Self { high, low }
    }

    /// The leading part: this number rounded to the nearest `f64`.
    #[inline(always)]
    pub fn round(self) -> f64 {
        self.high
    }

    /// The square root, off by [`ROOT`](crate::error_model::double_double::ROOT) at most; NaN below zero.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = sqrt(self.high);
        let square = Self::two_product(root, root);
        // exact: the remainder of a square root is a number of its precision
        let remainder = (self.high - square.high) - square.low;
        let correction = (self.low + remainder) / (2.0 * root);
        if root == 0.0 { self } else { Self::fast_two_sum(root, correction) }
    }

    /// What [`round`](Self::round) leaves off.
    #[inline(always)]
    pub fn low(self) -> f64 {
        self.low
    }
}

impl<const FUSED: bool> From<f64> for DoubleDoubleWith<FUSED> {
    /// Exact.
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl<const FUSED: bool> Neg for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Exact.
    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl<const FUSED: bool> Add<f64> for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`SUM_WITH_F64`](crate::error_model::double_double::SUM_WITH_F64) at most.
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        let sum = Self::two_sum(self.high, other);
        Self::fast_two_sum(sum.high, self.low + sum.low)
    }
}

impl<const FUSED: bool> Add for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`SUM`](crate::error_model::double_double::SUM) at most, cancellation or not.
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = Self::two_sum(self.high, other.high);
        let low = Self::two_sum(self.low, other.low);
        let sum = Self::fast_two_sum(high.high, high.low + low.high);
        Self::fast_two_sum(sum.high, low.low + sum.low)
    }
}

impl<const FUSED: bool> Sub<f64> for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`SUM_WITH_F64`](crate::error_model::double_double::SUM_WITH_F64) at most: the sum with the negated operand.
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl<const FUSED: bool> Sub for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`SUM`](crate::error_model::double_double::SUM) at most: the sum with the negated operand.
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const FUSED: bool> Mul<f64> for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`PRODUCT_WITH_F64`](crate::error_model::double_double::PRODUCT_WITH_F64) at most.
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let product = Self::two_product(self.high, other);
        let sum = Self::fast_two_sum(product.high, self.low * other);
        Self::fast_two_sum(sum.high, sum.low + product.low)
    }
}

impl<const FUSED: bool> Mul for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`PRODUCT`](crate::error_model::double_double::PRODUCT) at most, and with the same bits on every target where 2Prod is
    /// error-free: nothing else in it could be fused.
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = Self::two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::fast_two_sum(product.high, product.low + cross)
    }
}

impl<const FUSED: bool> Div for DoubleDoubleWith<FUSED> {
    type Output = Self;

    /// Off by [`QUOTIENT`](crate::error_model::double_double::QUOTIENT) at most.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let product = other * quotient;
        let rest = (self.high - product.high) + (self.low - product.low);
        Self::fast_two_sum(quotient, rest / other.high)
    }
}
