//! Polynomials with exact rational coefficients in any number of atoms.

use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// What polynomials are made of: an input, or a value that is none in the inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Atom(pub usize);

/// A product of powers of atoms, in the order of the atoms; no exponent is zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(Vec<(Atom, u32)>);

impl Monomial {
    /// Atoms and exponents.
    pub fn powers(&self) -> &[(Atom, u32)] {
        &self.0
    }

    fn exponent(&self, atom: Atom) -> u32 {
        self.0.iter().find(|(known, _)| *known == atom).map_or(0, |(_, exponent)| *exponent)
    }

    fn times(&self, other: &Self) -> Self {
        let mut powers = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut left, mut right) = (self.0.as_slice(), other.0.as_slice());
        while let ([(a, m), rest_of_left @ ..], [(b, n), rest_of_right @ ..]) = (left, right) {
            let (power, next) = match a.cmp(b) {
                Ordering::Less => ((*a, *m), (rest_of_left, right)),
                Ordering::Greater => ((*b, *n), (left, rest_of_right)),
                Ordering::Equal => ((*a, m + n), (rest_of_left, rest_of_right)),
            };
            powers.push(power);
            (left, right) = next;
        }
        powers.extend([left, right].concat());
        Self(powers)
    }

    /// The quotient, if it is a monomial.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        if divisor.0.iter().any(|(atom, exponent)| self.exponent(*atom) < *exponent) {
            return None;
        }
        let left = self.0.iter().map(|(atom, exponent)| (*atom, exponent - divisor.exponent(*atom)));
        Some(Self(left.filter(|(_, exponent)| *exponent > 0).collect()))
    }

    /// The lexical order, which products keep.
    fn lexical(&self, other: &Self) -> Ordering {
        let pairs = self.0.iter().zip(&other.0);
        let orders = pairs.map(|((a, m), (b, n))| b.cmp(a).then(m.cmp(n)));
        orders.into_iter().find(|order| order.is_ne()).unwrap_or_else(|| self.0.len().cmp(&other.0.len()))
    }

    fn common(&self, other: &Self) -> Self {
        let shared = self.0.iter().map(|(atom, exponent)| (*atom, *exponent.min(&other.exponent(*atom))));
        Self(shared.filter(|(_, exponent)| *exponent > 0).collect())
    }

    /// The part in the atoms that are wanted.
    pub fn only(&self, wanted: impl Fn(Atom) -> bool) -> Self {
        Self(self.0.iter().copied().filter(|(atom, _)| wanted(*atom)).collect())
    }
}

/// A polynomial: its terms, none of them zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Polynomial(BTreeMap<Monomial, BigRational>);

impl Polynomial {
    /// A number.
    pub fn constant(value: BigRational) -> Self {
        Self::default().with(Monomial::default(), value)
    }

    /// An atom.
    pub fn atom(atom: Atom) -> Self {
        Self::default().with(Monomial(vec![(atom, 1)]), BigRational::one())
    }

    /// A single term.
    pub fn term(monomial: Monomial, coefficient: BigRational) -> Self {
        Self::default().with(monomial, coefficient)
    }

    fn with(mut self, monomial: Monomial, coefficient: BigRational) -> Self {
        self.add(monomial, coefficient);
        self
    }

    fn add(&mut self, monomial: Monomial, coefficient: BigRational) {
        match self.0.entry(monomial) {
            Entry::Vacant(place) if !coefficient.is_zero() => _ = place.insert(coefficient),
            Entry::Vacant(_) => {}
            Entry::Occupied(mut place) => {
                *place.get_mut() += coefficient;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    /// Its terms.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &BigRational)> {
        self.0.iter()
    }

    /// How many terms it has.
    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The number that it is, if it is one.
    pub fn as_constant(&self) -> Option<BigRational> {
        match self.0.first_key_value() {
            None => Some(BigRational::zero()),
            Some((monomial, value)) if self.size() == 1 && monomial.0.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    /// The one atom that it is, if it is one.
    pub fn as_atom(&self) -> Option<Atom> {
        match self.0.first_key_value() {
            Some((Monomial(powers), value)) if self.size() == 1 && value.is_one() => match powers[..] {
                [(atom, 1)] => Some(atom),
                _ => None,
            },
            _ => None,
        }
    }

    /// The atoms in it.
    pub fn atoms(&self) -> BTreeSet<Atom> {
        self.0.keys().flat_map(|monomial| monomial.0.iter().map(|(atom, _)| *atom)).collect()
    }

    /// The highest power of an atom.
    pub fn degree(&self, atom: Atom) -> u32 {
        self.0.keys().map(|monomial| monomial.exponent(atom)).max().unwrap_or(0)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        other.terms().for_each(|(monomial, coefficient)| sum.add(monomial.clone(), coefficient.clone()));
        sum
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Self(self.0.iter().map(|(monomial, coefficient)| (monomial.clone(), -coefficient)).collect())
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (a, x) in self.terms() {
            for (b, y) in other.terms() {
                product.add(a.times(b), x * y);
            }
        }
        product
    }

    /// The product with a number.
    pub fn scaled(&self, factor: &BigRational) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        Self(self.0.iter().map(|(monomial, coefficient)| (monomial.clone(), coefficient * factor)).collect())
    }

    /// A power.
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::constant(BigRational::one()), |power, _| power.times(self))
    }

    /// The coefficients of the powers of an atom, lowest first.
    pub fn coefficients(&self, atom: Atom) -> Vec<Self> {
        let mut coefficients = vec![Self::default(); self.degree(atom) as usize + 1];
        for (monomial, coefficient) in self.terms() {
            let rest = monomial.only(|other| other != atom);
            coefficients[monomial.exponent(atom) as usize].add(rest, coefficient.clone());
        }
        coefficients
    }

    /// The largest monomial that divides every term.
    pub fn content(&self) -> Monomial {
        let mut monomials = self.0.keys();
        let first = monomials.next().cloned().unwrap_or_default();
        monomials.fold(first, |common, monomial| common.common(monomial))
    }

    /// The quotient by a monomial that divides every term.
    pub fn over(&self, divisor: &Monomial) -> Self {
        Self(self.0.iter().filter_map(|(monomial, value)| Some((monomial.over(divisor)?, value.clone()))).collect())
    }

    /// The quotient, if the division leaves no remainder.
    pub fn quotient(&self, divisor: &Self) -> Option<Self> {
        let (lead, value) = divisor.leading()?;
        let (mut quotient, mut rest) = (Self::default(), self.clone());
        while let Some((monomial, coefficient)) = rest.leading() {
            let term = Self::term(monomial.over(lead)?, coefficient / value);
            rest = rest.minus(&divisor.times(&term));
            quotient = quotient.plus(&term);
        }
        Some(quotient)
    }

    fn leading(&self) -> Option<(&Monomial, &BigRational)> {
        self.terms().max_by(|(a, _), (b, _)| a.lexical(b))
    }

    /// A number and the polynomial that it multiplies, whose first coefficient is 1.
    pub fn monic(&self) -> (BigRational, Self) {
        match self.0.first_key_value() {
            Some((_, first)) => (first.clone(), self.scaled(&first.recip())),
            None => (BigRational::one(), Self::default()),
        }
    }

    /// The number that this is times another polynomial.
    pub fn ratio(&self, other: &Self) -> Option<BigRational> {
        let (first, _) = self.0.first_key_value()?;
        let ratio = self.0.get(first)? / other.0.get(first)?;
        (*self == other.scaled(&ratio)).then_some(ratio)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: i64) -> Polynomial {
        Polynomial::constant(BigRational::from_integer(value.into()))
    }

    #[test]
    fn terms_that_cancel_are_gone() {
        let (x, y) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let product = x.plus(&y).times(&x.minus(&y));
        assert_eq!(product, x.times(&x).minus(&y.times(&y)));
        assert!(product.minus(&product).is_zero());
        assert_eq!(number(2).as_constant(), Some(BigRational::from_integer(2.into())));
        assert_eq!((x.as_atom(), number(1).as_atom()), (Some(Atom(0)), None));
    }

    #[test]
    fn quotients_are_exact_or_none() {
        let (x, y) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let factors = [x.times(&y).plus(&number(2)), x.minus(&y.power(3)), y.plus(&number(1)), number(7)];
        let product = factors.iter().fold(number(1), |product, factor| product.times(factor));
        for factor in &factors {
            let quotient = product.quotient(factor).unwrap();
            assert_eq!(quotient.times(factor), product);
        }
        assert_eq!(product.quotient(&x), None);
        assert_eq!(factors[1].quotient(&product), None);
        assert_eq!(product.quotient(&Polynomial::default()), None);
    }

    #[test]
    fn contents_and_coefficients_give_the_polynomial_back() {
        let (x, y) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let p = x.times(&x).times(&y).plus(&x.times(&y).times(&number(3)));
        let content = p.content();
        assert_eq!(p.over(&content), x.plus(&number(3)));
        assert_eq!(p.coefficients(Atom(0)), [Polynomial::default(), y.times(&number(3)), y.clone()]);
        assert_eq!(
            p.scaled(&BigRational::new(2.into(), 3.into())).ratio(&p),
            Some(BigRational::new(2.into(), 3.into()))
        );
        assert_eq!(p.ratio(&x), None);
    }
}
