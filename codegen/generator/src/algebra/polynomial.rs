//! Polynomials over the rationals: arithmetic, greatest common divisors and factors, by any [`Implementation`].

use super::work::spend;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::any::Any;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// An implementation of the polynomials over the rationals in a fixed number of variables.
pub trait Implementation: Clone + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// The polynomial of one term, or zero, in as many variables as there are exponents.
    fn term(coefficient: &BigRational, exponents: &[u16]) -> Self;
    /// In how many variables it is.
    fn size(&self) -> usize;
    /// The terms, in any order, none of them zero.
    fn terms(&self) -> Vec<Term>;
    /// How many terms it has.
    fn count(&self) -> usize;
    /// The highest exponent of a variable.
    fn degree(&self, var: Var) -> u16;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The product with a constant.
    fn scaled(&self, factor: &BigRational) -> Self;
    /// The power.
    fn power(&self, exponent: u32) -> Self;
    /// A greatest common divisor.
    fn gcd(&self, other: &Self) -> Self;
    /// The quotient, if the division leaves no remainder.
    fn quotient(&self, other: &Self) -> Option<Self>;
    /// Irreducible factors and their exponents, whose product this is. Constants may be among them.
    fn factors(&self) -> Vec<(Self, u32)>;
}

/// An implementation behind a pointer, so that it can be chosen where a program begins.
trait Held: Any + fmt::Debug + Send + Sync {
    fn is(&self, other: &dyn Held) -> bool;
    fn of_ring(&self, coefficient: &BigRational, exponents: &[u16]) -> Arc<dyn Held>;
    fn size(&self) -> usize;
    fn terms(&self) -> Vec<Term>;
    fn count(&self) -> usize;
    fn degree(&self, var: Var) -> u16;
    fn plus(&self, other: &dyn Held) -> Arc<dyn Held>;
    fn times(&self, other: &dyn Held) -> Arc<dyn Held>;
    fn scaled(&self, factor: &BigRational) -> Arc<dyn Held>;
    fn power(&self, exponent: u32) -> Arc<dyn Held>;
    fn gcd(&self, other: &dyn Held) -> Arc<dyn Held>;
    fn quotient(&self, other: &dyn Held) -> Option<Arc<dyn Held>>;
    fn factors(&self) -> Vec<(Arc<dyn Held>, u32)>;
}

/// The other operand: both come from one [`Ring`], and so from one implementation.
fn same<T: Implementation>(other: &dyn Held) -> &T {
    let other: &dyn Any = other;
    other.downcast_ref().expect("polynomials of one ring have one implementation")
}

fn held(inner: impl Implementation) -> Arc<dyn Held> {
    Arc::new(inner)
}

impl<T: Implementation> Held for T {
    fn is(&self, other: &dyn Held) -> bool {
        self == same::<T>(other)
    }

    fn of_ring(&self, coefficient: &BigRational, exponents: &[u16]) -> Arc<dyn Held> {
        held(T::term(coefficient, exponents))
    }

    fn size(&self) -> usize {
        Implementation::size(self)
    }

    fn terms(&self) -> Vec<Term> {
        Implementation::terms(self)
    }

    fn count(&self) -> usize {
        Implementation::count(self)
    }

    fn degree(&self, var: Var) -> u16 {
        Implementation::degree(self, var)
    }

    fn plus(&self, other: &dyn Held) -> Arc<dyn Held> {
        held(Implementation::plus(self, same(other)))
    }

    fn times(&self, other: &dyn Held) -> Arc<dyn Held> {
        held(Implementation::times(self, same(other)))
    }

    fn scaled(&self, factor: &BigRational) -> Arc<dyn Held> {
        held(Implementation::scaled(self, factor))
    }

    fn power(&self, exponent: u32) -> Arc<dyn Held> {
        held(Implementation::power(self, exponent))
    }

    fn gcd(&self, other: &dyn Held) -> Arc<dyn Held> {
        held(Implementation::gcd(self, same(other)))
    }

    fn quotient(&self, other: &dyn Held) -> Option<Arc<dyn Held>> {
        Implementation::quotient(self, same(other)).map(held)
    }

    fn factors(&self) -> Vec<(Arc<dyn Held>, u32)> {
        Implementation::factors(self).into_iter().map(|(factor, exponent)| (held(factor), exponent)).collect()
    }
}

/// The algebra that a program has chosen.
#[derive(Clone, Copy, Debug)]
pub struct Algebra {
    zero: fn(usize) -> Arc<dyn Held>,
}

impl Algebra {
    /// The algebra of an implementation.
    #[must_use]
    pub const fn by<T: Implementation>() -> Self {
        Self { zero: |size| held(T::term(&BigRational::zero(), &vec![0; size])) }
    }

    /// The ring in some variables.
    #[must_use]
    pub fn ring(&self, size: usize) -> Ring {
        Ring { zero: (self.zero)(size) }
    }
}

/// A variable of a [`Ring`], by position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Var(pub usize);

/// The polynomials in a fixed number of variables.
#[derive(Clone, Debug)]
pub struct Ring {
    zero: Arc<dyn Held>,
}

/// One term: an exact coefficient and one exponent a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The coefficient, never zero.
    pub coefficient: BigRational,
    /// The exponents, one a variable of the ring.
    pub exponents: Vec<u16>,
}

/// A polynomial with rational coefficients.
#[derive(Clone, Debug)]
pub struct Polynomial {
    inner: Arc<dyn Held>,
}

impl PartialEq for Polynomial {
    fn eq(&self, other: &Self) -> bool {
        self.inner.is(&*other.inner)
    }
}

/// A polynomial as a constant times powers of irreducible polynomials.
///
/// The factors are [`primitive`](Polynomial::primitive) and stand in an order of their own.
#[derive(Clone, Debug)]
pub struct Factors {
    /// The constant.
    pub constant: BigRational,
    /// The irreducible factors and their exponents.
    pub powers: Vec<(Polynomial, u32)>,
}

impl Ring {
    /// How many variables there are.
    #[must_use]
    pub fn size(&self) -> usize {
        self.zero.size()
    }

    /// The constant polynomial.
    #[must_use]
    pub fn constant(&self, value: &BigRational) -> Polynomial {
        self.term(value, &vec![0; self.size()])
    }

    /// The constant polynomial of an integer.
    #[must_use]
    pub fn integer(&self, value: i64) -> Polynomial {
        self.constant(&BigRational::from_integer(value.into()))
    }

    /// The polynomial that is one variable.
    #[must_use]
    pub fn variable(&self, var: Var) -> Polynomial {
        let mut exponents = vec![0; self.size()];
        exponents[var.0] = 1;
        self.term(&BigRational::one(), &exponents)
    }

    /// The polynomial of one term.
    #[must_use]
    pub fn term(&self, coefficient: &BigRational, exponents: &[u16]) -> Polynomial {
        Polynomial { inner: self.zero.of_ring(coefficient, exponents) }
    }
}

impl Polynomial {
    fn wrap(inner: Arc<dyn Held>) -> Self {
        Self { inner }
    }

    /// The terms, highest first by exponents.
    #[must_use]
    pub fn terms(&self) -> Vec<Term> {
        let mut terms = self.inner.terms();
        terms.sort_by(|a, b| b.exponents.cmp(&a.exponents));
        terms
    }

    /// The ring it belongs to.
    #[must_use]
    pub fn ring(&self) -> Ring {
        Ring { zero: self.inner.of_ring(&BigRational::zero(), &vec![0; self.inner.size()]) }
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.inner.count() == 0
    }

    /// Its value, if it has no variable.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigRational> {
        if self.is_zero() {
            return Some(BigRational::zero());
        }
        let terms = if self.len() == 1 { self.terms() } else { Vec::new() };
        terms.into_iter().find(|term| term.exponents.iter().all(|&exponent| exponent == 0)).map(|term| term.coefficient)
    }

    /// How many terms it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inner.count()
    }

    /// Whether it has no term, which is the zero polynomial.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self::wrap(self.inner.plus(&*other.inner))
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        spend(self.len().saturating_mul(other.len()));
        Self::wrap(self.inner.times(&*other.inner))
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Self {
        self.scaled(&-BigRational::one())
    }

    /// The product with a constant.
    #[must_use]
    pub fn scaled(&self, factor: &BigRational) -> Self {
        Self::wrap(self.inner.scaled(factor))
    }

    /// The power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        spend(size_of_power(self.len(), exponent));
        Self::wrap(self.inner.power(exponent))
    }

    /// The greatest common divisor.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        spend(self.hardness().saturating_add(other.hardness()));
        Self::wrap(self.inner.gcd(&*other.inner))
    }

    /// The quotient, if the division leaves no remainder.
    #[must_use]
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        spend(self.len().saturating_mul(other.len()));
        self.inner.quotient(&*other.inner).map(Self::wrap)
    }

    /// The highest exponent of a variable.
    #[must_use]
    pub fn degree(&self, var: Var) -> u16 {
        self.inner.degree(var)
    }

    /// Whether the variable occurs.
    #[must_use]
    pub fn contains(&self, var: Var) -> bool {
        self.degree(var) > 0
    }

    /// The variables that occur.
    #[must_use]
    pub fn variables(&self) -> Vec<Var> {
        (0..self.inner.size()).map(Var).filter(|&v| self.contains(v)).collect()
    }

    /// The coefficients of the powers of one variable, lowest power first, zeros included.
    #[must_use]
    pub fn coefficients(&self, var: Var) -> Vec<Self> {
        let ring = self.ring();
        let mut list = vec![ring.integer(0); usize::from(self.degree(var)) + 1];
        for term in self.terms() {
            let mut exponents = term.exponents;
            let power = usize::from(std::mem::take(&mut exponents[var.0]));
            list[power] = list[power].plus(&ring.term(&term.coefficient, &exponents));
        }
        list
    }

    /// The polynomial with another one in place of a variable.
    #[must_use]
    pub fn substituted(&self, var: Var, value: &Self) -> Self {
        let mut result = self.ring().integer(0);
        for coefficient in self.coefficients(var).iter().rev() {
            result = result.times(value).plus(coefficient);
        }
        result
    }

    /// Splits off the rational content: a constant and a polynomial with coprime integers and an upright sign.
    ///
    /// Upright is the sign with more positive than negative terms and, if they balance, with a positive last term, so
    /// that differences read as `x1 - x0`.
    #[must_use]
    pub fn primitive(&self) -> (BigRational, Self) {
        let terms = self.terms();
        let Some(last) = terms.last() else {
            return (BigRational::zero(), self.clone());
        };
        let mut content = terms.iter().fold(BigRational::zero(), |gcd, term| rational_gcd(&gcd, &term.coefficient));
        let negative = terms.iter().filter(|term| term.coefficient.is_negative()).count();
        let balance = terms.len().cmp(&(2 * negative));
        if balance == Ordering::Less || balance == Ordering::Equal && last.coefficient.is_negative() {
            content = -content;
        }
        let primitive = self.scaled(&content.recip());
        (content, primitive)
    }

    /// The irreducible factors over the rationals.
    #[must_use]
    pub fn factors(&self) -> Factors {
        if let Some(constant) = self.as_constant() {
            return Factors { constant, powers: Vec::new() };
        }
        // what an implementation remembers is work all the same: what a formula may take must not depend on those before it
        spend(self.hardness());
        let mut constant = BigRational::one();
        let mut powers = Vec::new();
        for (factor, exponent) in self.inner.factors() {
            let (content, primitive) = Self::wrap(factor).primitive();
            constant *= num_traits::pow(content, exponent as usize);
            if primitive.as_constant().is_none() {
                powers.push((primitive, exponent));
            }
        }
        powers.sort_by(|a, b| a.0.compare(&b.0));
        Factors { constant, powers }
    }

    /// What a factorisation or a greatest common divisor may take: the square of its terms, for each degree of each of its
    /// variables.
    fn hardness(&self) -> usize {
        let degrees: usize = self.variables().into_iter().map(|var| usize::from(self.degree(var))).sum();
        self.len().saturating_mul(self.len()).saturating_mul(degrees.max(1))
    }

    /// An order that depends on the mathematics alone: fewer terms first, then by terms.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        self.len().cmp(&other.len()).then_with(|| compare_terms(&self.terms(), &other.terms()))
    }
}

/// At most how many terms a power of so many has, with room for the steps to it.
fn size_of_power(terms: usize, exponent: u32) -> usize {
    let more = terms.saturating_sub(1);
    (1..=exponent as usize).fold(1_usize, |size, step| size.saturating_mul(more + step) / step).saturating_mul(2)
}

fn compare_terms(left: &[Term], right: &[Term]) -> Ordering {
    for (a, b) in left.iter().zip(right) {
        let order = b.exponents.cmp(&a.exponents).then_with(|| a.coefficient.cmp(&b.coefficient));
        if order != Ordering::Equal {
            return order;
        }
    }
    Ordering::Equal
}

/// The largest rational of which both are integer multiples.
pub(super) fn rational_gcd(left: &BigRational, right: &BigRational) -> BigRational {
    if left.is_zero() {
        return right.abs();
    }
    let numerator = num_integer_gcd(left.numer() * right.denom(), right.numer() * left.denom());
    BigRational::new(numerator, left.denom() * right.denom())
}

fn num_integer_gcd(mut a: BigInt, mut b: BigInt) -> BigInt {
    while !b.is_zero() {
        (a, b) = (b.clone(), a % b);
    }
    a.abs()
}
