//! Polynomials over the rationals: arithmetic, greatest common divisors and factors, by Symbolica.

use super::work::spend;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::sync::Arc;
use symbolica::atom::Symbol;
use symbolica::domains::integer::Integer;
use symbolica::domains::rational::{Q, Rational, RationalField};
use symbolica::poly::PolyVariable;
use symbolica::poly::factor::Factorize;
use symbolica::poly::polynomial::MultivariatePolynomial;

type Inner = MultivariatePolynomial<RationalField, u16>;

thread_local! {
    /// The factors of polynomials that were asked for, since signs ask for the same ones again and again.
    static FACTORED: RefCell<HashMap<Inner, Factors>> = RefCell::default();
}

/// A variable of a [`Ring`], by position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Var(pub usize);

/// The polynomials in a fixed number of variables.
#[derive(Clone)]
pub struct Ring {
    variables: Arc<Vec<PolyVariable>>,
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
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial {
    inner: Inner,
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
    /// The ring in `count` variables.
    ///
    /// # Panics
    /// Where Symbolica refuses a plain name, which it does not.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let variables = (0..count).map(|i| PolyVariable::from(plain_symbol(i))).collect();
        Self { variables: Arc::new(variables) }
    }

    /// How many variables there are.
    #[must_use]
    pub fn size(&self) -> usize {
        self.variables.len()
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
        let mut inner = Inner::new(&Q, None, self.variables.clone());
        if !coefficient.is_zero() {
            inner.append_monomial(to_symbolica(coefficient), exponents);
        }
        Polynomial { inner }
    }
}

fn plain_symbol(index: usize) -> Symbol {
    symbolica::symbol!(format!("v{index}"))
}

fn to_symbolica(value: &BigRational) -> Rational {
    Rational::from((integer_to_symbolica(value.numer()), integer_to_symbolica(value.denom())))
}

fn integer_to_symbolica(value: &BigInt) -> Integer {
    match value.to_i64() {
        Some(small) => Integer::from(small),
        None => Integer::from(value.to_string().parse::<rug::Integer>().unwrap_or_default()),
    }
}

fn from_symbolica(value: &Rational) -> BigRational {
    BigRational::new(integer_from_symbolica(&value.numerator()), integer_from_symbolica(&value.denominator()))
}

fn integer_from_symbolica(value: &Integer) -> BigInt {
    value.to_string().parse().unwrap_or_default()
}

impl Polynomial {
    fn wrap(inner: Inner) -> Self {
        Self { inner }
    }

    /// The terms, highest first by exponents.
    #[must_use]
    pub fn terms(&self) -> Vec<Term> {
        let mut terms: Vec<Term> = (&self.inner)
            .into_iter()
            .map(|t| Term { coefficient: from_symbolica(t.coefficient), exponents: t.exponents.to_vec() })
            .collect();
        terms.sort_by(|a, b| b.exponents.cmp(&a.exponents));
        terms
    }

    /// The ring it belongs to.
    #[must_use]
    pub fn ring(&self) -> Ring {
        Ring { variables: self.inner.variables.clone() }
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.inner.is_zero()
    }

    /// Its value, if it has no variable.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigRational> {
        if self.is_zero() {
            return Some(BigRational::zero());
        }
        self.inner.is_constant().then(|| from_symbolica(&self.inner.lcoeff()))
    }

    /// How many terms it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inner.nterms()
    }

    /// Whether it has no term, which is the zero polynomial.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self::wrap(&self.inner + &other.inner)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self::wrap(&self.inner - &other.inner)
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        spend(self.len().saturating_mul(other.len()));
        Self::wrap(&self.inner * &other.inner)
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self::wrap(-self.inner.clone())
    }

    /// The product with a constant.
    #[must_use]
    pub fn scaled(&self, factor: &BigRational) -> Self {
        Self::wrap(self.inner.clone().mul_coeff(to_symbolica(factor)))
    }

    /// The power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        spend(size_of_power(self.len(), exponent));
        Self::wrap(self.inner.pow(exponent as usize))
    }

    /// The greatest common divisor.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        spend(self.hardness().saturating_add(other.hardness()));
        Self::wrap(self.inner.gcd(&other.inner))
    }

    /// The quotient, if the division leaves no remainder.
    #[must_use]
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        spend(self.len().saturating_mul(other.len()));
        self.inner.try_div(&other.inner).map(Self::wrap)
    }

    /// The highest exponent of a variable.
    #[must_use]
    pub fn degree(&self, var: Var) -> u16 {
        self.inner.degree(var.0)
    }

    /// Whether the variable occurs.
    #[must_use]
    pub fn contains(&self, var: Var) -> bool {
        self.degree(var) > 0
    }

    /// The variables that occur.
    #[must_use]
    pub fn variables(&self) -> Vec<Var> {
        (0..self.inner.variables.len()).map(Var).filter(|&v| self.contains(v)).collect()
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
        // what is found again is work all the same: what a formula may take must not depend on those before it
        spend(self.hardness());
        if let Some(factors) = FACTORED.with_borrow(|factored| factored.get(&self.inner).cloned()) {
            return factors;
        }
        let factors = self.factorised();
        FACTORED.with_borrow_mut(|factored| factored.insert(self.inner.clone(), factors.clone()));
        factors
    }

    fn factorised(&self) -> Factors {
        let mut constant = BigRational::one();
        let mut powers = Vec::new();
        for (factor, exponent) in self.inner.factor() {
            let (content, primitive) = Self::wrap(factor).primitive();
            constant *= num_traits::pow(content, exponent);
            if primitive.as_constant().is_none() {
                powers.push((primitive, exponent as u32));
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

fn rational_gcd(left: &BigRational, right: &BigRational) -> BigRational {
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
