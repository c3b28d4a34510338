//! The arithmetic of `evaluate` in `f64`, and of the rounding errors that judges look at: `Real` for `f64`.

use crate::exact::{self, Operand};
use crate::function::Function;
use crate::measured::Measured;
use crate::real::Real;
use crate::root;
use crate::soft::Soft;
use crate::terms::Terms;

impl Real for f64 {
    type Extended = Measured;

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
    fn two_sum(&self, other: &Self) -> Measured {
        Measured::two_sum(*self, *other)
    }

    #[inline(always)]
    fn two_product(&self, other: &Self) -> Measured {
        Measured::two_product(*self, *other)
    }

    #[inline(always)]
    fn extended_neg(extended: &Measured) -> Measured {
        -*extended
    }

    #[inline(always)]
    fn extended_add_exact(extended: &Measured, exact: &Self) -> Measured {
        *extended + *exact
    }

    #[inline(always)]
    fn extended_add(left: &Measured, right: &Measured) -> Measured {
        *left + *right
    }

    #[inline(always)]
    fn extended_mul_exact(extended: &Measured, exact: &Self) -> Measured {
        *extended * *exact
    }

    #[inline(always)]
    fn extended_mul(left: &Measured, right: &Measured) -> Measured {
        *left * *right
    }

    #[inline(always)]
    fn compensated(extended: &Measured, threshold: f64, operands: &[&Self], terms: Terms) -> Self {
        if extended.settled(threshold) {
            extended.round()
        } else {
            exact::polynomial(operands, |operand| Operand::of(*operand), terms).map_or(f64::NAN, Soft::to_f64)
        }
    }

    #[inline(always)]
    fn residual(extended: &Measured) -> Self {
        extended.round()
    }
}
