//! `SoftFloat`: floating point in integers, with 128 bits and an exponent that never runs out.
//!
//! What `faithful` falls back on where double-double would over- or underflow. Every operation is right to 2^-120, a sum
//! of that relative to its terms; exponents fit in 64 bits, which no program of fewer than some 2^50 steps leaves.

mod real;

use core::cmp::Ordering;

use crate::float;
use crate::step::{Fraction, Step};

/// A number `bits * 2^exponent`, the leading bit of `bits` set, or the negative of it; or zero, or not a number.
#[derive(Clone, Copy, Debug)]
pub struct SoftFloat {
    kind: Kind,
    negative: bool,
    bits: u128,
    exponent: i64,
    /// Whether the number that these bits cut off is larger, by less than one unit.
    cut: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Nan,
    Zero,
    Normal,
}

impl SoftFloat {
    pub(crate) const ZERO: Self = SoftFloat { kind: Kind::Zero, negative: false, bits: 0, exponent: 0, cut: false };
    pub(crate) const NAN: Self = SoftFloat { kind: Kind::Nan, ..Self::ZERO };

    /// From any bits: shifted so that the leading one is set.
    pub(crate) fn new(negative: bool, bits: u128, exponent: i64, cut: bool) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let space = bits.leading_zeros();
        SoftFloat { kind: Kind::Normal, negative, bits: bits << space, exponent: exponent - i64::from(space), cut }
    }

    /// From 256 bits, of which 128 are kept.
    fn of_both(negative: bool, (high, low): (u128, u128), exponent: i64) -> Self {
        if high == 0 {
            return Self::new(negative, low, exponent, false);
        }
        let space = high.leading_zeros();
        let bits = high << space | if space == 0 { 0 } else { low >> (128 - space) };
        SoftFloat {
            kind: Kind::Normal,
            negative,
            bits,
            exponent: exponent + 128 - i64::from(space),
            cut: low << space != 0,
        }
    }

    /// Exact; NaN unless finite.
    pub fn from_f64(x: f64) -> Self {
        if !x.is_finite() {
            return Self::NAN;
        }
        let (significand, exponent) = float::significand(x);
        Self::new(x < 0.0, significand.into(), exponent.into(), false)
    }

    pub(crate) fn is_zero(self) -> bool {
        self.kind == Kind::Zero
    }

    pub(crate) fn is_negative(self) -> bool {
        self.negative
    }

    pub(crate) fn is_nan(self) -> bool {
        self.kind == Kind::Nan
    }

    /// The exponent of the leading bit; 0 of zero and NaN.
    fn leading(self) -> i64 {
        if self.kind == Kind::Normal { self.exponent + 127 } else { 0 }
    }

    /// The nearest `f64`; a tie goes to even.
    pub fn to_f64(self) -> f64 {
        match self.kind {
            Kind::Nan => f64::NAN,
            Kind::Zero => 0.0,
            Kind::Normal if self.negative => -self.rounded(),
            Kind::Normal => self.rounded(),
        }
    }

    /// The nearest `f64` to the magnitude.
    fn rounded(self) -> f64 {
        let leading = self.leading();
        if leading > 1023 {
            return f64::INFINITY;
        }
        // A subnormal number has fewer bits; one below half the smallest has none.
        let bits = 53 + (leading + 1022).min(0);
        let Ok(bits @ 0..) = u32::try_from(bits) else { return 0.0 };
        let kept = if bits == 0 { 0 } else { (self.bits >> (128 - bits)) as u64 };
        let rest = self.bits << bits;
        let half = 1_u128 << 127;
        let up = rest > half || (rest == half && (self.cut || kept & 1 != 0));
        // The leading bit of what is kept carries into the exponent's field.
        let field = (leading + 1022).max(0) as u64;
        f64::from_bits((field << 52) + kept + u64::from(up))
    }

    /// Whether it is negative, its bits, the exponent of their unit, and whether there are more; of zero no bits.
    pub(crate) fn parts(self) -> (bool, u128, i64, bool) {
        (self.negative, self.bits, self.exponent, self.cut)
    }

    /// The same bits, of a number that has more.
    pub(crate) fn with_more(self) -> Self {
        SoftFloat { cut: true, ..self }
    }

    /// The nearest `f64`, and the nearest to what it leaves off.
    pub(crate) fn split(self) -> (f64, f64) {
        let high = self.to_f64();
        (high, self.plus(Self::from_f64(-high)).to_f64())
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        match (self.kind, other.kind) {
            (Kind::Nan, _) | (_, Kind::Nan) => return Self::NAN,
            (Kind::Zero, _) => return other,
            (_, Kind::Zero) => return self,
            (Kind::Normal, Kind::Normal) => {}
        }
        let ordered = self.order_of_magnitudes(other) != Ordering::Less;
        let (large, small) = if ordered { (self, other) } else { (other, self) };
        // In 256 bits, of which the first is kept free for the carry.
        let (high, low) = (large.bits >> 1, large.bits << 127);
        let (small_high, small_low) = shifted(small.bits, (large.exponent - small.exponent).saturating_add(1));
        let sum = if large.negative == small.negative {
            let (low, carry) = low.overflowing_add(small_low);
            (high.wrapping_add(small_high).wrapping_add(carry.into()), low)
        } else {
            let (low, borrow) = low.overflowing_sub(small_low);
            (high.wrapping_sub(small_high).wrapping_sub(borrow.into()), low)
        };
        Self::of_both(large.negative, sum, large.exponent - 127)
    }

    fn times(self, other: Self) -> Self {
        match (self.kind, other.kind) {
            (Kind::Nan, _) | (_, Kind::Nan) => Self::NAN,
            (Kind::Zero, _) | (_, Kind::Zero) => Self::ZERO,
            (Kind::Normal, Kind::Normal) => {
                let product = full_product(self.bits, other.bits);
                Self::of_both(self.negative ^ other.negative, product, self.exponent + other.exponent)
            }
        }
    }

    /// Twice corrected from the quotient of the leading parts, each time by the residual's.
    fn over(self, other: Self) -> Self {
        if self.kind != Kind::Normal || other.kind != Kind::Normal {
            return if self.kind == Kind::Zero && other.kind == Kind::Normal { Self::ZERO } else { Self::NAN };
        }
        let (a, b) = (self.scaled(), other.scaled());
        let divisor = b.to_f64();
        let mut quotient = Self::ZERO;
        for _ in 0..3 {
            let residual = a.plus(quotient.times(b).negated());
            quotient = quotient.plus(Self::from_f64(residual.to_f64() / divisor));
        }
        SoftFloat { exponent: quotient.exponent + self.leading() - other.leading(), ..quotient }
    }

    /// The real root of this degree; `start` gives that of an `f64`. Twice corrected from the root of the leading part, each
    /// time by the residual by the slope of the power.
    pub(crate) fn root(self, degree: u32, start: fn(f64) -> f64) -> Self {
        match self.kind {
            Kind::Normal if !self.negative => {}
            Kind::Normal if degree % 2 == 1 => return self.negated().root(degree, start).negated(),
            Kind::Zero => return Self::ZERO,
            _ => return Self::NAN,
        }
        let part = self.leading().div_euclid(degree.into());
        let radicand = SoftFloat { exponent: self.exponent - i64::from(degree) * part, ..self };
        let first = start(radicand.to_f64());
        let slope = (1..degree).fold(degree.into(), |slope: f64, _| slope * first);
        let mut root = Self::from_f64(first);
        for _ in 0..2 {
            let power = (1..degree).fold(root, |power, _| power.times(root));
            let residual = radicand.plus(power.negated());
            root = root.plus(Self::from_f64(residual.to_f64() / slope));
        }
        SoftFloat { exponent: root.exponent + part, ..root }
    }

    /// The integer that it becomes, of what its bits say and whether there are more.
    pub(crate) fn stepped(self, step: Step) -> Self {
        if self.kind != Kind::Normal || self.exponent >= 0 {
            return self;
        }
        let (whole, fraction) = self.whole();
        let up = step.leaves_zero(self.negative, whole % 2 == 1, fraction);
        Self::new(self.negative, whole + u128::from(up), 0, false)
    }

    /// The integer part of the magnitude and what is left, of a number whose last bit lies behind the point.
    fn whole(self) -> (u128, Fraction) {
        let (whole, rest) = match u32::try_from(-self.exponent) {
            Ok(places @ 1..=127) => (self.bits >> places, self.bits << (128 - places)),
            Ok(128) => (0, self.bits),
            // less than 1/2
            _ => (0, 1),
        };
        let order = rest.cmp(&(1 << 127)).then(if self.cut { Ordering::Greater } else { Ordering::Equal });
        (whole, (rest != 0 || self.cut).then_some(order))
    }

    pub(crate) fn magnitude(self) -> Self {
        SoftFloat { negative: false, ..self }
    }

    /// The same bits, as a number from 1 to 2.
    fn scaled(self) -> Self {
        SoftFloat { exponent: -127, ..self }
    }

    pub(crate) fn negated(self) -> Self {
        SoftFloat { negative: !self.negative, ..self }
    }

    fn order_of_magnitudes(self, other: Self) -> Ordering {
        (self.exponent, self.bits).cmp(&(other.exponent, other.bits))
    }

    /// -1, 0 or 1.
    fn sign(self) -> i8 {
        match self.kind {
            Kind::Normal if self.negative => -1,
            Kind::Normal => 1,
            _ => 0,
        }
    }
}

/// `bits * 2^128`, shifted down by `distance` places, those below lost.
fn shifted(bits: u128, distance: i64) -> (u128, u128) {
    match u32::try_from(distance) {
        Ok(distance @ 1..=127) => (bits >> distance, bits << (128 - distance)),
        Ok(distance @ 128..=255) => (0, bits >> (distance - 128)),
        _ => (0, 0),
    }
}

/// All 256 bits of a product, the upper half first.
fn full_product(a: u128, b: u128) -> (u128, u128) {
    let halves = |x: u128| (x >> 64, x & u128::from(u64::MAX));
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    let (middle, carry) = (a1 * b0).overflowing_add(a0 * b1);
    let (low, more) = (a0 * b0).overflowing_add(middle << 64);
    let high = (a1 * b1) + (middle >> 64) + (u128::from(carry) << 64) + u128::from(more);
    (high, low)
}

impl PartialEq for SoftFloat {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for SoftFloat {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.kind == Kind::Nan || other.kind == Kind::Nan {
            return None;
        }
        let magnitudes = match self.sign() {
            0 => Ordering::Equal,
            1 => self.order_of_magnitudes(*other),
            _ => other.order_of_magnitudes(*self),
        };
        Some(self.sign().cmp(&other.sign()).then(magnitudes))
    }
}

#[cfg(all(test, feature = "std"))]
mod tests;
