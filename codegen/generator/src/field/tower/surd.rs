//! Sums with a radical: their parts, their conjugates and norms, their signs.

use super::{Element, Radical, Tower};
use crate::algebra::{Polynomial, Var};
use crate::field::Sign;

impl Tower {
    /// The sign of an element on the domain.
    #[must_use]
    pub fn sign(&self, a: &Element) -> Sign {
        self.sign_of(&a.numerator) * self.facts.sign(&a.denominator)
    }

    /// The sign of a polynomial in inputs and radicals.
    #[must_use]
    pub fn sign_of(&self, polynomial: &Polynomial) -> Sign {
        let Some(radical) = self.top_radical(polynomial) else {
            return self.facts.sign(polynomial);
        };
        if radical.degree == 3 {
            return self.sign_of_cubic(polynomial, radical);
        }
        let (rational, surd) = parts(polynomial, radical.var);
        let root = self.facts.variable(radical.var);
        let left = self.sign_of(&rational);
        let right = self.sign_of(&surd) * root;
        let sum = left.plus(right);
        if sum.is_definite() {
            return sum;
        }
        // a + b*r with a and b*r of opposite signs has the sign of the norm, or its negative
        let norm = self.sign_of(&self.norm(polynomial, radical));
        if left.is(Sign::NONNEGATIVE) && right.is(Sign::NONPOSITIVE) {
            norm
        } else if left.is(Sign::NONPOSITIVE) && right.is(Sign::NONNEGATIVE) {
            -norm
        } else {
            Sign::ANY
        }
    }

    /// The sign of a + b*t + c*t^2 with a cube root t.
    ///
    /// The norm is the sum times the squared magnitude of what it is with another of the three complex cube roots. That is
    /// zero only where all three terms are equal: of two terms where both are zero, and the sum with them.
    fn sign_of_cubic(&self, polynomial: &Polynomial, radical: &Radical) -> Sign {
        let terms = powers(polynomial, radical);
        let root = self.sign_of_root(radical);
        let signs = (0..).zip(&terms).map(|(power, term)| self.sign_of(term) * root.power(power));
        let sum = signs.fold(Sign::ZERO, Sign::plus);
        if sum.is_definite() {
            return sum;
        }
        let norm = self.sign_of(&self.norm(polynomial, radical));
        let few = terms.iter().filter(|term| !term.is_zero()).count() <= 2;
        if few || norm.is(Sign::NONZERO) && norm.is_definite() { norm } else { Sign::ANY }
    }

    /// The sign of a radical: a cube root has that of its radicand.
    #[must_use]
    pub fn sign_of_root(&self, radical: &Radical) -> Sign {
        let known = self.facts.variable(radical.var);
        if radical.degree == 3 { known & self.sign_of(&radical.radicand) } else { known }
    }

    /// What a polynomial is multiplied with to be free of the radical, reduced: of `a + b*t` with a square root
    /// `a - b*t`, of `a + b*t + c*t^2` with the cube root of r `(a^2 - b*c*r) + (c^2*r - a*b)*t + (b^2 - a*c)*t^2`.
    #[must_use]
    pub fn conjugate(&self, polynomial: &Polynomial, radical: &Radical) -> Polynomial {
        let root = self.ring.variable(radical.var);
        let [a, b, c] = powers(polynomial, radical);
        if radical.degree == 2 {
            return a.minus(&b.times(&root));
        }
        let r = &radical.radicand;
        let free = a.times(&a).minus(&b.times(&c).times(r));
        let linear = c.times(&c).times(r).minus(&a.times(&b));
        let square = b.times(&b).minus(&a.times(&c));
        self.reduce(&free.plus(&linear.plus(&square.times(&root)).times(&root)))
    }

    /// The product of a polynomial with its conjugate, free of the radical.
    #[must_use]
    pub fn norm(&self, polynomial: &Polynomial, radical: &Radical) -> Polynomial {
        self.reduce(&polynomial.times(&self.conjugate(polynomial, radical)))
    }
}

/// The parts `a`, `b` of `a + b*radical`, with a square root.
#[must_use]
pub fn parts(polynomial: &Polynomial, radical: Var) -> (Polynomial, Polynomial) {
    let mut coefficients = polynomial.coefficients(radical).into_iter();
    let zero = polynomial.ring().integer(0);
    let rational = coefficients.next().unwrap_or_else(|| zero.clone());
    (rational, coefficients.next().unwrap_or(zero))
}

/// The parts `a`, `b`, `c` of `a + b*radical + c*radical^2`.
#[must_use]
pub fn powers(polynomial: &Polynomial, radical: &Radical) -> [Polynomial; 3] {
    let mut coefficients = polynomial.coefficients(radical.var).into_iter();
    let zero = polynomial.ring().integer(0);
    std::array::from_fn(|_| coefficients.next().unwrap_or_else(|| zero.clone()))
}
