//! `Real`: any arithmetic in which a program can run.

use crate::float;
use crate::root;
use crate::wide::Wide;

/// An arithmetic in which the program of a kernel can run.
///
/// Expansions of `#[kernel]` call nothing else, so a program means the same in all of them: in `f64` what users call,
/// in `Mpfr` what judges measure it against.
///
/// [`Wide`](Self::Wide) is what a `compensated!` slice is evaluated in. Its operands count as exact; sums and products
/// of them take the cheapest operation that their kinds allow.
pub trait Real: Clone + PartialOrd {
    /// The wider type of a `compensated!` slice.
    type Wide: Clone;

    /// The number `value`, in the precision of `self`.
    fn literal(&self, value: f64) -> Self;
    /// The circle constant, in the precision of `self`.
    fn pi(&self) -> Self;
    /// Not a number, in the precision of `self`.
    fn nan(&self) -> Self;

    /// `self + other`
    fn add(&self, other: &Self) -> Self;
    /// `self - other`
    fn sub(&self, other: &Self) -> Self;
    /// `self * other`
    fn mul(&self, other: &Self) -> Self;
    /// `self / other`
    fn div(&self, other: &Self) -> Self;
    /// `-self`
    fn neg(&self) -> Self;
    /// The square root; NaN below zero.
    fn sqrt(&self) -> Self;
    /// The magnitude.
    fn abs(&self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(&self) -> bool;
    /// The one positive root of c0 + c1 x + .. + cn x^n: see [`positive_root`](crate::positive_root()).
    fn positive_root(coefficients: &[Self]) -> Self;

    /// `self + other`, error-free in `f64`.
    fn two_sum(&self, other: &Self) -> Self::Wide;
    /// `self * other`, error-free in `f64`.
    fn two_product(&self, other: &Self) -> Self::Wide;
    /// `-wide`
    fn wide_neg(wide: &Self::Wide) -> Self::Wide;
    /// `wide + exact`
    fn wide_add_exact(wide: &Self::Wide, exact: &Self) -> Self::Wide;
    /// `left + right`
    fn wide_add(left: &Self::Wide, right: &Self::Wide) -> Self::Wide;
    /// `wide * exact`
    fn wide_mul_exact(wide: &Self::Wide, exact: &Self) -> Self::Wide;
    /// `left * right`
    fn wide_mul(left: &Self::Wide, right: &Self::Wide) -> Self::Wide;
    /// The wide value, rounded once.
    fn round(wide: &Self::Wide) -> Self;
}

// Every method is forced inline: a batch loop vectorises only when its whole body is in sight.
impl Real for f64 {
    type Wide = Wide;

    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        core::f64::consts::PI
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        f64::NAN
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        self + other
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        self - other
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        self * other
    }

    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        self / other
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        -self
    }

    #[inline(always)]
    fn sqrt(&self) -> Self {
        float::sqrt(*self)
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        f64::abs(*self)
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn positive_root(coefficients: &[Self]) -> Self {
        root::positive_root(coefficients)
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> Wide {
        Wide::two_sum(*self, *other)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> Wide {
        Wide::two_product(*self, *other)
    }

    #[inline(always)]
    fn wide_neg(wide: &Wide) -> Wide {
        -*wide
    }

    #[inline(always)]
    fn wide_add_exact(wide: &Wide, exact: &Self) -> Wide {
        *wide + *exact
    }

    #[inline(always)]
    fn wide_add(left: &Wide, right: &Wide) -> Wide {
        *left + *right
    }

    #[inline(always)]
    fn wide_mul_exact(wide: &Wide, exact: &Self) -> Wide {
        *wide * *exact
    }

    #[inline(always)]
    fn wide_mul(left: &Wide, right: &Wide) -> Wide {
        *left * *right
    }

    #[inline(always)]
    fn round(wide: &Wide) -> Self {
        wide.round()
    }
}
