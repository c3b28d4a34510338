//! Irreducible factors by those of an image in one variable modulo a large prime.
//!
//! Kronecker's substitution makes a polynomial in one variable of one in several, x^d for each next variable with d beyond
//! all degrees before; a factor of the polynomial has a factor of the image for its image, and that is a product of some
//! of its factors modulo the prime: Knuth, section 4.6.2; von zur Gathen and Gerhard, section 15.3, of which this is the
//! case of a prime that is beyond the coefficients of all factors.

use super::arithmetic::Sparse;
use super::univariate::{Field, Modular};
use crate::algebra::Var;
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The irreducible factors of a polynomial that has integer coefficients and no content in any of its variables. One whose
/// factors may have coefficients beyond all primes that are known here counts as irreducible.
///
/// The origin is moved before, since the images of sparse polynomials have many more factors modulo a prime.
pub fn factors(polynomial: &Sparse) -> Vec<Sparse> {
    let several = polynomial.variables().len() > 1;
    let shifts: Vec<(Var, i64)> = polynomial.variables().into_iter().zip(1..).filter(|_| several).collect();
    let shifted = shifts.iter().fold(polynomial.clone(), |shifted, &(var, by)| shifted.shifted(var, by));
    let back = |factor| shifts.iter().fold(factor, |factor: Sparse, &(var, by)| factor.shifted(var, -by)).integral();
    factors_of_shifted(&shifted.integral()).into_iter().map(back).collect()
}

fn factors_of_shifted(polynomial: &Sparse) -> Vec<Sparse> {
    let Some(field) = Field::beyond(&bound(polynomial)) else { return vec![polynomial.clone()] };
    let substitution = Substitution::of(polynomial);
    let mut search = Search { rest: polynomial.integral(), open: Vec::new(), substitution, field };
    search.open = search.field.factors(&search.image());
    let mut found = Vec::new();
    let mut count = 1;
    while 2 * count <= search.open.len() {
        match search.factor_of(count) {
            Some(factor) => found.push(factor),
            None => count += 1,
        }
    }
    if !search.rest.is_constant() {
        found.push(search.rest);
    }
    found
}

/// More than the product of the largest coefficients of a factor and of its cofactor, in magnitude: Gelfond's lemma (E.
/// Bombieri and W. Gubler, *Heights in Diophantine Geometry*, lemma 1.6.11).
fn bound(polynomial: &Sparse) -> BigUint {
    let degrees: u32 = polynomial.variables().into_iter().map(|var| u32::from(polynomial.degree(var))).sum();
    let integral = polynomial.integral();
    let largest = integral.terms.values().map(|value| value.numer().magnitude().clone()).max().unwrap_or_default();
    (largest + 1_u32) << degrees
}

/// The exponents of several variables as the digits of one.
struct Substitution(Vec<(Var, usize)>);

impl Substitution {
    fn of(polynomial: &Sparse) -> Self {
        let bases = polynomial.variables().into_iter().map(|var| (var, usize::from(polynomial.degree(var)) + 1));
        Self(bases.collect())
    }

    fn exponent(&self, exponents: &[u16]) -> usize {
        self.0.iter().rev().fold(0, |sum, (var, base)| sum * base + usize::from(exponents[var.0]))
    }

    fn exponents(&self, size: usize, mut exponent: usize) -> Vec<u16> {
        let mut exponents = vec![0; size];
        for (var, base) in &self.0 {
            exponents[var.0] = (exponent % base) as u16;
            exponent /= base;
        }
        exponents
    }
}

/// What is left to be factored, and the factors modulo the prime that are left of its image.
struct Search {
    rest: Sparse,
    open: Vec<Modular>,
    substitution: Substitution,
    field: Field,
}

impl Search {
    fn image(&self) -> Modular {
        let length = self.rest.terms.keys().map(|exponents| self.substitution.exponent(exponents) + 1).max();
        let mut image = vec![Sparse::zero(0); length.unwrap_or(0)];
        for (exponents, coefficient) in &self.rest.terms {
            image[self.substitution.exponent(exponents)] = Sparse::term(coefficient, &[]);
        }
        self.field.polynomial(&image, |_| BigInt::zero())
    }

    /// A factor whose image has so many factors modulo the prime; what is left is then without it.
    fn factor_of(&mut self, count: usize) -> Option<Sparse> {
        let image = self.image();
        let leading = image.last()?;
        let mut chosen: Vec<usize> = (0..count).collect();
        loop {
            let one = vec![BigUint::one()];
            let product = chosen.iter().fold(one, |product, &index| self.field.times(&product, &self.open[index]));
            let candidate = self.candidate(&self.field.scaled(&product, leading));
            if let Some(quotient) = self.rest.quotient(&candidate) {
                self.rest = quotient.integral();
                chosen.iter().rev().for_each(|&index| drop(self.open.remove(index)));
                return Some(candidate);
            }
            chosen = next_choice(chosen, self.open.len())?;
        }
    }

    fn candidate(&self, image: &[BigUint]) -> Sparse {
        let mut candidate = Sparse::zero(self.rest.size());
        for (exponent, coefficient) in image.iter().enumerate() {
            let exponents = self.substitution.exponents(self.rest.size(), exponent);
            candidate.insert(exponents, BigRational::from_integer(self.field.symmetric(coefficient)));
        }
        candidate.integral()
    }
}

/// The next choice of as many of so many, in order.
fn next_choice(mut chosen: Vec<usize>, many: usize) -> Option<Vec<usize>> {
    let count = chosen.len();
    let last = (0..count).rev().find(|&place| chosen[place] + count - place < many)?;
    let first = chosen[last] + 1;
    chosen[last..].iter_mut().zip(first..).for_each(|(index, next)| *index = next);
    Some(chosen)
}
