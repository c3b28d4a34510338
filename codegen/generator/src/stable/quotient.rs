//! Quotients that are being assembled: a constant times powers of factors.

use crate::algebra::Polynomial;
use crate::program::Node;
use num_rational::BigRational;
use num_traits::One;

/// A factor of a quotient.
#[derive(Clone, Debug)]
pub enum Factor {
    /// A polynomial in the inputs.
    Polynomial(Polynomial),
    /// A finished step.
    Node(Node),
}

/// A constant times powers of factors.
#[derive(Clone, Debug)]
pub struct Quotient {
    /// The constant.
    pub constant: BigRational,
    /// The factors and their exponents, negative below the bar.
    pub powers: Vec<(Factor, i32)>,
}

impl Quotient {
    /// The constant one.
    #[must_use]
    pub fn one() -> Self {
        Self { constant: BigRational::one(), powers: Vec::new() }
    }

    /// Multiplies by a power of a polynomial, factor by factor.
    pub fn multiply(&mut self, polynomial: &Polynomial, exponent: i32) {
        let factors = polynomial.factors();
        let constant = num_traits::pow(factors.constant, exponent.unsigned_abs() as usize);
        self.constant *= if exponent < 0 { constant.recip() } else { constant };
        for (factor, power) in factors.powers {
            self.insert(factor, power as i32 * exponent);
        }
    }

    fn insert(&mut self, factor: Polynomial, exponent: i32) {
        let same = self.powers.iter_mut().find(|(f, _)| matches!(f, Factor::Polynomial(p) if *p == factor));
        match same {
            Some((_, power)) => *power += exponent,
            None => self.powers.push((Factor::Polynomial(factor), exponent)),
        }
        self.powers.retain(|(_, power)| *power != 0);
    }

    /// Multiplies by a power of a finished step.
    pub fn multiply_node(&mut self, node: Node, exponent: i32) {
        self.powers.push((Factor::Node(node), exponent));
    }
}
