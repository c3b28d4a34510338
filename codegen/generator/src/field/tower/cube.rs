//! Cube roots as radicals of a tower: one for each irreducible factor, so that equal products are the same.
//!
//! The real cube root is multiplicative over all real numbers, whatever their signs. So the root of a product is the product
//! of the roots of its factors; cubes come out whole, and of a quotient it is `cbrt(n*d^2)/d`.

use super::{Element, Tower, TowerError};
use crate::algebra::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};

/// Primes up to this one are taken out of a constant one by one; what is left counts as a prime, or a power of one.
const LARGEST_PRIME: u32 = 10_000;

impl Tower {
    /// The real cube root.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub(super) fn cube_root(&mut self, a: &Element) -> Result<Element, TowerError> {
        if a.numerator.is_zero() {
            return Ok(a.clone());
        }
        let radicand = self.reduce(&a.numerator.times(&a.denominator.power(2)));
        let (mut number, primitive) = radicand.primitive();
        let content = self.content(&primitive);
        let surd = primitive.divided_by(&content).unwrap_or_else(|| primitive.clone());
        let mut factors = content.factors().powers;
        number *= content.factors().constant;
        match surd.as_constant() {
            Some(constant) => number *= constant,
            None => factors.push((surd, 1)),
        }
        let mut root = self.element(&self.ring.integer(1));
        for (factor, exponent) in factors {
            let (unit, upright) = factor.primitive();
            number *= pow(unit, exponent as usize);
            root = self.times_root(&root, &upright, exponent)?;
        }
        let root = self.times_root_of_number(root, &number)?;
        self.multiply(&root, &self.quotient(&self.ring.integer(1), &a.denominator)?)
    }

    /// `root` times the cube root of a power of a factor.
    fn times_root(&mut self, root: &Element, factor: &Polynomial, exponent: u32) -> Result<Element, TowerError> {
        let mut root = self.multiply(root, &self.element(&factor.power(exponent / 3)))?;
        for _ in 0..exponent % 3 {
            let sign = self.sign_of(factor);
            let radical = self.radical_of(3, factor, sign)?;
            root = self.multiply(&root, &radical)?;
        }
        Ok(root)
    }

    /// `root` times the cube root of a number: of n/d it is that of n d^2, over d.
    fn times_root_of_number(&mut self, root: Element, number: &BigRational) -> Result<Element, TowerError> {
        let denominator = BigRational::from_integer(number.denom().clone());
        let unit = if number.is_negative() { -BigRational::one() } else { BigRational::one() };
        let mut root = self.multiply(&root, &self.element(&self.ring.constant(&(unit / denominator))))?;
        for (prime, exponent) in primes(number.numer().abs() * number.denom() * number.denom()) {
            let prime = self.ring.constant(&BigRational::from_integer(prime));
            root = self.times_root(&root, &prime, exponent)?;
        }
        Ok(root)
    }
}

/// The prime powers of a positive integer; what is left beyond [`LARGEST_PRIME`] as a power of one number.
fn primes(mut rest: BigInt) -> Vec<(BigInt, u32)> {
    let mut found = Vec::new();
    for divisor in (2..=LARGEST_PRIME).map(BigInt::from) {
        if &divisor * &divisor > rest {
            break;
        }
        let mut exponent = 0;
        while (&rest % &divisor).is_zero() {
            rest /= &divisor;
            exponent += 1;
        }
        found.extend((exponent > 0).then_some((divisor, exponent)));
    }
    if !rest.is_one() {
        let power = [3_u32, 2].into_iter().find(|power| rest.nth_root(*power).pow(*power) == rest);
        found.push(power.map_or((rest.clone(), 1), |power| (rest.nth_root(power), power)));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_products_of_prime_powers() {
        for value in [1_u64, 2, 8, 72, 9_973, 10_007, 10_007 * 10_007, 10_007 * 10_007 * 10_007, 6 * 10_007, 1 << 40] {
            let powers = primes(value.into());
            let product: BigInt = powers.iter().map(|(prime, exponent)| prime.pow(*exponent)).product();
            assert_eq!(product, value.into());
            let has_divisor = |prime: &BigInt| (2..100_u32).any(|d| *prime > d.into() && (prime % d).is_zero());
            assert!(powers.iter().all(|(prime, _)| !has_divisor(prime)), "{powers:?}");
        }
        assert_eq!(primes(BigInt::from(10_007_u64.pow(3))), [(10_007.into(), 3)]);
    }
}
