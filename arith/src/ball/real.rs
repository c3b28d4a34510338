//! Programs in balls: `Real` for `Ball`.

use super::enclosure::Enclosure;
use super::{Ball, Kind, root};
use crate::function::Function;
use crate::real::Real;
use crate::terms::Terms;

impl<const L: usize> Real for Ball<'_, L> {
    type Extended = Self;

    fn literal(&self, value: f64) -> Self {
        Ball::new(value, self.decisions)
    }

    fn pi(&self) -> Self {
        self.enclosed_in(Enclosure::pi(0), None)
    }

    fn nan(&self) -> Self {
        Self::without_value(Kind::Nothing, self.decisions)
    }

    fn add(&self, other: &Self) -> Self {
        self.plus(other)
    }

    fn sub(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    fn mul(&self, other: &Self) -> Self {
        self.times(other)
    }

    fn div(&self, other: &Self) -> Self {
        self.over(other)
    }

    fn neg(&self) -> Self {
        self.negated()
    }

    /// Inlined, so that a kernel links the functions that it calls, and no other.
    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        function.ball(self)
    }

    fn is_finite(&self) -> bool {
        self.kind != Kind::Nothing
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        root::positive_root(self, coefficients)
    }

    fn two_sum(&self, other: &Self) -> Self {
        self.plus(other)
    }

    fn two_product(&self, other: &Self) -> Self {
        self.times(other)
    }

    fn extended_neg(extended: &Self) -> Self {
        extended.negated()
    }

    fn extended_add_exact(extended: &Self, exact: &Self) -> Self {
        extended.plus(exact)
    }

    fn extended_add(left: &Self, right: &Self) -> Self {
        left.plus(right)
    }

    fn extended_mul_exact(extended: &Self, exact: &Self) -> Self {
        extended.times(exact)
    }

    fn extended_mul(left: &Self, right: &Self) -> Self {
        left.times(right)
    }

    fn compensated(extended: &Self, _: f64, _: &[&Self], _: Terms) -> Self {
        extended.clone()
    }

    fn residual(extended: &Self) -> Self {
        extended.clone()
    }
}
