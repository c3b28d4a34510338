//! `FilteredDoubleDouble`: double-double as a program's arithmetic, which says when it leaves its range; what `faithful` runs in.
//!
//! A step in range, and a compensated expression, are off by as little as the [error model](crate::error_model) says.
//! What a program computes without cancellation outside its compensated expressions is therefore right to far better than
//! half a unit, and the leading part of its result less than one ulp from the true value.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::bounded_pair::BoundedPair;
use crate::double_double::DoubleDoubleWith;
use crate::error_free::{self, LARGEST_FACTOR};
use crate::escalating_pair::EscalatingPair;
use crate::function::Function;
use crate::operand::Operand;
use crate::polynomial::polynomial;
use crate::range;
use crate::real::Real;
use crate::root;
use crate::soft_float::SoftFloat;
use crate::terms::Terms;

/// A number in double-double; `escalate` is raised when a step leaves the range.
///
/// Not `WATCHED`, it is for inputs of the kernel's ordinary magnitudes, at which the products inside compensated
/// expressions are error-free; one that has to be summed exactly escalates, and loops over it vectorise. `WATCHED`, it is for
/// all finite inputs: a compensated expression in which a product may not be error-free is summed exactly, and so is one of which
/// a pair cannot tell the digits.
#[derive(Clone, Copy)]
pub struct FilteredDoubleDouble<'a, const WATCHED: bool, const FUSED: bool = { error_free::FUSED }> {
    value: DoubleDoubleWith<FUSED>,
    escalate: &'a Cell<bool>,
}

/// Between these magnitudes a step of numbers in range loses no digits.
const RANGE: (f64, f64) = (range::power_of_two(range::STEP.0), range::power_of_two(range::STEP.1));

impl<'a, const WATCHED: bool, const FUSED: bool> FilteredDoubleDouble<'a, WATCHED, FUSED> {
    /// Exact.
    #[inline(always)]
    pub fn new(value: f64, escalate: &'a Cell<bool>) -> Self {
        FilteredDoubleDouble { value: value.into(), escalate }.in_range(true)
    }

    /// The number.
    #[inline(always)]
    pub fn value(self) -> DoubleDoubleWith<FUSED> {
        self.value
    }

    /// The leading part.
    #[inline(always)]
    pub fn round(self) -> f64 {
        self.value.round()
    }

    /// Raises `escalate` unless the value is in range, or a zero that may be one.
    #[inline(always)]
    fn in_range(self, may_vanish: bool) -> Self {
        let size = self.value.round().abs();
        let inside = ((size >= RANGE.0) & (size <= RANGE.1)) | (may_vanish & (size == 0.0));
        self.escalate.set(self.escalate.get() | !inside);
        self
    }

    /// What a compensated expression evaluates to.
    #[inline(always)]
    fn of_pair(extended: &EscalatingPair<'a, WATCHED, FUSED>) -> Self {
        FilteredDoubleDouble { value: extended.pair.value(), escalate: extended.escalate }
    }

    #[inline(always)]
    fn with(&self, value: DoubleDoubleWith<FUSED>) -> Self {
        FilteredDoubleDouble { value, escalate: self.escalate }
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.value.round() == 0.0
    }
}

impl<const WATCHED: bool, const FUSED: bool> PartialEq for FilteredDoubleDouble<'_, WATCHED, FUSED> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const WATCHED: bool, const FUSED: bool> PartialOrd for FilteredDoubleDouble<'_, WATCHED, FUSED> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = self.value.round().partial_cmp(&other.value.round())?;
        Some(order.then(self.value.low().partial_cmp(&other.value.low())?))
    }
}

impl<'a, const WATCHED: bool, const FUSED: bool> Real for FilteredDoubleDouble<'a, WATCHED, FUSED> {
    type Extended = EscalatingPair<'a, WATCHED, FUSED>;

    /// One that cannot be split as a factor leaves the range; a smaller one only makes its product leave it.
    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        self.escalate.set(self.escalate.get() | (value.abs() > LARGEST_FACTOR));
        self.with(value.into())
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        // with what the leading part leaves off
        self.with(DoubleDoubleWith::two_sum(core::f64::consts::PI, 1.224_646_799_147_353_2e-16))
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        self.with(f64::NAN.into()).in_range(false)
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

    /// Where there is no value it is NaN, which leaves the range.
    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        let value = self.with(function.double_double(self.value));
        if function.is_exact() { value } else { value.in_range(function.may_vanish(self.value.round())) }
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.value.round().is_finite()
    }

    /// To the digits of `f64`: the iterate, which a `residual!` corrects.
    fn positive_root(&self, coefficients: &[Self]) -> Self {
        let root = root::root_of(coefficients, |coefficient| coefficient.value.round());
        self.with(root.into()).in_range(false)
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> EscalatingPair<'a, WATCHED, FUSED> {
        EscalatingPair::new(BoundedPair::two_sum(self.value.round(), other.value.round()), self.escalate)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> EscalatingPair<'a, WATCHED, FUSED> {
        EscalatingPair::new(BoundedPair::two_product(self.value.round(), other.value.round()), self.escalate)
    }

    #[inline(always)]
    fn extended_neg(extended: &EscalatingPair<'a, WATCHED, FUSED>) -> EscalatingPair<'a, WATCHED, FUSED> {
        extended.with(-extended.pair)
    }

    #[inline(always)]
    fn extended_add_exact(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        exact: &Self,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        extended.with(extended.pair + exact.value.round())
    }

    #[inline(always)]
    fn extended_add(
        left: &EscalatingPair<'a, WATCHED, FUSED>,
        right: &EscalatingPair<'a, WATCHED, FUSED>,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        left.with(left.pair + right.pair)
    }

    #[inline(always)]
    fn extended_mul_exact(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        exact: &Self,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        extended.with(extended.pair * exact.value.round())
    }

    #[inline(always)]
    fn extended_mul(
        left: &EscalatingPair<'a, WATCHED, FUSED>,
        right: &EscalatingPair<'a, WATCHED, FUSED>,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        left.with(left.pair * right.pair)
    }

    #[inline(always)]
    fn scaled(&self, power: &Self) -> EscalatingPair<'a, WATCHED, FUSED> {
        EscalatingPair::new(BoundedPair::scaled(self.value.round(), power.value.round()), self.escalate)
    }

    #[inline(always)]
    fn extended_scaled(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        power: &Self,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        extended.with(extended.pair.times_power(power.value.round()))
    }

    #[inline(always)]
    fn compensated(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        threshold: f64,
        operands: &[&Self],
        terms: Terms,
    ) -> Self {
        let passes = extended.pair.passes(threshold);
        if !WATCHED || passes {
            extended.escalate.set(extended.escalate.get() | !passes);
            return Self::of_pair(extended).in_range(true);
        }
        let read = |operand: &Self| Operand::of(operand.value.round());
        let sum = polynomial(operands, read, terms).unwrap_or(SoftFloat::NAN);
        let (high, low) = sum.split();
        let value = FilteredDoubleDouble { value: DoubleDoubleWith::two_sum(high, low), escalate: extended.escalate };
        value.in_range(sum.is_zero())
    }

    /// A residual of zero is as good as any below the last digit of the iterate.
    #[inline(always)]
    fn residual(extended: &EscalatingPair<'a, WATCHED, FUSED>) -> Self {
        extended.escalate.set(extended.escalate.get() | !extended.pair.whole());
        Self::of_pair(extended).in_range(true)
    }
}
