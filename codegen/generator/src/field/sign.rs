//! Signs: what the domain says about the sign of a polynomial.

use crate::algebra::{Polynomial, Ring, Var};
use closedform_syntax::Function;
use num_rational::BigRational;
use num_traits::Signed;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::fmt;
use std::ops::{BitAnd, Mul, Neg};

/// The set of signs that a value can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sign(u8);

const NEGATIVE: u8 = 1;
const ZERO: u8 = 2;
const POSITIVE: u8 = 4;

impl Sign {
    /// Nothing is known.
    pub const ANY: Self = Self(NEGATIVE | ZERO | POSITIVE);
    /// Greater than zero.
    pub const POSITIVE: Self = Self(POSITIVE);
    /// Less than zero.
    pub const NEGATIVE: Self = Self(NEGATIVE);
    /// Zero.
    pub const ZERO: Self = Self(ZERO);
    /// At least zero.
    pub const NONNEGATIVE: Self = Self(ZERO | POSITIVE);
    /// At most zero.
    pub const NONPOSITIVE: Self = Self(ZERO | NEGATIVE);
    /// Not zero.
    pub const NONZERO: Self = Self(NEGATIVE | POSITIVE);

    /// The sign of a number.
    #[must_use]
    pub fn of(value: &BigRational) -> Self {
        if value.is_positive() {
            Self::POSITIVE
        } else if value.is_negative() {
            Self::NEGATIVE
        } else {
            Self::ZERO
        }
    }

    /// Whether every sign in this set is in the other one.
    #[must_use]
    pub fn is(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    /// Whether the value never changes sign: it is at least zero, or it is at most zero.
    #[must_use]
    pub fn is_definite(self) -> bool {
        self.is(Self::NONNEGATIVE) || self.is(Self::NONPOSITIVE)
    }

    /// The signs that are not in this set.
    #[must_use]
    pub fn complement(self) -> Self {
        Self(Self::ANY.0 & !self.0)
    }

    /// Whether no value has it.
    #[must_use]
    pub fn is_impossible(self) -> bool {
        self.0 == 0
    }

    /// The sign of a sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        self.combine(other, |a, b| match (a, b) {
            (ZERO, sign) | (sign, ZERO) => sign,
            (a, b) if a == b => a,
            _ => Self::ANY.0,
        })
    }

    /// The sign of a value that has one of two signs.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The sign of a function's value, where there is one.
    #[must_use]
    pub fn called(self, function: Function) -> Self {
        let signs = [(NEGATIVE, Ordering::Less), (ZERO, Ordering::Equal), (POSITIVE, Ordering::Greater)];
        let bit = |sign: Ordering| signs.iter().find(|(_, other)| *other == sign).map_or(0, |(bit, _)| *bit);
        let values = signs.iter().filter(|(bit, _)| self.0 & bit != 0).filter_map(|(_, sign)| function.sign(*sign));
        Self(values.fold(0, |all, sign| all | bit(sign)))
    }

    /// The sign of a power.
    #[must_use]
    pub fn power(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::POSITIVE,
            _ if exponent % 2 == 1 => self,
            _ => self.square(),
        }
    }

    fn square(self) -> Self {
        let zero = self.0 & ZERO;
        let rest = if self.0 & (NEGATIVE | POSITIVE) == 0 { 0 } else { POSITIVE };
        Self(zero | rest)
    }

    fn combine(self, other: Self, rule: impl Fn(u8, u8) -> u8) -> Self {
        let mut result = 0;
        for a in [NEGATIVE, ZERO, POSITIVE] {
            for b in [NEGATIVE, ZERO, POSITIVE] {
                if self.0 & a != 0 && other.0 & b != 0 {
                    result |= rule(a, b);
                }
            }
        }
        Self(result)
    }
}

impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match *self {
            Self::POSITIVE => "positive",
            Self::NEGATIVE => "negative",
            Self::ZERO => "zero",
            Self::NONNEGATIVE => "nonnegative",
            Self::NONPOSITIVE => "nonpositive",
            Self::NONZERO => "nonzero",
            _ => "open",
        })
    }
}

impl Neg for Sign {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0 & ZERO | (self.0 & NEGATIVE) << 2 | (self.0 & POSITIVE) >> 2)
    }
}

impl Mul for Sign {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, |a, b| match (a, b) {
            (ZERO, _) | (_, ZERO) => ZERO,
            (a, b) if a == b => POSITIVE,
            _ => NEGATIVE,
        })
    }
}

impl BitAnd for Sign {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

/// What is known about signs on a domain.
#[derive(Clone)]
pub struct Facts {
    ring: Ring,
    variables: Vec<Sign>,
    known: Vec<(Polynomial, Sign)>,
    slacks: Vec<Slack>,
    spare: Var,
    cache: RefCell<HashMap<String, Sign>>,
}

/// A linear polynomial of known sign, which may stand for one of its variables.
#[derive(Clone)]
pub struct Slack {
    /// The linear polynomial.
    pub polynomial: Polynomial,
    /// Its sign.
    pub sign: Sign,
}

impl Slack {
    /// What a variable of the polynomial is, with `stand_in` for the polynomial itself.
    #[must_use]
    pub fn solved_for(&self, var: Var, stand_in: &Polynomial) -> Option<Polynomial> {
        let coefficients = self.polynomial.coefficients(var);
        let [rest, slope] = coefficients.as_slice() else { return None };
        Some(stand_in.minus(rest).scaled(&slope.as_constant()?.recip()))
    }
}

impl Facts {
    /// No facts yet; `spare` is a variable of the ring that nobody else uses.
    #[must_use]
    pub fn new(ring: &Ring, spare: Var) -> Self {
        Self {
            ring: ring.clone(),
            variables: vec![Sign::ANY; ring.size()],
            known: Vec::new(),
            slacks: Vec::new(),
            spare,
            cache: RefCell::default(),
        }
    }

    /// Records that a polynomial has a sign on the whole domain.
    pub fn learn(&mut self, polynomial: &Polynomial, sign: Sign) {
        self.cache.borrow_mut().clear();
        let factors = polynomial.factors();
        let mut sign = sign * Sign::of(&factors.constant);
        if sign.is(Sign::NONZERO) {
            for (factor, _) in &factors.powers {
                self.record(factor, Sign::NONZERO);
            }
        }
        let mut open = self.ring.integer(1);
        for (factor, exponent) in &factors.powers {
            let known = self.sign(factor).power(*exponent);
            if known.is_definite() && known.is(Sign::NONZERO) {
                sign = sign * known;
            } else if exponent % 2 == 1 {
                open = open.times(factor);
            }
        }
        self.record(&open, sign);
    }

    fn record(&mut self, polynomial: &Polynomial, sign: Sign) {
        if polynomial.as_constant().is_some() {
            return;
        }
        let sign = sign & self.sign(polynomial);
        self.cache.borrow_mut().clear();
        if let Some(var) = single_variable(polynomial) {
            self.variables[var.0] = self.variables[var.0] & sign;
        } else {
            self.known.retain(|(known, _)| known != polynomial);
            self.known.push((polynomial.clone(), sign));
            let linear = polynomial.terms().iter().all(|t| t.exponents.iter().sum::<u16>() <= 1);
            if linear && sign.is_definite() {
                self.push_slack(polynomial, sign);
            }
        }
    }

    /// Slacks are kept nonnegative, so that what is written through them has no needless minus.
    fn push_slack(&mut self, polynomial: &Polynomial, sign: Sign) {
        let turned = sign.is(Sign::NONPOSITIVE);
        let (polynomial, sign) = if turned { (polynomial.negated(), -sign) } else { (polynomial.clone(), sign) };
        self.slacks.retain(|slack| slack.polynomial != polynomial);
        self.slacks.push(Slack { polynomial, sign });
    }

    /// The linear polynomials of known sign.
    #[must_use]
    pub fn slacks(&self) -> &[Slack] {
        &self.slacks
    }

    /// The sign of one variable.
    #[must_use]
    pub fn variable(&self, var: Var) -> Sign {
        self.variables[var.0]
    }

    /// Records the sign of one variable.
    pub fn set_variable(&mut self, var: Var, sign: Sign) {
        self.cache.borrow_mut().clear();
        self.variables[var.0] = sign;
    }

    /// The sign of a polynomial on the domain.
    #[must_use]
    pub fn sign(&self, polynomial: &Polynomial) -> Sign {
        if let Some(constant) = polynomial.as_constant() {
            return Sign::of(&constant);
        }
        let key = format!("{:?}", polynomial.terms());
        if let Some(sign) = self.cache.borrow().get(&key) {
            return *sign;
        }
        let sign = self.infer(polynomial);
        self.cache.borrow_mut().insert(key, sign);
        sign
    }

    fn infer(&self, polynomial: &Polynomial) -> Sign {
        let (content, primitive) = polynomial.primitive();
        let content = Sign::of(&content);
        let whole = content * self.sign_of_irreducible(&primitive);
        if whole.is_definite() {
            return whole;
        }
        let factors = primitive.factors();
        let product = factors
            .powers
            .iter()
            .fold(Sign::of(&factors.constant), |sign, (factor, e)| sign * self.sign_of_irreducible(factor).power(*e));
        whole & (content * product)
    }

    fn sign_of_irreducible(&self, polynomial: &Polynomial) -> Sign {
        let mut sign = self.sign_by_terms(polynomial, Sign::ANY);
        for (known, known_sign) in &self.known {
            if known == polynomial {
                sign = sign & *known_sign;
            }
        }
        for slack in &self.slacks {
            sign = sign & self.sign_by_slack(polynomial, slack);
        }
        for (known, known_sign) in &self.known {
            sign = sign & self.sign_by_difference(polynomial, known, *known_sign);
        }
        sign
    }

    /// Whether every term has the same sign.
    #[must_use]
    pub fn terms_agree(&self, polynomial: &Polynomial) -> bool {
        self.sign_by_terms(polynomial, Sign::ANY).is_definite()
    }

    /// The sign if every term has the same one; `spare` is the sign of the spare variable.
    fn sign_by_terms(&self, polynomial: &Polynomial, spare: Sign) -> Sign {
        polynomial.terms().iter().fold(Sign::ZERO, |sum, term| {
            let sign = term.exponents.iter().enumerate().fold(Sign::of(&term.coefficient), |sign, (var, &exponent)| {
                let base = if Var(var) == self.spare { spare } else { self.variables[var] };
                sign * base.power(u32::from(exponent))
            });
            sum.plus(sign)
        })
    }

    /// The sign after one variable has been written through a linear polynomial of known sign.
    fn sign_by_slack(&self, polynomial: &Polynomial, slack: &Slack) -> Sign {
        let stand_in = self.ring.variable(self.spare);
        let mut sign = Sign::ANY;
        for var in slack.polynomial.variables() {
            if !polynomial.contains(var) {
                continue;
            }
            if let Some(value) = slack.solved_for(var, &stand_in) {
                sign = sign & self.sign_by_terms(&polynomial.substituted(var, &value), slack.sign);
            }
        }
        sign
    }

    /// The sign of `polynomial` as a positive multiple of a known polynomial plus a rest whose terms agree.
    fn sign_by_difference(&self, polynomial: &Polynomial, known: &Polynomial, known_sign: Sign) -> Sign {
        if !known_sign.is_definite() {
            return Sign::ANY;
        }
        let mut sign = Sign::ANY;
        let known_terms = known.terms();
        for term in polynomial.terms() {
            let Some(same) = known_terms.iter().find(|t| t.exponents == term.exponents) else { continue };
            let ratio = &term.coefficient / &same.coefficient;
            let rest = polynomial.minus(&known.scaled(&ratio));
            sign = sign & (known_sign * Sign::of(&ratio)).plus(self.sign_by_terms(&rest, Sign::ANY));
        }
        sign
    }
}

fn single_variable(polynomial: &Polynomial) -> Option<Var> {
    let variables = polynomial.variables();
    let [var] = variables.as_slice() else { return None };
    (*polynomial == polynomial.ring().variable(*var)).then_some(*var)
}
