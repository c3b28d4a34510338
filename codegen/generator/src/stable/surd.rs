//! Surds: sums with a root, times a quotient, as forms get them.

use super::quotient::Quotient;
use crate::algebra::Polynomial;
use crate::field::{Radical, Sign, Tower, parts, powers};
use std::cell::OnceCell;

/// A sum `a + b*sqrt(r)` times a quotient; or with a cube root t, `a + b*t + c*t^2`.
pub struct Surd {
    /// The sum, whose terms have no factor in common.
    pub sum: Polynomial,
    /// The root: of highest level among those of the sum.
    pub radical: Radical,
    /// The quotient.
    pub quotient: Quotient,
    signs: OnceCell<[Sign; 2]>,
}

impl Surd {
    /// A sum times a quotient.
    #[must_use]
    pub fn new(sum: Polynomial, radical: Radical, quotient: Quotient) -> Self {
        Self { sum, radical, quotient, signs: OnceCell::new() }
    }

    /// The terms `a`, `b*t` and `c*t^2` of a sum with a cube root t, but for those that are zero.
    #[must_use]
    pub fn cubic_terms(&self) -> Vec<Polynomial> {
        let root = self.sum.ring().variable(self.radical.var);
        let terms = (0..).zip(powers(&self.sum, &self.radical)).map(|(power, part)| part.times(&root.power(power)));
        terms.filter(|term| !term.is_zero()).collect()
    }

    /// `a` and `b` of a sum with a square root.
    #[must_use]
    pub fn parts(&self) -> (Polynomial, Polynomial) {
        parts(&self.sum, self.radical.var)
    }

    /// The signs of `a` and `b*sqrt(r)`.
    pub fn signs(&self, tower: &Tower) -> [Sign; 2] {
        *self.signs.get_or_init(|| {
            let (rational, surd) = self.parts();
            [tower.sign_of(&rational), tower.sign_of(&surd) * tower.facts.variable(self.radical.var)]
        })
    }
}
