//! `Quick`: the arithmetic of batch loops, which leaves slices unsettled and says so.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::measured::Measured;
use crate::real::Real;
use crate::root;

/// What `f64` computes, but where a `compensated!` slice has to be summed exactly: there it only raises `doubt`, and the
/// rows are computed once more. Without that branch a loop vectorises.
#[derive(Clone, Copy)]
pub struct Quick<'a> {
    pub value: f64,
    pub doubt: &'a Cell<bool>,
}

impl Quick<'_> {
    #[inline(always)]
    fn with(&self, value: f64) -> Self {
        Quick { value, doubt: self.doubt }
    }
}

impl PartialEq for Quick<'_> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Quick<'_> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }

    #[inline(always)]
    fn lt(&self, other: &Self) -> bool {
        self.value < other.value
    }

    #[inline(always)]
    fn le(&self, other: &Self) -> bool {
        self.value <= other.value
    }

    #[inline(always)]
    fn gt(&self, other: &Self) -> bool {
        self.value > other.value
    }

    #[inline(always)]
    fn ge(&self, other: &Self) -> bool {
        self.value >= other.value
    }
}

/// A slice, and where to raise doubt.
#[derive(Clone, Copy)]
pub struct QuickWide<'a> {
    wide: Measured,
    doubt: &'a Cell<bool>,
}

impl<'a> QuickWide<'a> {
    #[inline(always)]
    fn with(&self, wide: Measured) -> Self {
        QuickWide { wide, doubt: self.doubt }
    }

    #[inline(always)]
    fn round(&self) -> Quick<'a> {
        Quick { value: self.wide.value().round(), doubt: self.doubt }
    }
}

impl<'a> Real for Quick<'a> {
    type Wide = QuickWide<'a>;

    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        self.with(value)
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        self.with(self.value.pi())
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        self.with(f64::NAN)
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        self.with(self.value + other.value)
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        self.with(self.value - other.value)
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        self.with(self.value * other.value)
    }

    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        self.with(self.value / other.value)
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        self.with(-self.value)
    }

    #[inline(always)]
    fn sqrt(&self) -> Self {
        self.with(Real::sqrt(&self.value))
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        self.with(self.value.abs())
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        self.with(root::root_of(coefficients, |coefficient| coefficient.value))
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> QuickWide<'a> {
        QuickWide { wide: Measured::two_sum(self.value, other.value), doubt: self.doubt }
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> QuickWide<'a> {
        QuickWide { wide: Measured::two_product(self.value, other.value), doubt: self.doubt }
    }

    #[inline(always)]
    fn wide_neg(wide: &QuickWide<'a>) -> QuickWide<'a> {
        wide.with(-wide.wide)
    }

    #[inline(always)]
    fn wide_add_exact(wide: &QuickWide<'a>, exact: &Self) -> QuickWide<'a> {
        wide.with(wide.wide + exact.value)
    }

    #[inline(always)]
    fn wide_add(left: &QuickWide<'a>, right: &QuickWide<'a>) -> QuickWide<'a> {
        left.with(left.wide + right.wide)
    }

    #[inline(always)]
    fn wide_mul_exact(wide: &QuickWide<'a>, exact: &Self) -> QuickWide<'a> {
        wide.with(wide.wide * exact.value)
    }

    #[inline(always)]
    fn wide_mul(left: &QuickWide<'a>, right: &QuickWide<'a>) -> QuickWide<'a> {
        left.with(left.wide * right.wide)
    }

    #[inline(always)]
    fn compensated(wide: &QuickWide<'a>, threshold: f64, _: &[&Self], _: &[u8]) -> Self {
        wide.doubt.set(wide.doubt.get() | !wide.wide.settled(threshold));
        wide.round()
    }

    #[inline(always)]
    fn residual(wide: &QuickWide<'a>) -> Self {
        wide.round()
    }
}
