//! `FilteredDoubleDouble`: double-double as a program's arithmetic, which says when it leaves its range; what `faithful` runs in.
//!
//! A step in range, and a compensated expression, are off by as little as the [error model](crate::error_model) says.
//! What a program computes without cancellation outside its compensated expressions is therefore right to far better than
//! half a unit, and the leading part of its result less than one ulp from the true value.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::bounded_pair::BoundedPair;
use crate::double_double::DoubleDouble;
use crate::error_free::LARGEST_FACTOR;
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
/// expressions are error-free. `WATCHED`, it is for all finite inputs: a compensated expression in which one may not be
/// is summed exactly.
#[derive(Clone, Copy)]
pub struct FilteredDoubleDouble<'a, const WATCHED: bool> {
    value: DoubleDouble,
    escalate: &'a Cell<bool>,
}

/// Between these magnitudes a step of numbers in range loses no digits.
const RANGE: (f64, f64) = (range::power_of_two(range::STEP.0), range::power_of_two(range::STEP.1));

impl<'a, const WATCHED: bool> FilteredDoubleDouble<'a, WATCHED> {
    /// Exact.
    #[inline(always)]
    pub fn new(value: f64, escalate: &'a Cell<bool>) -> Self {
        FilteredDoubleDouble { value: value.into(), escalate }.in_range(true)
    }

    /// The number.
    #[inline(always)]
    pub fn value(self) -> DoubleDouble {
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

    #[inline(always)]
    fn with(&self, value: DoubleDouble) -> Self {
        FilteredDoubleDouble { value, escalate: self.escalate }
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.value.round() == 0.0
    }
}

impl<const WATCHED: bool> PartialEq for FilteredDoubleDouble<'_, WATCHED> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const WATCHED: bool> PartialOrd for FilteredDoubleDouble<'_, WATCHED> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = self.value.round().partial_cmp(&other.value.round())?;
        Some(order.then(self.value.low().partial_cmp(&other.value.low())?))
    }
}

/// A compensated expression, and where to raise what it leaves.
#[derive(Clone, Copy)]
pub struct FilteredDoubleDoubleExtended<'a, const WATCHED: bool> {
    extended: BoundedPair,
    escalate: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool> FilteredDoubleDoubleExtended<'a, WATCHED> {
    #[inline(always)]
    fn with(&self, extended: BoundedPair) -> Self {
        FilteredDoubleDoubleExtended { extended, escalate: self.escalate }
    }

    /// A product of parts with these high ones.
    #[inline(always)]
    fn product(extended: BoundedPair, a: f64, b: f64, escalate: &'a Cell<bool>) -> Self {
        FilteredDoubleDoubleExtended { extended: if WATCHED { extended.watched(a, b) } else { extended }, escalate }
    }

    #[inline(always)]
    fn value(&self) -> FilteredDoubleDouble<'a, WATCHED> {
        FilteredDoubleDouble { value: self.extended.value(), escalate: self.escalate }
    }
}

impl<'a, const WATCHED: bool> Real for FilteredDoubleDouble<'a, WATCHED> {
    type Extended = FilteredDoubleDoubleExtended<'a, WATCHED>;

    /// One that cannot be split as a factor leaves the range; a smaller one only makes its product leave it.
    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        self.escalate.set(self.escalate.get() | (value.abs() > LARGEST_FACTOR));
        self.with(value.into())
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        // with what the leading part leaves off
        self.with(DoubleDouble::two_sum(core::f64::consts::PI, 1.224_646_799_147_353_2e-16))
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
    fn two_sum(&self, other: &Self) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        FilteredDoubleDoubleExtended {
            extended: BoundedPair::two_sum(self.value.round(), other.value.round()),
            escalate: self.escalate,
        }
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        let (a, b) = (self.value.round(), other.value.round());
        FilteredDoubleDoubleExtended::product(BoundedPair::two_product(a, b), a, b, self.escalate)
    }

    #[inline(always)]
    fn extended_neg(extended: &FilteredDoubleDoubleExtended<'a, WATCHED>) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        extended.with(-extended.extended)
    }

    #[inline(always)]
    fn extended_add_exact(
        extended: &FilteredDoubleDoubleExtended<'a, WATCHED>,
        exact: &Self,
    ) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        extended.with(extended.extended + exact.value.round())
    }

    #[inline(always)]
    fn extended_add(
        left: &FilteredDoubleDoubleExtended<'a, WATCHED>,
        right: &FilteredDoubleDoubleExtended<'a, WATCHED>,
    ) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        left.with(left.extended + right.extended)
    }

    #[inline(always)]
    fn extended_mul_exact(
        extended: &FilteredDoubleDoubleExtended<'a, WATCHED>,
        exact: &Self,
    ) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        let exact = exact.value.round();
        FilteredDoubleDoubleExtended::product(
            extended.extended * exact,
            extended.extended.high(),
            exact,
            extended.escalate,
        )
    }

    #[inline(always)]
    fn extended_mul(
        left: &FilteredDoubleDoubleExtended<'a, WATCHED>,
        right: &FilteredDoubleDoubleExtended<'a, WATCHED>,
    ) -> FilteredDoubleDoubleExtended<'a, WATCHED> {
        FilteredDoubleDoubleExtended::product(
            left.extended * right.extended,
            left.extended.high(),
            right.extended.high(),
            left.escalate,
        )
    }

    #[inline(always)]
    fn compensated(
        extended: &FilteredDoubleDoubleExtended<'a, WATCHED>,
        threshold: f64,
        operands: &[&Self],
        terms: Terms,
    ) -> Self {
        if extended.extended.passes(threshold) {
            return extended.value().in_range(false);
        }
        let read = |operand: &Self| Operand::of(operand.value.round());
        let sum = polynomial(operands, read, terms).unwrap_or(SoftFloat::NAN);
        let (high, low) = sum.split();
        let value = FilteredDoubleDouble { value: DoubleDouble::two_sum(high, low), escalate: extended.escalate };
        value.in_range(sum.is_zero())
    }

    /// A residual of zero is as good as any below the last digit of the iterate.
    #[inline(always)]
    fn residual(extended: &FilteredDoubleDoubleExtended<'a, WATCHED>) -> Self {
        extended.escalate.set(extended.escalate.get() | !extended.extended.whole());
        extended.value().in_range(true)
    }
}
