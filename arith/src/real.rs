//! `Real`: any arithmetic in which a program can run.

use crate::function::Function;
use crate::terms::Terms;

/// An arithmetic in which the program of a kernel can run.
///
/// Expansions of `#[kernel]` call nothing else, nor does the interpreter, so a program means the same in all of them: in
/// `f64` what users call, in `Mpfr` what judges measure it against.
///
/// [`Extended`](Self::Extended) is what a `compensated!` or `residual!` expression is evaluated in. Its operands count as exact; sums
/// and products of them take the cheapest operation that their kinds allow.
pub trait Real: Clone + PartialOrd {
    /// The type of extended precision of a compensated expression.
    type Extended: Clone;

    /// The number `value`, in the precision of `self`.
    fn literal(&self, value: f64) -> Self;
    /// The circle constant, in the precision of `self`.
    fn pi(&self) -> Self;
    /// Not a number, in the precision of `self`.
    fn nan(&self) -> Self;

    /// `self + other`
    fn add(&self, other: &Self) -> Self;
    /// `self - other`
    fn sub(&self, other: &Self) -> Self;
    /// `self * other`
    fn mul(&self, other: &Self) -> Self;
    /// `self / other`
    fn div(&self, other: &Self) -> Self;
    /// `-self`
    fn neg(&self) -> Self;
    /// The value of a function; NaN where it has none.
    fn call(&self, function: Function) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(&self) -> bool;
    /// The one positive root of c0 + c1 x + .. + cn x^n: see [`positive_root`](crate::positive_root()). `self` sets the
    /// precision.
    fn positive_root(&self, coefficients: &[Self]) -> Self;

    /// `self + other`, error-free in `f64`.
    fn two_sum(&self, other: &Self) -> Self::Extended;
    /// `self * other`, error-free in `f64`.
    fn two_product(&self, other: &Self) -> Self::Extended;
    /// `-extended`
    fn extended_neg(extended: &Self::Extended) -> Self::Extended;
    /// `extended + exact`
    fn extended_add_exact(extended: &Self::Extended, exact: &Self) -> Self::Extended;
    /// `left + right`
    fn extended_add(left: &Self::Extended, right: &Self::Extended) -> Self::Extended;
    /// `extended * exact`
    fn extended_mul_exact(extended: &Self::Extended, exact: &Self) -> Self::Extended;
    /// `left * right`
    fn extended_mul(left: &Self::Extended, right: &Self::Extended) -> Self::Extended;
    /// `self * power`, a power of two in the text of the program: exact in `f64`
    #[inline(always)]
    fn scaled(&self, power: &Self) -> Self::Extended {
        self.two_product(power)
    }
    /// `extended * power`, a power of two in the text of the program
    #[inline(always)]
    fn extended_scaled(extended: &Self::Extended, power: &Self) -> Self::Extended {
        Self::extended_mul_exact(extended, power)
    }
    /// The value of a `compensated!` expression, to all digits: `extended` rounded once, if it is larger than `threshold` times
    /// the sum of the magnitudes of its terms; otherwise the sum of products that `terms` make of `operands`, exactly.
    fn compensated(extended: &Self::Extended, threshold: f64, operands: &[&Self], terms: Terms) -> Self;
    /// The value of a `residual!` expression: `extended`, rounded once.
    fn residual(extended: &Self::Extended) -> Self;
}
