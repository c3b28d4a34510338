//! `Guarded`: double-double as a program's arithmetic, which says when it leaves its range; what `faithful` runs in.
//!
//! A step in range is right to 15 u^2 relative to its value, u = 2^-53 (see [`Wide`]), and a slice to u/1000. What a
//! program computes without cancellation outside its slices is therefore right to far better than u/2, and the leading
//! part of its result less than one ulp from the true value.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::exact;
use crate::measured::Measured;
use crate::real::Real;
use crate::root;
use crate::wide::Wide;

/// A number in double-double; `left` is raised when a step leaves the range.
#[derive(Clone, Copy)]
pub struct Guarded<'a> {
    value: Wide,
    left: &'a Cell<bool>,
}

/// Between these magnitudes, 2^-450 and 2^450, a step of numbers in range loses no digits.
const RANGE: (f64, f64) = (f64::from_bits((1023 - 450) << 52), f64::from_bits((1023 + 450) << 52));

impl<'a> Guarded<'a> {
    /// Exact.
    #[inline(always)]
    pub fn new(value: f64, left: &'a Cell<bool>) -> Self {
        Guarded { value: value.into(), left }.in_range(true)
    }

    /// The leading part.
    #[inline(always)]
    pub fn round(self) -> f64 {
        self.value.round()
    }

    /// Raises `left` unless the value is in range, or a zero that may be one.
    #[inline(always)]
    fn in_range(self, may_vanish: bool) -> Self {
        let size = self.value.round().abs();
        let inside = ((size >= RANGE.0) & (size <= RANGE.1)) | (may_vanish & (size == 0.0));
        self.left.set(self.left.get() | !inside);
        self
    }

    #[inline(always)]
    fn with(&self, value: Wide) -> Self {
        Guarded { value, left: self.left }
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.value.round() == 0.0
    }
}

impl PartialEq for Guarded<'_> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Guarded<'_> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = self.value.round().partial_cmp(&other.value.round())?;
        Some(order.then(self.value.low().partial_cmp(&other.value.low())?))
    }
}

/// A slice, and where to raise what it leaves.
#[derive(Clone, Copy)]
pub struct GuardedWide<'a> {
    wide: Measured,
    left: &'a Cell<bool>,
}

impl<'a> GuardedWide<'a> {
    #[inline(always)]
    fn with(&self, wide: Measured) -> Self {
        GuardedWide { wide, left: self.left }
    }

    #[inline(always)]
    fn value(&self) -> Guarded<'a> {
        Guarded { value: self.wide.value(), left: self.left }
    }
}

impl<'a> Real for Guarded<'a> {
    type Wide = GuardedWide<'a>;

    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        self.with(value.into())
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        // with what the leading part leaves off
        self.with(Wide::two_sum(core::f64::consts::PI, 1.224_646_799_147_353_2e-16))
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        self.with(f64::NAN.into())
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        self.with(self.value + other.value).in_range(true)
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        self.with(self.value - other.value).in_range(true)
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        self.with(self.value * other.value).in_range(self.is_zero() | other.is_zero())
    }

    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        self.with(self.value / other.value).in_range(self.is_zero())
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        self.with(-self.value)
    }

    #[inline(always)]
    fn sqrt(&self) -> Self {
        self.with(self.value.sqrt())
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        if self.value.round() < 0.0 { self.neg() } else { *self }
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.value.round().is_finite()
    }

    /// To the digits of `f64`: the iterate, which a `residual!` corrects.
    fn positive_root(&self, coefficients: &[Self]) -> Self {
        self.with(root::root_of(coefficients, |coefficient| coefficient.value.round()).into()).in_range(false)
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> GuardedWide<'a> {
        GuardedWide { wide: Measured::two_sum(self.value.round(), other.value.round()), left: self.left }
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> GuardedWide<'a> {
        GuardedWide { wide: Measured::two_product(self.value.round(), other.value.round()), left: self.left }
    }

    #[inline(always)]
    fn wide_neg(wide: &GuardedWide<'a>) -> GuardedWide<'a> {
        wide.with(-wide.wide)
    }

    #[inline(always)]
    fn wide_add_exact(wide: &GuardedWide<'a>, exact: &Self) -> GuardedWide<'a> {
        wide.with(wide.wide + exact.value.round())
    }

    #[inline(always)]
    fn wide_add(left: &GuardedWide<'a>, right: &GuardedWide<'a>) -> GuardedWide<'a> {
        left.with(left.wide + right.wide)
    }

    #[inline(always)]
    fn wide_mul_exact(wide: &GuardedWide<'a>, exact: &Self) -> GuardedWide<'a> {
        wide.with(wide.wide * exact.value.round())
    }

    #[inline(always)]
    fn wide_mul(left: &GuardedWide<'a>, right: &GuardedWide<'a>) -> GuardedWide<'a> {
        left.with(left.wide * right.wide)
    }

    #[inline(always)]
    fn compensated(wide: &GuardedWide<'a>, threshold: f64, operands: &[&Self], terms: &[u8]) -> Self {
        if wide.wide.settled(threshold) {
            return wide.value().in_range(false);
        }
        let sum = exact::polynomial(operands, |operand| operand.value.round(), terms);
        let (high, low) = sum.split();
        let value = Guarded { value: Wide::two_sum(high, low), left: wide.left };
        value.in_range(sum.is_zero())
    }

    /// A residual of zero is as good as any below the last digit of the iterate.
    #[inline(always)]
    fn residual(wide: &GuardedWide<'a>) -> Self {
        wide.value().in_range(true)
    }
}
