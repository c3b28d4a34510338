//! Signs: what the domain says about the sign of a polynomial.

use super::interval::{Interval, sign_on};
use super::set::Sign;
use crate::algebra::{Polynomial, Ring, Var};
use closedform_arith::Relation;
use num_rational::BigRational;
use std::cell::RefCell;
use std::collections::HashMap;

/// What is known about signs on a domain.
#[derive(Clone)]
pub struct Facts {
    ring: Ring,
    variables: Vec<Sign>,
    known: Vec<(Polynomial, Sign)>,
    /// What single variables are between.
    ranges: Vec<Interval>,
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
            ranges: vec![Interval::all(); ring.size()],
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
            self.limit(polynomial, sign);
            self.known.retain(|(known, _)| known != polynomial);
            self.known.push((polynomial.clone(), sign));
            let linear = polynomial.terms().iter().all(|t| t.exponents.iter().sum::<u16>() <= 1);
            if linear && sign.is_definite() {
                self.push_slack(polynomial, sign);
            }
        }
    }

    /// Of a difference of one variable and a number: the variable is on one side of the number.
    fn limit(&mut self, polynomial: &Polynomial, sign: Sign) {
        let variables = polynomial.variables();
        let [var] = variables.as_slice() else { return };
        let coefficients: Option<Vec<BigRational>> =
            polynomial.coefficients(*var).iter().map(Polynomial::as_constant).collect();
        let Some([rest, slope]) = coefficients.as_deref() else { return };
        let (sign, number) = (sign * Sign::of(slope), -rest / slope);
        let said = Relation::ALL.into_iter().filter(|relation| sign.is(Sign::of_relation(*relation)));
        self.ranges[var.0] = said.fold(self.ranges[var.0].clone(), |range, relation| range.related(relation, &number));
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
        let mut sign = self.sign_by_terms(polynomial, Sign::ANY) & self.sign_in_ranges(polynomial);
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

    /// The sign by the ranges of variables, where a number other than zero limits one of them.
    fn sign_in_ranges(&self, polynomial: &Polynomial) -> Sign {
        if !polynomial.variables().iter().any(|var| self.ranges[var.0].is_limited()) {
            return Sign::ANY;
        }
        let zero = BigRational::from_integer(0.into());
        let ranges = self.ranges.iter().zip(&self.variables).map(|(range, sign)| {
            let said = Relation::ALL.into_iter().filter(|relation| sign.is(Sign::of_relation(*relation)));
            said.fold(range.clone(), |range, relation| range.related(relation, &zero))
        });
        sign_on(&ranges.collect::<Vec<_>>(), &polynomial.terms())
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
