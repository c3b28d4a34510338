//! `Plain`: the arithmetic of default calls, `f64`, which raises doubt where a step may not be what it promises.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::exact::{self, Operand};
use crate::function::Function;
use crate::measured::Measured;
use crate::real::Real;
use crate::root;
use crate::soft::Soft;
use crate::terms::Terms;

/// What `f64` computes, in one of two ways, which return the same bits unless `doubt` is raised.
///
/// Not `WATCHED`, it is for inputs of the kernel's ordinary magnitudes, at which no step over- or underflows: nothing is
/// tested but what magnitudes do not decide, and loops over it vectorise. A `compensated!` expression that has to be summed
/// exactly raises doubt.
///
/// `WATCHED`, it is for all finite inputs: a step that over- or underflows raises doubt, and compensated expressions are summed exactly
/// where double-double cannot tell their digits.
#[derive(Clone, Copy)]
pub struct Plain<'a, const WATCHED: bool> {
    value: f64,
    doubt: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool> Plain<'a, WATCHED> {
    /// A number, and where to raise doubt.
    #[inline(always)]
    pub fn new(value: f64, doubt: &'a Cell<bool>) -> Self {
        Plain { value, doubt }
    }

    /// The number.
    #[inline(always)]
    pub fn value(self) -> f64 {
        self.value
    }

    /// A number that is as it should be, if `fine`.
    #[inline(always)]
    fn if_fine(&self, value: f64, fine: bool) -> Self {
        self.doubt.set(self.doubt.get() | !fine);
        Plain { value, doubt: self.doubt }
    }

    /// A number that is as it should be, if `fine` or nothing is watched.
    #[inline(always)]
    fn watched(&self, value: f64, fine: bool) -> Self {
        self.if_fine(value, !WATCHED | fine)
    }

    /// A number that is as it should be.
    #[inline(always)]
    fn with(&self, value: f64) -> Self {
        Plain { value, doubt: self.doubt }
    }
}

impl<const WATCHED: bool> PartialEq for Plain<'_, WATCHED> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const WATCHED: bool> PartialOrd for Plain<'_, WATCHED> {
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

/// A compensated expression, and where to raise doubt.
#[derive(Clone, Copy)]
pub struct PlainExtended<'a, const WATCHED: bool> {
    extended: Measured,
    doubt: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool> PlainExtended<'a, WATCHED> {
    #[inline(always)]
    fn with(&self, extended: Measured) -> Self {
        PlainExtended { extended, doubt: self.doubt }
    }

    /// A product of numbers with these leading parts.
    #[inline(always)]
    fn product(extended: Measured, a: f64, b: f64, doubt: &'a Cell<bool>) -> Self {
        PlainExtended { extended: if WATCHED { extended.watched(a, b) } else { extended }, doubt }
    }

    #[inline(always)]
    fn round(&self) -> Plain<'a, WATCHED> {
        Plain { value: self.extended.round(), doubt: self.doubt }
    }
}

impl<'a, const WATCHED: bool> Real for Plain<'a, WATCHED> {
    type Extended = PlainExtended<'a, WATCHED>;

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
        self.if_fine(f64::NAN, false)
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        let sum = self.value + other.value;
        self.watched(sum, sum.is_finite())
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        let difference = self.value - other.value;
        self.watched(difference, difference.is_finite())
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        let product = self.value * other.value;
        self.watched(product, product.is_normal() | (self.value == 0.0) | (other.value == 0.0))
    }

    /// Magnitudes do not tell that a divisor is not zero.
    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        let quotient = self.value / other.value;
        self.watched(quotient, quotient.is_normal() | (self.value == 0.0)).if_fine(quotient, other.value != 0.0)
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        self.with(-self.value)
    }

    /// Magnitudes do not tell that a function has a value; no value of a function over- or underflows.
    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        self.if_fine(function.double(self.value), function.is_defined(self.value))
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        let root = root::root_of(coefficients, |coefficient| coefficient.value);
        self.if_fine(root, root.is_normal())
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> PlainExtended<'a, WATCHED> {
        PlainExtended { extended: Measured::two_sum(self.value, other.value), doubt: self.doubt }
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> PlainExtended<'a, WATCHED> {
        let product = Measured::two_product(self.value, other.value);
        PlainExtended::product(product, self.value, other.value, self.doubt)
    }

    #[inline(always)]
    fn extended_neg(extended: &PlainExtended<'a, WATCHED>) -> PlainExtended<'a, WATCHED> {
        extended.with(-extended.extended)
    }

    #[inline(always)]
    fn extended_add_exact(extended: &PlainExtended<'a, WATCHED>, exact: &Self) -> PlainExtended<'a, WATCHED> {
        extended.with(extended.extended + exact.value)
    }

    #[inline(always)]
    fn extended_add(
        left: &PlainExtended<'a, WATCHED>,
        right: &PlainExtended<'a, WATCHED>,
    ) -> PlainExtended<'a, WATCHED> {
        left.with(left.extended + right.extended)
    }

    #[inline(always)]
    fn extended_mul_exact(extended: &PlainExtended<'a, WATCHED>, exact: &Self) -> PlainExtended<'a, WATCHED> {
        PlainExtended::product(extended.extended * exact.value, extended.extended.round(), exact.value, extended.doubt)
    }

    #[inline(always)]
    fn extended_mul(
        left: &PlainExtended<'a, WATCHED>,
        right: &PlainExtended<'a, WATCHED>,
    ) -> PlainExtended<'a, WATCHED> {
        PlainExtended::product(
            left.extended * right.extended,
            left.extended.round(),
            right.extended.round(),
            left.doubt,
        )
    }

    #[inline(always)]
    fn compensated(extended: &PlainExtended<'a, WATCHED>, threshold: f64, operands: &[&Self], terms: Terms) -> Self {
        let (rounded, settled) = (extended.round(), extended.extended.settled(threshold));
        if !WATCHED {
            return rounded.if_fine(rounded.value, settled);
        }
        if settled {
            return rounded.if_fine(rounded.value, rounded.value.is_normal());
        }
        let sum = exact::polynomial(operands, |operand| Operand::of(operand.value), terms).unwrap_or(Soft::NAN);
        let value = sum.to_f64();
        rounded.if_fine(value, value.is_normal() || sum.is_zero())
    }

    #[inline(always)]
    fn residual(extended: &PlainExtended<'a, WATCHED>) -> Self {
        let rounded = extended.round();
        rounded.watched(rounded.value, extended.extended.whole())
    }
}
