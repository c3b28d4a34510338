//! Polynomials as maps from exponents to coefficients: the implementation for tests, and for programs without Symbolica.
//!
//! It is written to be read and to be right, and is slow where polynomials are large. The algorithms are those of the
//! textbooks: D. E. Knuth, *The Art of Computer Programming*, volume 2, sections 4.6.1 and 4.6.2; J. von zur Gathen and
//! J. Gerhard, *Modern Computer Algebra*, chapters 6, 14 and 15.

mod arithmetic;
mod factor;
mod gcd;
mod recombine;
mod univariate;

pub use arithmetic::Sparse;

use super::{Implementation, Term, Var};
use num_rational::BigRational;

impl Implementation for Sparse {
    fn term(coefficient: &BigRational, exponents: &[u16]) -> Self {
        Sparse::term(coefficient, exponents)
    }

    fn size(&self) -> usize {
        Sparse::size(self)
    }

    fn terms(&self) -> Vec<Term> {
        let term = |(exponents, coefficient): (&Vec<u16>, &BigRational)| Term {
            coefficient: coefficient.clone(),
            exponents: exponents.clone(),
        };
        self.terms.iter().map(term).collect()
    }

    fn count(&self) -> usize {
        Sparse::count(self)
    }

    fn degree(&self, var: Var) -> u16 {
        Sparse::degree(self, var)
    }

    fn plus(&self, other: &Self) -> Self {
        Sparse::plus(self, other)
    }

    fn times(&self, other: &Self) -> Self {
        Sparse::times(self, other)
    }

    fn scaled(&self, factor: &BigRational) -> Self {
        Sparse::scaled(self, factor)
    }

    fn power(&self, exponent: u32) -> Self {
        Sparse::power(self, exponent)
    }

    fn gcd(&self, other: &Self) -> Self {
        gcd::gcd(self, other)
    }

    fn quotient(&self, other: &Self) -> Option<Self> {
        Sparse::quotient(self, other)
    }

    fn factors(&self) -> Vec<(Self, u32)> {
        factor::factors(self)
    }
}
