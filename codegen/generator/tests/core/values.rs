//! Random polynomials and points, and exact values of the one at the other.

use closedform_generator::algebra::{Algebra, Polynomial, Ring, Sparse, Term, Var};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, pow};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use rug::Float;
use rug::integer::Order;

/// The small ring.
pub const ALGEBRA: Algebra = Algebra::by::<Sparse>();

/// The precision of values that have no rational ones.
pub const BITS: u32 = 400;

/// So many cases, the same ones in every run.
pub fn cases(count: u32) -> Config {
    Config { cases: count, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..Config::default() }
}

/// A number n/d.
pub fn rational(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// The polynomial of terms `(coefficient, exponents)`.
pub fn polynomial(ring: &Ring, terms: &[(i64, Vec<u16>)]) -> Polynomial {
    let term = |(coefficient, exponents): &(i64, Vec<u16>)| {
        let mut all = exponents.clone();
        all.resize(ring.size(), 0);
        ring.term(&rational(*coefficient, 1), &all)
    };
    terms.iter().map(term).fold(ring.integer(0), |sum, term| sum.plus(&term))
}

/// Terms of a polynomial in so many variables, each of at most this degree.
pub fn terms(variables: usize, degree: u16, count: usize) -> impl Strategy<Value = Vec<(i64, Vec<u16>)>> {
    vec((-6_i64..=6, vec(0..=degree, variables)), 1..=count)
}

/// The same, not zero.
pub fn nonzero_terms(variables: usize, degree: u16, count: usize) -> impl Strategy<Value = Vec<(i64, Vec<u16>)>> {
    let ring = ALGEBRA.ring(variables);
    terms(variables, degree, count).prop_filter("zero", move |terms| !polynomial(&ring, terms).is_zero())
}

/// A point of small rationals.
pub fn point(variables: usize) -> impl Strategy<Value = Vec<BigRational>> {
    vec((-12_i64..=12, 1_i64..=4).prop_map(|(n, d)| rational(n, d)), variables)
}

/// A point of small positive rationals.
pub fn positive_point(variables: usize) -> impl Strategy<Value = Vec<BigRational>> {
    vec((1_i64..=40, 1_i64..=8).prop_map(|(n, d)| rational(n, d)), variables)
}

/// The value of a polynomial in the first variables of its ring.
pub fn value(polynomial: &Polynomial, point: &[BigRational]) -> BigRational {
    let of_term = |Term { coefficient, exponents }: Term| {
        let powers = point.iter().zip(exponents).map(|(value, exponent)| pow(value.clone(), exponent.into()));
        powers.fold(coefficient, |product, power| product * power)
    };
    polynomial.terms().into_iter().map(of_term).sum()
}

/// The value of a polynomial whose variables have real ones.
pub fn real_value(polynomial: &Polynomial, value_of: impl Fn(Var) -> Float) -> Float {
    let mut sum = Float::new(BITS);
    for Term { coefficient, exponents } in polynomial.terms() {
        let mut product = float(&coefficient);
        for (var, exponent) in exponents.into_iter().enumerate().filter(|(_, exponent)| *exponent > 0) {
            (0..exponent).for_each(|_| product *= value_of(Var(var)));
        }
        sum += product;
    }
    sum
}

/// A rational, rounded to many bits.
pub fn float(value: &BigRational) -> Float {
    let integer = |value: &BigInt| {
        let (sign, digits) = value.to_u64_digits();
        let magnitude = rug::Integer::from_digits(&digits, Order::Lsf);
        Float::with_val(BITS, if sign == num_bigint::Sign::Minus { -magnitude } else { magnitude })
    };
    integer(value.numer()) / integer(value.denom())
}

/// Whether two numbers agree in all digits but the last ones, those that sums of terms of this magnitude leave.
pub fn agree(a: &Float, b: &Float, magnitude: &Float) -> bool {
    let limit = Float::with_val(BITS, magnitude) >> (BITS / 2);
    Float::with_val(BITS, a - b).abs() <= limit
}

/// The product of powers of polynomials.
pub fn product<'p>(ring: &Ring, powers: impl IntoIterator<Item = &'p (Polynomial, u32)>) -> Polynomial {
    powers
        .into_iter()
        .fold(ring.constant(&BigRational::one()), |product, (factor, exponent)| product.times(&factor.power(*exponent)))
}
