//! Square roots as radicals of a tower: squares taken out of them, and magnitudes.

use super::{Element, Radical, Tower, TowerError};
use crate::algebra::Polynomial;
use crate::field::Sign;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

impl Tower {
    /// The nonnegative square root.
    ///
    /// # Errors
    /// See [`TowerError`].
    pub fn sqrt(&mut self, a: &Element) -> Result<Element, TowerError> {
        if a.numerator.is_zero() {
            return Ok(a.clone());
        }
        let radicand = self.reduce(&a.numerator.times(&a.denominator));
        let sign = self.facts.sign(&a.denominator);
        let (outside, denominator, inside) = self.split_squares(&radicand)?;
        let root = self.radical(&inside)?;
        let magnitude = if sign.is(Sign::NONNEGATIVE) {
            a.denominator.clone()
        } else if sign.is(Sign::NONPOSITIVE) {
            a.denominator.negated()
        } else {
            return self.sqrt_over_open_sign(a);
        };
        let root = self.multiply(&root, &self.element(&outside))?;
        self.multiply(&root, &self.quotient(&self.ring.integer(1), &magnitude.scaled(&denominator))?)
    }

    /// `sqrt(n/d)` where the sign of `d` is open: `sqrt(n*d)/|d|`, and `|d|` is `sqrt(d^2)`.
    fn sqrt_over_open_sign(&mut self, a: &Element) -> Result<Element, TowerError> {
        let magnitude = self.radical(&a.denominator.power(2))?;
        let inside = self.reduce(&a.numerator.times(&a.denominator));
        let root = self.sqrt(&self.element(&inside))?;
        self.multiply(&root, &self.reciprocal(&magnitude)?)
    }

    /// Writes a radicand as `(outside/denominator)^2 * inside`.
    fn split_squares(&self, radicand: &Polynomial) -> Result<(Polynomial, BigRational, Polynomial), TowerError> {
        let content = self.content(radicand);
        let rational = radicand.primitive().0.abs();
        let (square, rest) = split_square_integer(&(rational.numer() * rational.denom()));
        let mut outside = self.ring.constant(&BigRational::from_integer(square));
        let denominator = BigRational::from_integer(rational.denom().clone());
        let mut inside = radicand.scaled(&(BigRational::from_integer(rest) / &rational));
        let mut factors = content.factors().powers;
        factors.extend(self.squared_cube_roots(radicand));
        for (factor, exponent) in &factors {
            let sign = self.sign_of(factor);
            if *exponent < 2 || !sign.is_definite() {
                continue;
            }
            let magnitude = if sign.is(Sign::NONNEGATIVE) { factor.clone() } else { factor.negated() };
            outside = outside.times(&magnitude.power(exponent / 2));
            let squares = factor.power(exponent / 2 * 2);
            inside = inside.divided_by(&squares).unwrap_or(inside);
        }
        if inside.as_constant().is_some_and(|c| c.is_negative()) {
            return Err(TowerError::NegativeRadicand);
        }
        Ok((outside, denominator, inside))
    }

    /// The cube roots whose squares are factors of a polynomial.
    fn squared_cube_roots(&self, polynomial: &Polynomial) -> impl Iterator<Item = (Polynomial, u32)> {
        let terms = polynomial.terms();
        let cubes = self.radicals.iter().filter(|radical| radical.degree == 3);
        cubes
            .filter(move |radical| terms.iter().all(|term| term.exponents[radical.var.0] == 2))
            .map(|radical| (self.ring.variable(radical.var), 2))
    }

    /// The root of a polynomial, through radicals that the tower has, or as a new one.
    fn radical(&mut self, inside: &Polynomial) -> Result<Element, TowerError> {
        if inside.as_constant().is_some_and(|c| c.is_one()) {
            return Ok(self.element(&self.ring.integer(1)));
        }
        let known = self.square_radicals().any(|radical| radical.radicand == *inside);
        if let (false, Some(known)) = (known, self.through_known_radicals(inside)) {
            return Ok(known);
        }
        let sign = if self.facts.sign(inside).is(Sign::POSITIVE) { Sign::POSITIVE } else { Sign::NONNEGATIVE };
        let root = self.radical_of(2, inside, sign)?;
        if !known {
            // an expression that takes this root is real nowhere else
            self.facts.learn(inside, Sign::NONNEGATIVE);
        }
        Ok(root)
    }

    fn square_radicals(&self) -> impl Iterator<Item = &Radical> {
        self.radicals.iter().filter(|radical| radical.degree == 2)
    }

    /// The root as a quotient of known radicals times a polynomial: `sqrt(6)` is `sqrt(2)*sqrt(3)`, and so is `sqrt(2)`
    /// if `sqrt(6)` and `sqrt(3)` are known.
    fn through_known_radicals(&self, inside: &Polynomial) -> Option<Element> {
        let count = self.square_radicals().count().min(6);
        (1_usize..1 << count).find_map(|all| {
            // the subsets of `all`, the whole first
            let mut below = std::iter::successors(Some(all), |below| below.checked_sub(1).map(|below| below & all));
            below.find_map(|below| self.through_quotient(inside, all & !below, below))
        })
    }

    /// The root as a polynomial times the radicals `above`, over those `below`.
    fn through_quotient(&self, inside: &Polynomial, above: usize, below: usize) -> Option<Element> {
        let chosen =
            |set: usize| self.square_radicals().enumerate().filter(move |(i, _)| set >> i & 1 == 1).map(|(_, r)| r);
        let one = self.ring.integer(1);
        let divisor = chosen(below).fold(one.clone(), |p, r| p.times(&r.radicand));
        let radicands = chosen(above).fold(one.clone(), |p, r| p.times(&r.radicand));
        let square = self.reduce(&inside.times(&divisor)).divided_by(&radicands)?;
        let (outside, denominator) = self.root_of_square(&square)?;
        let roots = chosen(above | below).fold(outside, |p, r| p.times(&self.ring.variable(r.var)));
        self.quotient(&roots, &divisor.scaled(&denominator)).ok()
    }

    /// The root of a square, as a polynomial and a number that divides it.
    fn root_of_square(&self, square: &Polynomial) -> Option<(Polynomial, BigRational)> {
        let (outside, denominator, rest) = self.split_squares(square).ok()?;
        rest.as_constant()?.is_one().then_some((outside, denominator))
    }

    /// The magnitude: where the sign is open, the root of the square.
    pub(super) fn abs(&mut self, a: &Element) -> Result<Element, TowerError> {
        let sign = self.sign(a);
        if sign.is(Sign::NONNEGATIVE) {
            Ok(a.clone())
        } else if sign.is(Sign::NONPOSITIVE) {
            Ok(self.negate(a))
        } else {
            let above = self.sqrt(&self.element(&self.reduce(&a.numerator.power(2))))?;
            let below = self.sqrt(&self.element(&a.denominator.power(2)))?;
            self.multiply(&above, &self.reciprocal(&below)?)
        }
    }

    /// What a radical is the magnitude of, if it is the root of a square.
    #[must_use]
    pub fn magnitude_of(&self, radical: &Radical) -> Option<Polynomial> {
        if radical.degree != 2 {
            return None;
        }
        let factors = radical.radicand.factors();
        let even = factors.powers.iter().all(|(_, power)| power % 2 == 0);
        let root = factors.powers.iter().fold(self.ring.integer(1), |p, (f, power)| p.times(&f.power(power / 2)));
        let nested = self.top_radical(&radical.radicand).is_some_and(|inside| inside.degree == 2);
        (even && factors.constant.is_one() && !nested).then_some(root)
    }
}

/// Writes a positive integer as `square^2 * rest`, by trial division (a large cofactor stays whole).
fn split_square_integer(value: &BigInt) -> (BigInt, BigInt) {
    let mut rest = value.clone();
    let mut square = BigInt::one();
    let root = value.sqrt();
    if &root * &root == *value {
        return (root, BigInt::one());
    }
    for divisor in 2_u32..=10_000 {
        let divisor = BigInt::from(divisor);
        let divisor_squared = &divisor * &divisor;
        if divisor_squared > rest {
            break;
        }
        while (&rest % &divisor_squared).is_zero() {
            rest /= &divisor_squared;
            square *= &divisor;
        }
    }
    let root = rest.sqrt();
    if root.to_u8() != Some(1) && &root * &root == rest {
        return (square * root, BigInt::one());
    }
    (square, rest)
}
