//! Programs in integers with an endless exponent: `Real` for `SoftFloat`.

use super::{Kind, SoftFloat};
use crate::function::Function;
use crate::operand::Operand;
use crate::polynomial::polynomial;
use crate::real::Real;
use crate::root;
use crate::terms::Terms;

impl SoftFloat {
    /// Rounded to 53 bits; `None` unless it is a number.
    fn operand(self) -> Option<Operand> {
        let operand = Operand::of(self.scaled().to_f64())?;
        Some(Operand { exponent: operand.exponent + self.leading(), ..operand })
    }
}

impl Real for SoftFloat {
    type Extended = SoftFloat;

    fn literal(&self, value: f64) -> Self {
        SoftFloat::from_f64(value)
    }

    fn pi(&self) -> Self {
        // the first 128 bits
        SoftFloat::new(false, 0xc90f_daa2_2168_c234_c4c6_628b_80dc_1cd1, -126, true)
    }

    fn nan(&self) -> Self {
        SoftFloat::NAN
    }

    fn add(&self, other: &Self) -> Self {
        self.plus(*other)
    }

    fn sub(&self, other: &Self) -> Self {
        self.plus(other.negated())
    }

    fn mul(&self, other: &Self) -> Self {
        self.times(*other)
    }

    fn div(&self, other: &Self) -> Self {
        self.over(*other)
    }

    fn neg(&self) -> Self {
        self.negated()
    }

    /// Inlined, so that a kernel links the functions that it calls, and no other.
    #[inline(always)]
    fn call(&self, function: Function) -> Self {
        function.soft(*self)
    }

    fn is_finite(&self) -> bool {
        self.kind != Kind::Nan
    }

    /// To the digits of `f64`: the iterate, which a `residual!` corrects.
    fn positive_root(&self, coefficients: &[Self]) -> Self {
        if coefficients.iter().any(|c| c.kind == Kind::Nan) {
            return SoftFloat::NAN;
        }
        let term =
            |c: &Self| (c.kind == Kind::Normal).then(|| root::Term { negative: c.negative, exponent: c.leading() });
        let moved = |c: &Self, by: i64| SoftFloat { exponent: c.exponent.saturating_add(by), ..*c }.to_f64();
        match root::scaled_root(coefficients, term, moved) {
            Some((root, bound)) => {
                let root = SoftFloat::from_f64(root);
                SoftFloat { exponent: root.exponent + bound, ..root }
            }
            None => SoftFloat::NAN,
        }
    }

    fn two_sum(&self, other: &Self) -> Self {
        self.plus(*other)
    }

    fn two_product(&self, other: &Self) -> Self {
        self.times(*other)
    }

    fn extended_neg(extended: &Self) -> Self {
        extended.negated()
    }

    fn extended_add_exact(extended: &Self, exact: &Self) -> Self {
        extended.plus(*exact)
    }

    fn extended_add(left: &Self, right: &Self) -> Self {
        left.plus(*right)
    }

    fn extended_mul_exact(extended: &Self, exact: &Self) -> Self {
        extended.times(*exact)
    }

    fn extended_mul(left: &Self, right: &Self) -> Self {
        left.times(*right)
    }

    /// Exact, but for the bits that are cut off; of operands the first 53 bits count, as in `f64`, with any exponent. Where
    /// terms lie too far apart to be summed exactly, right to 2^-120 of the largest.
    fn compensated(extended: &Self, _: f64, operands: &[&Self], terms: Terms) -> Self {
        polynomial(operands, |operand| operand.operand(), terms).unwrap_or(*extended)
    }

    fn residual(extended: &Self) -> Self {
        *extended
    }
}
