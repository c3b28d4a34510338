//! Polynomials by Symbolica: the only file that names it.

use closedform_generator::algebra::{Implementation, Term, Var};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;
use symbolica::domains::integer::Integer;
use symbolica::domains::rational::{Q, Rational, RationalField};
use symbolica::poly::PolyVariable;
use symbolica::poly::factor::Factorize;
use symbolica::poly::polynomial::MultivariatePolynomial;

type Inner = MultivariatePolynomial<RationalField, u16>;

/// The variables of a ring, which its polynomials share.
type Variables = Arc<Vec<PolyVariable>>;

/// Factors and their exponents.
type Factors = Vec<(Polynomial, u32)>;

thread_local! {
    /// The variables of the rings so far, by their number.
    static RINGS: RefCell<HashMap<usize, Variables>> = RefCell::default();
    /// The factors of polynomials that were asked for, since signs ask for the same ones again and again.
    static FACTORED: RefCell<HashMap<Inner, Factors>> = RefCell::default();
}

/// A polynomial with rational coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Inner);

impl Implementation for Polynomial {
    fn term(coefficient: &BigRational, exponents: &[u16]) -> Self {
        let mut inner = Inner::new(&Q, None, variables(exponents.len()));
        if !coefficient.is_zero() {
            inner.append_monomial(to_symbolica(coefficient), exponents);
        }
        Self(inner)
    }

    fn size(&self) -> usize {
        self.0.variables.len()
    }

    fn terms(&self) -> Vec<Term> {
        let term = |coefficient, exponents: &[u16]| Term {
            coefficient: from_symbolica(coefficient),
            exponents: exponents.to_vec(),
        };
        (&self.0).into_iter().map(|monomial| term(monomial.coefficient, monomial.exponents)).collect()
    }

    fn count(&self) -> usize {
        self.0.nterms()
    }

    fn degree(&self, var: Var) -> u16 {
        self.0.degree(var.0)
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0)
    }

    fn scaled(&self, factor: &BigRational) -> Self {
        Self(self.0.clone().mul_coeff(to_symbolica(factor)))
    }

    fn power(&self, exponent: u32) -> Self {
        Self(self.0.pow(exponent as usize))
    }

    fn gcd(&self, other: &Self) -> Self {
        Self(self.0.gcd(&other.0))
    }

    fn quotient(&self, other: &Self) -> Option<Self> {
        self.0.try_div(&other.0).map(Self)
    }

    fn factors(&self) -> Factors {
        if let Some(factors) = FACTORED.with_borrow(|factored| factored.get(&self.0).cloned()) {
            return factors;
        }
        let factors = self.0.factor().into_iter().map(|(factor, exponent)| (Self(factor), exponent as u32));
        let factors: Factors = factors.collect();
        FACTORED.with_borrow_mut(|factored| factored.insert(self.0.clone(), factors.clone()));
        factors
    }
}

fn variables(count: usize) -> Variables {
    let make = || Arc::new((0..count).map(|i| PolyVariable::from(symbolica::symbol!(format!("v{i}")))).collect());
    RINGS.with_borrow_mut(|rings| rings.entry(count).or_insert_with(make).clone())
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
