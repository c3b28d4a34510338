//! Double-double arithmetic: a value as the unevaluated sum of two `f64`.
//!
//! The algorithms and theorems are those of M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for
//! basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017 (JMP); u = 2^-53. None of them branches, so
//! loops over them vectorise.
//!
//! The theorems hold while nothing over- or underflows. A product of operands beyond 2^996 (where the split of an
//! operand overflows, on targets without a fused multiply-add) or below 2^-969 (where its error underflows) loses
//! the theorem; beyond 2^996 the value may become NaN, and the two ways to multiply differ. Programs therefore never use
//! such a product: see `Plain` and `Guarded`. It never panics.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::float::{product_error, sqrt};

/// Between these magnitudes a product of numbers that can be split is error-free: one of 2^-969 or more has an error of
/// no bits below the smallest number, 2^-1074, and one of 2^1022 or less has parts that do not overflow.
const PRODUCTS: (f64, f64) = (f64::from_bits((1023 - 969) << 52), f64::from_bits((1023 + 1022) << 52));

/// 2^996: the split of a factor, some 2^27 times as large, is finite.
pub(crate) const LARGEST_FACTOR: f64 = f64::from_bits((1023 + 996) << 52);

/// A number of about 106 bits: `high + low`, where `high` is that sum rounded to `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    high: f64,
    low: f64,
}

impl Wide {
    /// `a + b`, exactly (Knuth's 2Sum).
    #[inline(always)]
    pub fn two_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let a_part = high - b;
        let b_part = high - a_part;
        Wide { high, low: (a - a_part) + (b - b_part) }
    }

    /// `a * b`, exactly (2Prod: fused multiply-add, else Dekker's product; the same bits where it is `error_free`).
    #[inline(always)]
    pub fn two_product(a: f64, b: f64) -> Self {
        let high = a * b;
        Wide { high, low: product_error(a, b, high) }
    }

    /// Whether the product of `a` and `b` is error-free however it is computed: operands can be split, no product of
    /// their parts overflows, and the error does not underflow.
    #[inline(always)]
    pub(crate) fn error_free(a: f64, b: f64) -> bool {
        let product = (a * b).abs();
        let sized = ((product >= PRODUCTS.0) & (product <= PRODUCTS.1)) | (a == 0.0) | (b == 0.0);
        (a.abs() <= LARGEST_FACTOR) & (b.abs() <= LARGEST_FACTOR) & sized
    }

    /// `a + b`, exactly, where `a` is zero or its exponent is not below that of `b` (Dekker's Fast2Sum).
    #[inline(always)]
    fn fast_two_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Wide { high, low: b - (high - a) }
    }

    /// The leading part: this number rounded to the nearest `f64`.
    #[inline(always)]
    pub fn round(self) -> f64 {
        self.high
    }

    /// The square root; NaN below zero. Relative error at most 25/8 u^2 (V. Lefevre, N. Louvet, J.-M. Muller, J. Picot,
    /// L. Rideau, "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS 49(1), 2023,
    /// SQRTDWtoDW).
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = sqrt(self.high);
        let square = Wide::two_product(root, root);
        // exact: the remainder of a square root is a number of its precision
        let remainder = (self.high - square.high) - square.low;
        let correction = (self.low + remainder) / (2.0 * root);
        if root == 0.0 { self } else { Wide::fast_two_sum(root, correction) }
    }

    /// What [`round`](Self::round) leaves off.
    #[inline(always)]
    pub fn low(self) -> f64 {
        self.low
    }
}

impl From<f64> for Wide {
    /// Exact.
    #[inline(always)]
    fn from(value: f64) -> Self {
        Wide { high: value, low: 0.0 }
    }
}

impl Neg for Wide {
    type Output = Wide;

    /// Exact.
    #[inline(always)]
    fn neg(self) -> Wide {
        Wide { high: -self.high, low: -self.low }
    }
}

impl Add<f64> for Wide {
    type Output = Wide;

    /// Relative error at most 2 u^2 (JMP algorithm 4, DWPlusFP).
    #[inline(always)]
    fn add(self, other: f64) -> Wide {
        let sum = Wide::two_sum(self.high, other);
        Wide::fast_two_sum(sum.high, self.low + sum.low)
    }
}

impl Add for Wide {
    type Output = Wide;

    /// Relative error at most 3 u^2 / (1 - 4 u) (JMP algorithm 6, AccurateDWPlusDW), cancellation or not.
    #[inline(always)]
    fn add(self, other: Wide) -> Wide {
        let high = Wide::two_sum(self.high, other.high);
        let low = Wide::two_sum(self.low, other.low);
        let sum = Wide::fast_two_sum(high.high, high.low + low.high);
        Wide::fast_two_sum(sum.high, low.low + sum.low)
    }
}

impl Sub<f64> for Wide {
    type Output = Wide;

    /// Relative error at most 2 u^2: the sum with the negated operand.
    #[inline(always)]
    fn sub(self, other: f64) -> Wide {
        self + -other
    }
}

impl Sub for Wide {
    type Output = Wide;

    /// Relative error at most 3 u^2 / (1 - 4 u): the sum with the negated operand.
    #[inline(always)]
    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

impl Mul<f64> for Wide {
    type Output = Wide;

    /// Relative error at most 1.5 u^2 + 4 u^3 (JMP algorithm 7, DWTimesFP1).
    #[inline(always)]
    fn mul(self, other: f64) -> Wide {
        let product = Wide::two_product(self.high, other);
        let sum = Wide::fast_two_sum(product.high, self.low * other);
        Wide::fast_two_sum(sum.high, sum.low + product.low)
    }
}

impl Mul for Wide {
    type Output = Wide;

    /// Relative error at most 7 u^2 (JMP algorithm 10, DWTimesDW1; it uses no fused operation outside 2Prod, hence the
    /// same bits on every target where that is error-free).
    #[inline(always)]
    fn mul(self, other: Wide) -> Wide {
        let product = Wide::two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Wide::fast_two_sum(product.high, product.low + cross)
    }
}

impl Div for Wide {
    type Output = Wide;

    /// Relative error at most 15 u^2 + 56 u^3 (JMP algorithm 17, DWDivDW2).
    #[inline(always)]
    fn div(self, other: Wide) -> Wide {
        let quotient = self.high / other.high;
        let product = other * quotient;
        let rest = (self.high - product.high) + (self.low - product.low);
        Wide::fast_two_sum(quotient, rest / other.high)
    }
}
