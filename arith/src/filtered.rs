//! `Filtered`: the arithmetic of default calls, `f64`, which escalates where a step may not be what it promises.

use core::cell::Cell;
use core::cmp::Ordering;

use crate::bounded_pair::BoundedPair;
use crate::error_free;
use crate::escalating_pair::EscalatingPair;
use crate::function::Function;
use crate::operand::Operand;
use crate::polynomial::polynomial;
use crate::real::Real;
use crate::root;
use crate::soft_float::SoftFloat;
use crate::terms::Terms;

/// What `f64` computes, in one of two ways, which return the same bits unless `escalate` is raised.
///
/// Not `WATCHED`, it is for inputs of the kernel's ordinary magnitudes, at which no step over- or underflows: nothing is
/// tested but what magnitudes do not decide, and loops over it vectorise. A `compensated!` expression that has to be summed
/// exactly escalates.
///
/// `WATCHED`, it is for all finite inputs: a step that over- or underflows escalates, and compensated expressions are summed exactly
/// where double-double cannot tell their digits.
#[derive(Clone, Copy)]
pub struct Filtered<'a, const WATCHED: bool, const FUSED: bool = { error_free::FUSED }> {
    value: f64,
    escalate: &'a Cell<bool>,
}

impl<'a, const WATCHED: bool, const FUSED: bool> Filtered<'a, WATCHED, FUSED> {
    /// A number, and the flag that it raises to escalate.
    #[inline(always)]
    pub fn new(value: f64, escalate: &'a Cell<bool>) -> Self {
        Filtered { value, escalate }
    }

    /// The number.
    #[inline(always)]
    pub fn value(self) -> f64 {
        self.value
    }

    /// A number that is as it should be, if `fine`.
    #[inline(always)]
    fn if_fine(&self, value: f64, fine: bool) -> Self {
        self.escalate.set(self.escalate.get() | !fine);
        Filtered { value, escalate: self.escalate }
    }

    /// A number that is as it should be, if `fine` or nothing is watched.
    #[inline(always)]
    fn watched(&self, value: f64, fine: bool) -> Self {
        self.if_fine(value, !WATCHED | fine)
    }

    /// A compensated expression rounded.
    #[inline(always)]
    fn rounded(extended: &EscalatingPair<'a, WATCHED, FUSED>) -> Self {
        Filtered { value: extended.pair.round(), escalate: extended.escalate }
    }

    /// A number that is as it should be.
    #[inline(always)]
    fn with(&self, value: f64) -> Self {
        Filtered { value, escalate: self.escalate }
    }
}

impl<const WATCHED: bool, const FUSED: bool> PartialEq for Filtered<'_, WATCHED, FUSED> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const WATCHED: bool, const FUSED: bool> PartialOrd for Filtered<'_, WATCHED, FUSED> {
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

impl<'a, const WATCHED: bool, const FUSED: bool> Real for Filtered<'a, WATCHED, FUSED> {
    type Extended = EscalatingPair<'a, WATCHED, FUSED>;

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

    /// Magnitudes do not tell that a function has a value. That of a power is in range where its argument is. An integer is taken for
    /// what `f64` makes of the argument, as the outcome of a comparison is: [`Bounded`](crate::Bounded) and balls doubt both.
    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        let value = function.double(self.value);
        let in_range = function.is_power() | value.is_normal() | ((value == 0.0) & function.may_vanish(self.value));
        self.if_fine(value, function.is_defined(self.value) & in_range)
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
    fn two_sum(&self, other: &Self) -> EscalatingPair<'a, WATCHED, FUSED> {
        EscalatingPair::new(BoundedPair::two_sum(self.value, other.value), self.escalate)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> EscalatingPair<'a, WATCHED, FUSED> {
        EscalatingPair::new(BoundedPair::two_product(self.value, other.value), self.escalate)
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
        extended.with(extended.pair + exact.value)
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
        extended.with(extended.pair * exact.value)
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
        EscalatingPair::new(BoundedPair::scaled(self.value, power.value), self.escalate)
    }

    #[inline(always)]
    fn extended_scaled(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        power: &Self,
    ) -> EscalatingPair<'a, WATCHED, FUSED> {
        extended.with(extended.pair.times_power(power.value))
    }

    #[inline(always)]
    fn compensated(
        extended: &EscalatingPair<'a, WATCHED, FUSED>,
        threshold: f64,
        operands: &[&Self],
        terms: Terms,
    ) -> Self {
        let (rounded, passes) = (Filtered::rounded(extended), extended.pair.passes(threshold));
        if !WATCHED {
            return rounded.if_fine(rounded.value, passes);
        }
        if passes {
            // a zero is exact
            return rounded.if_fine(rounded.value, rounded.value.is_normal() | (rounded.value == 0.0));
        }
        let sum = polynomial(operands, |operand| Operand::of(operand.value), terms).unwrap_or(SoftFloat::NAN);
        let value = sum.to_f64();
        rounded.if_fine(value, value.is_normal() || sum.is_zero())
    }

    #[inline(always)]
    fn residual(extended: &EscalatingPair<'a, WATCHED, FUSED>) -> Self {
        let rounded = Filtered::rounded(extended);
        rounded.watched(rounded.value, extended.pair.whole())
    }
}
