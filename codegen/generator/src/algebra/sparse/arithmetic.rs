//! Polynomials as maps from exponents to coefficients, and their arithmetic.

use crate::algebra::Var;
use crate::algebra::polynomial::rational_gcd;
use crate::algebra::work::spend;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// What a product of terms costs, in additions of terms.
const TERM: usize = 8;

/// A polynomial with rational coefficients: its terms by their exponents, none of them zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Sparse {
    size: usize,
    pub(super) terms: BTreeMap<Vec<u16>, BigRational>,
}

impl Sparse {
    /// The polynomial of one term, or zero.
    pub fn term(coefficient: &BigRational, exponents: &[u16]) -> Self {
        let mut made = Self::zero(exponents.len());
        made.insert(exponents.to_vec(), coefficient.clone());
        made
    }

    /// In how many variables it is.
    pub fn size(&self) -> usize {
        self.size
    }

    /// How many terms it has.
    pub fn count(&self) -> usize {
        self.terms.len()
    }

    /// The highest exponent of a variable.
    pub fn degree(&self, var: Var) -> u16 {
        self.terms.keys().map(|exponents| exponents[var.0]).max().unwrap_or(0)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        spend(self.count() + other.count());
        let mut sum = self.clone();
        other.terms.iter().for_each(|(exponents, coefficient)| sum.insert(exponents.clone(), coefficient.clone()));
        sum
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        spend(TERM * self.count() * other.count());
        let mut product = Self::zero(self.size);
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                product.insert(left.iter().zip(right).map(|(x, y)| x + y).collect(), a * b);
            }
        }
        product
    }

    /// The product with a constant.
    pub fn scaled(&self, factor: &BigRational) -> Self {
        if factor.is_zero() {
            return Self::zero(self.size);
        }
        let terms = self.terms.iter().map(|(exponents, coefficient)| (exponents.clone(), coefficient * factor));
        Self { size: self.size, terms: terms.collect() }
    }

    /// The power.
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(self.constant(&BigRational::one()), |power, _| power.times(self))
    }

    /// The quotient, if the division leaves no remainder: by the leading terms, which are those of the largest exponents in
    /// lexicographic order.
    pub fn quotient(&self, other: &Self) -> Option<Self> {
        let (leading, divisor) = other.leading()?;
        let too_high = |var| other.degree(Var(var)) > self.degree(Var(var));
        if !self.is_zero() && (0..self.size).any(too_high) {
            return None;
        }
        let (mut rest, mut quotient) = (self.clone(), Self::zero(self.size));
        while let Some((exponents, coefficient)) = rest.leading() {
            let exponents: Option<Vec<u16>> = exponents.iter().zip(leading).map(|(a, b)| a.checked_sub(*b)).collect();
            let term = Self::term(&(coefficient / divisor), &exponents?);
            rest = rest.minus(&other.times(&term));
            quotient = quotient.plus(&term);
        }
        Some(quotient)
    }

    /// The polynomial without terms.
    pub fn zero(size: usize) -> Self {
        Self { size, terms: BTreeMap::new() }
    }

    /// A constant of the same ring.
    pub fn constant(&self, value: &BigRational) -> Self {
        Self::term(value, &vec![0; self.size])
    }

    /// An integer constant of the same ring.
    pub fn integer(&self, value: i64) -> Self {
        self.constant(&BigRational::from_integer(value.into()))
    }

    /// A power of a variable of the same ring.
    pub fn variable(&self, var: Var, power: u16) -> Self {
        let mut exponents = vec![0; self.size];
        exponents[var.0] = power;
        Self::term(&BigRational::one(), &exponents)
    }

    /// Adds a term.
    pub fn insert(&mut self, exponents: Vec<u16>, coefficient: BigRational) {
        let sum = self.terms.remove(&exponents).unwrap_or_else(BigRational::zero) + coefficient;
        if !sum.is_zero() {
            self.terms.insert(exponents, sum);
        }
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&-BigRational::one()))
    }

    /// Whether it has no term.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.variables().is_empty()
    }

    /// The variables that occur.
    pub fn variables(&self) -> Vec<Var> {
        (0..self.size).map(Var).filter(|&var| self.degree(var) > 0).collect()
    }

    /// The term of the largest exponents in lexicographic order.
    pub fn leading(&self) -> Option<(&Vec<u16>, &BigRational)> {
        self.terms.last_key_value()
    }

    /// The coefficients of the powers of a variable, lowest power first; of zero there are none.
    pub fn coefficients(&self, var: Var) -> Vec<Self> {
        let count = if self.is_zero() { 0 } else { usize::from(self.degree(var)) + 1 };
        let mut list = vec![Self::zero(self.size); count];
        for (exponents, coefficient) in &self.terms {
            let mut exponents = exponents.clone();
            let power = std::mem::take(&mut exponents[var.0]);
            list[usize::from(power)].insert(exponents, coefficient.clone());
        }
        list
    }

    /// The polynomial of these coefficients, lowest power first.
    pub fn of_coefficients(size: usize, coefficients: &[Self], var: Var) -> Self {
        let mut sum = Self::zero(size);
        for (coefficient, power) in coefficients.iter().zip(0..) {
            for (exponents, value) in &coefficient.terms {
                let mut exponents = exponents.clone();
                exponents[var.0] = power;
                sum.insert(exponents, value.clone());
            }
        }
        sum
    }

    /// The multiple whose coefficients are coprime integers, the leading one positive.
    pub fn integral(&self) -> Self {
        let Some((_, leading)) = self.leading() else { return self.clone() };
        let content = self.terms.values().fold(BigRational::zero(), |gcd, value| rational_gcd(&gcd, value));
        self.scaled(&(leading.signum() / content))
    }

    /// The value with a number in place of a variable.
    pub fn at(&self, var: Var, value: &BigInt) -> Self {
        let mut sum = Self::zero(self.size);
        for (exponents, coefficient) in &self.terms {
            let mut exponents = exponents.clone();
            let power = usize::from(std::mem::take(&mut exponents[var.0]));
            sum.insert(exponents, coefficient * num_traits::pow(value.clone(), power));
        }
        sum
    }

    /// The polynomial with the variable plus a number in place of it.
    pub fn shifted(&self, var: Var, by: i64) -> Self {
        let sum = self.variable(var, 1).plus(&self.integer(by));
        let coefficients = self.coefficients(var).into_iter().rev();
        coefficients.fold(Self::zero(self.size), |value, coefficient| value.times(&sum).plus(&coefficient))
    }
}
