//! Polynomials in one variable over a prime field, and their factors.
//!
//! Factors are separated by their degrees and then those of one degree: Cantor and Zassenhaus; Knuth, section 4.6.2; von
//! zur Gathen and Gerhard, sections 14.2 to 14.4.

use super::arithmetic::Sparse;
use crate::algebra::Var;
use num_bigint::{BigInt, BigUint};
use num_traits::{One, Zero};

/// Exponents of Mersenne primes, 2^k - 1: they are known primes of many sizes (OEIS A000043).
const MERSENNE: [u32; 15] =
    [61, 89, 107, 127, 521, 607, 1_279, 2_203, 2_281, 3_217, 4_253, 4_423, 9_689, 9_941, 11_213];

/// A polynomial: its coefficients, lowest power first, the last one not zero.
pub type Modular = Vec<BigUint>;

/// The integers modulo a prime, which is larger than any degree.
pub struct Field {
    prime: BigUint,
}

impl Field {
    /// The field of the smallest prime.
    pub fn smallest() -> Self {
        Self::mersenne(MERSENNE[0])
    }

    /// A field in which integers up to a bound, of either sign, are different; `None` of a bound beyond all primes.
    pub fn beyond(bound: &BigUint) -> Option<Self> {
        let bits = bound.bits() + 1;
        MERSENNE.into_iter().find(|&exponent| bits < u64::from(exponent)).map(Self::mersenne)
    }

    fn mersenne(exponent: u32) -> Self {
        Self { prime: (BigUint::one() << exponent) - 1_u32 }
    }

    fn reduced(&self, value: &BigInt) -> BigUint {
        let prime = BigInt::from(self.prime.clone());
        let value = (value % &prime + &prime) % &prime;
        value.to_biguint().unwrap_or_default()
    }

    /// The integer of least magnitude in a class.
    pub fn symmetric(&self, value: &BigUint) -> BigInt {
        let value = value % &self.prime;
        if &value << 1_u32 > self.prime { BigInt::from(value) - BigInt::from(self.prime.clone()) } else { value.into() }
    }

    /// The polynomial of integer coefficients, whose other variables have a value each.
    pub fn polynomial(&self, coefficients: &[Sparse], value: impl Fn(Var) -> BigInt) -> Modular {
        let value_of = |coefficient: &Sparse| {
            let terms = coefficient.terms.iter().map(|(exponents, number)| {
                let powers = exponents.iter().enumerate().filter(|(_, exponent)| **exponent > 0);
                powers.fold(self.reduced(number.numer()), |product, (var, exponent)| {
                    let base = self.reduced(&value(Var(var)));
                    product * base.modpow(&(*exponent).into(), &self.prime) % &self.prime
                })
            });
            terms.sum::<BigUint>() % &self.prime
        };
        trimmed(coefficients.iter().map(value_of).collect())
    }

    /// The product with a number.
    pub fn scaled(&self, polynomial: &[BigUint], factor: &BigUint) -> Modular {
        trimmed(polynomial.iter().map(|coefficient| coefficient * factor % &self.prime).collect())
    }

    fn monic(&self, polynomial: &[BigUint]) -> Modular {
        self.scaled(polynomial, &self.inverse_of_leading(polynomial))
    }

    /// The reciprocal of the leading coefficient, by Fermat's theorem.
    fn inverse_of_leading(&self, polynomial: &[BigUint]) -> BigUint {
        let leading = polynomial.last().cloned().unwrap_or_default();
        leading.modpow(&(&self.prime - 2_u32), &self.prime)
    }

    fn minus(&self, a: &[BigUint], b: &[BigUint]) -> Modular {
        let zero = BigUint::zero();
        let at = |list: &[BigUint], index| list.get(index).unwrap_or(&zero).clone();
        let length = a.len().max(b.len());
        trimmed((0..length).map(|i| (at(a, i) + &self.prime - at(b, i)) % &self.prime).collect())
    }

    /// The product.
    pub fn times(&self, a: &[BigUint], b: &[BigUint]) -> Modular {
        let mut product = vec![BigUint::zero(); (a.len() + b.len()).saturating_sub(1)];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        trimmed(product.into_iter().map(|coefficient| coefficient % &self.prime).collect())
    }

    /// Quotient and remainder by a polynomial that is not zero.
    fn divided(&self, a: &[BigUint], b: &[BigUint]) -> (Modular, Modular) {
        let (mut rest, inverse) = (a.to_vec(), self.inverse_of_leading(b));
        let mut quotient = vec![BigUint::zero(); (a.len() + 1).saturating_sub(b.len())];
        while rest.len() >= b.len() {
            let Some(leading) = rest.last() else { break };
            let factor = leading * &inverse % &self.prime;
            let shift = rest.len() - b.len();
            for (place, coefficient) in rest[shift..].iter_mut().zip(b) {
                *place = (&*place + &self.prime - &factor * coefficient % &self.prime) % &self.prime;
            }
            quotient[shift] = factor;
            rest = trimmed(rest);
        }
        (trimmed(quotient), rest)
    }

    /// The greatest common divisor whose leading coefficient is 1.
    pub fn gcd(&self, a: &[BigUint], b: &[BigUint]) -> Modular {
        let (mut a, mut b) = (a.to_vec(), b.to_vec());
        while !b.is_empty() {
            let rest = self.divided(&a, &b).1;
            (a, b) = (b, rest);
        }
        self.monic(&a)
    }

    fn derivative(&self, polynomial: &[BigUint]) -> Modular {
        let terms = polynomial.iter().enumerate().skip(1);
        trimmed(terms.map(|(power, coefficient)| coefficient * power % &self.prime).collect())
    }

    /// A power modulo a polynomial.
    fn power(&self, base: &[BigUint], exponent: &BigUint, modulus: &[BigUint]) -> Modular {
        let mut power = vec![BigUint::one()];
        for bit in (0..exponent.bits()).rev() {
            power = self.divided(&self.times(&power, &power), modulus).1;
            if exponent.bit(bit) {
                power = self.divided(&self.times(&power, base), modulus).1;
            }
        }
        power
    }

    /// The irreducible factors with leading coefficient 1, each as often as it divides the polynomial.
    pub fn factors(&self, polynomial: &[BigUint]) -> Vec<Modular> {
        let repeated = self.gcd(polynomial, &self.derivative(polynomial));
        let mut rest = self.monic(polynomial);
        let mut factors = Vec::new();
        for (product, degree) in self.distinct_degrees(&self.divided(&rest, &repeated).0) {
            for factor in self.equal_degrees(product, degree) {
                let mut divided = self.divided(&rest, &factor);
                while divided.1.is_empty() {
                    factors.push(factor.clone());
                    rest = divided.0;
                    divided = self.divided(&rest, &factor);
                }
            }
        }
        factors
    }

    /// The products of the irreducible factors of each degree, of a polynomial without repeated ones.
    fn distinct_degrees(&self, polynomial: &[BigUint]) -> Vec<(Modular, usize)> {
        let x = [BigUint::zero(), BigUint::one()];
        let (mut rest, mut products) = (self.monic(polynomial), Vec::new());
        let mut power = x.to_vec();
        for degree in 1.. {
            if rest.len() <= 2 * degree {
                break;
            }
            power = self.power(&power, &self.prime, &rest);
            let product = self.gcd(&rest, &self.minus(&power, &x));
            if product.len() > 1 {
                rest = self.divided(&rest, &product).0;
                power = self.divided(&power, &rest).1;
                products.push((product, degree));
            }
        }
        if rest.len() > 1 {
            let degree = rest.len() - 1;
            products.push((rest, degree));
        }
        products
    }

    /// The irreducible factors of a product of such of one degree.
    fn equal_degrees(&self, product: Modular, degree: usize) -> Vec<Modular> {
        let (mut open, mut factors) = (vec![product], Vec::new());
        let half = (self.prime.pow(degree as u32) - 1_u32) >> 1_u32;
        let mut numbers = Numbers(1);
        while let Some(product) = open.pop() {
            if product.len() == degree + 1 {
                factors.push(product);
                continue;
            }
            let any: Modular = trimmed((1..product.len()).map(|_| numbers.next() % &self.prime).collect());
            let power = self.power(&any, &half, &product);
            let part = self.gcd(&product, &self.minus(&power, &[BigUint::one()]));
            if (2..product.len()).contains(&part.len()) {
                open.push(self.divided(&product, &part).0);
                open.push(part);
            } else {
                open.push(product);
            }
        }
        factors
    }
}

/// Numbers without a pattern, the same in every run: Knuth's linear congruential generator MMIX.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> BigUint {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0.into()
    }
}

fn trimmed(mut polynomial: Modular) -> Modular {
    while polynomial.last().is_some_and(Zero::is_zero) {
        polynomial.pop();
    }
    polynomial
}
