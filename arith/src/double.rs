//! The arithmetic of `evaluate` in `f64`, and of the rounding errors that judges look at: `Real` for `f64`.

use crate::bounded_pair::BoundedPair;
use crate::function::Function;
use crate::operand::Operand;
use crate::polynomial::polynomial;
use crate::real::Real;
use crate::root;
use crate::soft_float::SoftFloat;
use crate::terms::Terms;

impl Real for f64 {
    type Extended = BoundedPair<true>;

    #[inline(always)]
    fn literal(&self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn pi(&self) -> Self {
        core::f64::consts::PI
    }

    #[inline(always)]
    fn nan(&self) -> Self {
        f64::NAN
    }

    #[inline(always)]
    fn add(&self, other: &Self) -> Self {
        self + other
    }

    #[inline(always)]
    fn sub(&self, other: &Self) -> Self {
        self - other
    }

    #[inline(always)]
    fn mul(&self, other: &Self) -> Self {
        self * other
    }

    #[inline(always)]
    fn div(&self, other: &Self) -> Self {
        self / other
    }

    #[inline(always)]
    fn neg(&self) -> Self {
        -self
    }

    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        function.double(*self)
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn positive_root(&self, coefficients: &[Self]) -> Self {
        root::positive_root(coefficients)
    }

    #[inline(always)]
    fn two_sum(&self, other: &Self) -> BoundedPair<true> {
        BoundedPair::two_sum(*self, *other)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> BoundedPair<true> {
        BoundedPair::two_product(*self, *other)
    }

    #[inline(always)]
    fn extended_neg(extended: &BoundedPair<true>) -> BoundedPair<true> {
        -*extended
    }

    #[inline(always)]
    fn extended_add_exact(extended: &BoundedPair<true>, exact: &Self) -> BoundedPair<true> {
        *extended + *exact
    }

    #[inline(always)]
    fn extended_add(left: &BoundedPair<true>, right: &BoundedPair<true>) -> BoundedPair<true> {
        *left + *right
    }

    #[inline(always)]
    fn extended_mul_exact(extended: &BoundedPair<true>, exact: &Self) -> BoundedPair<true> {
        *extended * *exact
    }

    #[inline(always)]
    fn extended_mul(left: &BoundedPair<true>, right: &BoundedPair<true>) -> BoundedPair<true> {
        *left * *right
    }

    #[inline(always)]
    fn scaled(&self, power: &Self) -> BoundedPair<true> {
        BoundedPair::scaled(*self, *power)
    }

    #[inline(always)]
    fn extended_scaled(extended: &BoundedPair<true>, power: &Self) -> BoundedPair<true> {
        extended.times_power(*power)
    }

    #[inline(always)]
    fn compensated(extended: &BoundedPair<true>, threshold: f64, operands: &[&Self], terms: Terms) -> Self {
        if extended.passes(threshold) && extended.whole() {
            extended.round()
        } else {
            polynomial(operands, |operand| Operand::of(*operand), terms).map_or(f64::NAN, SoftFloat::to_f64)
        }
    }

    #[inline(always)]
    fn residual(extended: &BoundedPair<true>) -> Self {
        extended.round()
    }
}
