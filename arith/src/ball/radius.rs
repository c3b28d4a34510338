//! `Radius`: an upper bound of an error, of any size.

use core::cmp::Ordering;

use super::limbs::Limbs;
use crate::error_model::ball::UP;
use crate::float;

/// A number `value * 2^exponent`, the value from 1 to 2 or 0, rounded up by every operation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Radius {
    value: f64,
    exponent: i64,
}

impl Radius {
    /// No error.
    pub(super) const ZERO: Self = Radius { value: 0.0, exponent: 0 };

    /// 2^exponent.
    pub(super) fn power_of_two(exponent: i64) -> Self {
        Radius { value: 1.0, exponent }
    }

    /// At least `value * 2^exponent`, of a value that is 0 or from 2^-64 to 2^64.
    pub(super) fn new(value: f64, exponent: i64) -> Self {
        let mut radius = Radius { value: value * UP, exponent };
        if radius.value == 0.0 {
            return Self::ZERO;
        }
        while radius.value >= 2.0 {
            radius = Radius { value: radius.value * 0.5, exponent: radius.exponent + 1 };
        }
        while radius.value < 1.0 {
            radius = Radius { value: radius.value * 2.0, exponent: radius.exponent - 1 };
        }
        radius
    }

    #[cfg(all(test, feature = "std"))]
    pub(super) fn parts(self) -> (f64, i64) {
        (self.value, self.exponent)
    }

    pub(super) fn is_zero(self) -> bool {
        self.value == 0.0
    }

    /// A number that is not smaller.
    pub(super) fn upper<const L: usize>(self) -> Limbs<L> {
        Limbs::from_f64(self.value).scaled(self.exponent)
    }

    /// The larger one.
    pub(super) fn larger(self, other: Self) -> Self {
        let rank = |radius: Self| (!radius.is_zero(), radius.exponent);
        let other_is_larger = match rank(self).cmp(&rank(other)) {
            Ordering::Equal => self.value < other.value,
            order => order == Ordering::Less,
        };
        if other_is_larger { other } else { self }
    }

    /// An `f64` that is not smaller; infinite where there is none.
    pub(super) fn to_f64_above(self) -> f64 {
        match i32::try_from(self.exponent) {
            _ if self.is_zero() => 0.0,
            // one above the nearest of the subnormal numbers, where scaling rounds
            Ok(exponent @ ..=-1000) => float::scale(self.value, exponent).next_up(),
            Ok(exponent) => float::scale(self.value, exponent),
            Err(_) if self.exponent < 0 => f64::from_bits(1),
            Err(_) => f64::INFINITY,
        }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let distance = large.exponent.saturating_sub(small.exponent).min(60);
        Self::new(large.value + small.value / (1_u64 << distance) as f64, large.exponent)
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.exponent.saturating_add(other.exponent))
    }

    /// At least the quotient by `value * 2^exponent`, which may be rounded to nearest and is from 1/4 to 2.
    pub(super) fn over(self, value: f64, exponent: i64) -> Self {
        Self::new(self.value / value * UP, self.exponent.saturating_sub(exponent))
    }

    /// At least the root of this degree.
    pub(super) fn root(self, degree: u32) -> Self {
        let degree = i64::from(degree);
        // what is less than 2^(exponent + 1) has a root less than 2 to the part of that, rounded up
        if self.is_zero() {
            self
        } else {
            Self::power_of_two((self.exponent.saturating_add(degree)).div_euclid(degree))
        }
    }

    /// Whether it is less than `value * 2^exponent`, a value from 1/2 to 1 that may be rounded to nearest.
    pub(super) fn is_less_than(self, value: f64, exponent: i64) -> bool {
        if self.is_zero() {
            return true;
        }
        match self.exponent.saturating_sub(exponent) {
            ..=-3 => true,
            -2 => 0.25 * self.value * UP < value,
            -1 => 0.5 * self.value * UP < value,
            _ => false,
        }
    }
}
