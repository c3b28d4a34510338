//! Programs in balls: `Real` for `Ball`.

use super::limbs::Limbs;
use super::radius::Radius;
use super::{Ball, Kind, root};
use crate::function::Function;
use crate::real::Real;
use crate::terms::Terms;

impl<const L: usize> Real for Ball<'_, L> {
    type Wide = Self;

    fn literal(&self, value: f64) -> Self {
        Ball::new(value, self.settling)
    }

    fn pi(&self) -> Self {
        self.of(Limbs::from_fraction(2, &root::PI), Radius::ZERO, None)
    }

    fn nan(&self) -> Self {
        Self::without_value(Kind::Nothing, self.settling)
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

    fn wide_neg(wide: &Self) -> Self {
        wide.negated()
    }

    fn wide_add_exact(wide: &Self, exact: &Self) -> Self {
        wide.plus(exact)
    }

    fn wide_add(left: &Self, right: &Self) -> Self {
        left.plus(right)
    }

    fn wide_mul_exact(wide: &Self, exact: &Self) -> Self {
        wide.times(exact)
    }

    fn wide_mul(left: &Self, right: &Self) -> Self {
        left.times(right)
    }

    fn compensated(wide: &Self, _: f64, _: &[&Self], _: Terms) -> Self {
        wide.clone()
    }

    fn residual(wide: &Self) -> Self {
        wide.clone()
    }
}
