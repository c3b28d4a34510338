//! `Real` for [`Bounded`]: a compensated expression is what `f64` makes of it, and its bound tells whether that does.

use super::{Bounded, Signs, root};
use crate::function::Function;
use crate::range::is_power_of_two;
use crate::real::Real;
use crate::terms::Terms;

impl<const WATCHED: bool> Real for Bounded<'_, WATCHED> {
    type Extended = Self;

    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        Bounded { power_of_two: is_power_of_two(value), ..self.exactly(value, Signs::of(value)) }
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        Bounded { count: 1, ..self.exactly(core::f64::consts::PI, Signs::POSITIVE) }
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        self.raise(true);
        self.exactly(f64::NAN, Signs::ANY)
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        self.sum(other)
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        self.sum(&other.neg())
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        self.product(other)
    }

    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        self.quotient(other)
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        Bounded { value: -self.value, signs: self.signs.negated(), ..*self }
    }

    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        self.called(function)
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.value.is_finite()
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        root::positive_root(self, coefficients)
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> Self {
        self.sum(other)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> Self {
        self.product(other)
    }

    #[inline(always)]
    fn extended_neg(extended: &Self) -> Self {
        extended.neg()
    }

    #[inline(always)]
    fn extended_add_exact(extended: &Self, exact: &Self) -> Self {
        extended.sum(exact)
    }

    #[inline(always)]
    fn extended_add(left: &Self, right: &Self) -> Self {
        left.sum(right)
    }

    #[inline(always)]
    fn extended_mul_exact(extended: &Self, exact: &Self) -> Self {
        extended.product(exact)
    }

    #[inline(always)]
    fn extended_mul(left: &Self, right: &Self) -> Self {
        left.product(right)
    }

    #[inline(always)]
    fn compensated(extended: &Self, _: f64, _: &[&Self], _: Terms) -> Self {
        *extended
    }

    #[inline(always)]
    fn residual(extended: &Self) -> Self {
        *extended
    }
}
