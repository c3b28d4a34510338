//! What holds on a domain, and what follows from it: signs of polynomials in every case that its conditions leave.

use super::formula::{Formula, Literal};
use crate::algebra::Polynomial;
use crate::field::{Facts, Sign, Tower};
use closedform_bounds as search;
use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;

/// The most cases; what would make more is not known.
const CASES: usize = 64;

thread_local! {
    /// What searches have found: the text of a kernel is proved by the same questions as it was made by, and they take long.
    static FOUND: RefCell<HashMap<String, bool>> = RefCell::default();
}

/// What holds: one of some cases.
#[derive(Clone)]
pub struct Known(Vec<Case>);

impl Known {
    /// What a tower says of signs.
    pub fn new(tower: &Tower) -> Self {
        Self(vec![Case { facts: tower.facts.clone(), search: OnceCell::new(), literals: Vec::new() }])
    }

    /// Records that a formula holds.
    pub fn learn(&mut self, formula: &Formula) {
        if let Some(clauses) = formula.clauses()
            && self.0.len() * clauses.len() <= CASES
        {
            let cases = self.0.iter().flat_map(|case| clauses.iter().map(|clause| case.with(clause)));
            self.0 = cases.filter(|case| !case.is_impossible()).collect();
        }
    }

    /// Whether one formula is shown to hold wherever all this and the other one do.
    pub fn implies(&self, formula: &Formula, other: &Formula) -> bool {
        formula.clauses().is_some_and(|clauses| {
            clauses.iter().all(|clause| self.0.iter().all(|case| case.with(clause).shows(other, Effort::Quick)))
        })
    }

    /// Whether a formula is shown to hold.
    pub fn shows(&self, formula: &Formula, effort: Effort) -> bool {
        let shows = |case: &Case| case.shows(formula, effort);
        match effort {
            Effort::Quick => self.0.iter().all(shows),
            Effort::Search => self.0.iter().all(|case| case.found(formula).unwrap_or_else(|| case.find(formula))),
        }
    }
}

/// How hard to look for a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// By what is known of factors: enough where a condition only has to be recognised.
    Quick,
    /// By a search for certificates too, for conditions that nobody stated.
    Search,
}

/// What holds in one case.
#[derive(Clone)]
struct Case {
    /// By factors.
    facts: Facts,
    /// The same for the search for certificates, once it is asked for.
    search: OnceCell<search::Facts>,
    literals: Vec<Literal>,
}

impl Case {
    fn with(&self, clause: &[Literal]) -> Self {
        let mut there = Self { search: OnceCell::new(), ..self.clone() };
        for literal in clause {
            there.facts.learn(&literal.polynomial, literal.sign);
            there.literals.push(literal.clone());
        }
        there
    }

    /// What was found before, by everything that an answer depends on.
    fn found(&self, formula: &Formula) -> Option<bool> {
        FOUND.with_borrow(|found| found.get(&self.question(formula)).copied())
    }

    fn find(&self, formula: &Formula) -> bool {
        let shown = self.shows(formula, Effort::Search);
        FOUND.with_borrow_mut(|found| found.insert(self.question(formula), shown));
        shown
    }

    fn question(&self, formula: &Formula) -> String {
        let known = self.literals.iter().map(Literal::key).collect::<Vec<_>>().join(";");
        format!("{known}|{}", formula.key())
    }

    fn is_impossible(&self) -> bool {
        self.literals.iter().any(|literal| self.quick_sign(&literal.polynomial).is_impossible())
    }

    fn search(&self) -> &search::Facts {
        self.search.get_or_init(|| {
            let mut facts = search::Facts::default();
            for literal in &self.literals {
                facts.learn(&searched(&literal.polynomial), signs(literal.sign));
            }
            facts.settle();
            facts.settle_atoms();
            facts
        })
    }

    fn shows(&self, formula: &Formula, effort: Effort) -> bool {
        self.is_impossible()
            || match formula {
                Formula::Literal(literal) => self.shows_literal(literal, effort),
                Formula::And(parts) => parts.iter().all(|part| self.shows(part, effort)),
                Formula::Or(parts) => {
                    parts.iter().any(|part| self.shows(part, effort)) || self.shows_the_rest(parts, effort)
                }
            }
    }

    /// One of some formulas holds if the others do where the first one does not.
    fn shows_the_rest(&self, parts: &[Formula], effort: Effort) -> bool {
        let [first, rest @ ..] = parts else { return false };
        let Some(clauses) = first.complement().clauses() else { return false };
        let rest = Formula::Or(rest.to_vec());
        clauses.len() <= CASES && clauses.iter().all(|clause| self.with(clause).shows(&rest, effort))
    }

    fn shows_literal(&self, literal: &Literal, effort: Effort) -> bool {
        let quick = self.quick_sign(&literal.polynomial);
        if quick.is(literal.sign) || effort == Effort::Quick {
            return quick.is(literal.sign);
        }
        let open = quick & self.searched_sign(&literal.polynomial) & literal.sign.complement();
        open.is_impossible() || open == Sign::ZERO && self.cannot_vanish(&literal.polynomial)
    }

    /// Whether all that is known contradicts that a polynomial, hence one of its factors, is zero: the search looks for
    /// signs, not for strict ones.
    fn cannot_vanish(&self, polynomial: &Polynomial) -> bool {
        polynomial.factors().powers.into_iter().all(|(factor, _)| {
            let zero = Literal { polynomial: factor, sign: Sign::ZERO };
            self.quick_sign(&zero.polynomial).is(Sign::NONZERO) || self.with(&[zero]).search().are_contradictory()
        })
    }

    /// The sign of a polynomial: by the facts, and by literals that differ from it in factors of known sign only.
    fn quick_sign(&self, polynomial: &Polynomial) -> Sign {
        if let Some(constant) = polynomial.as_constant() {
            return Sign::of(&constant);
        }
        let (unit, core) = self.core(polynomial);
        let zeros = self.zeros(polynomial);
        let mut sign = self.facts.sign(polynomial) & (unit * self.facts.sign(&core));
        for literal in self.literals.iter().filter(|literal| literal.polynomial.as_constant().is_none()) {
            let (known_unit, known_core) = self.core(&literal.polynomial);
            if known_core == core {
                sign = sign & (unit * known_unit * literal.sign);
            }
            let same_zeros = self.zeros(&literal.polynomial) == zeros;
            let by_zeros =
                [Sign::ZERO, Sign::NONZERO].into_iter().filter(|known| same_zeros && literal.sign.is(*known));
            sign = by_zeros.fold(sign, |sign, known| sign & known);
        }
        sign
    }

    /// A sign, and the polynomial of the same sign times it that has no factor of a known sign and no power above two.
    fn core(&self, polynomial: &Polynomial) -> (Sign, Polynomial) {
        let factors = polynomial.factors();
        let mut unit = Sign::of(&factors.constant);
        let mut core = polynomial.ring().integer(1);
        for (factor, exponent) in &factors.powers {
            let sign = self.facts.sign(factor).power(*exponent);
            if sign.is_definite() && sign.is(Sign::NONZERO) {
                unit = unit * sign;
            } else {
                core = core.times(&factor.power(if exponent % 2 == 0 { 2 } else { 1 }));
            }
        }
        (unit, core)
    }

    /// The polynomial with the same zeros, each once.
    fn zeros(&self, polynomial: &Polynomial) -> Polynomial {
        let factors = polynomial.factors().powers.into_iter().map(|(factor, _)| factor);
        let open = factors.filter(|factor| !self.facts.sign(factor).is(Sign::NONZERO));
        open.fold(polynomial.ring().integer(1), |zeros, factor| zeros.times(&factor))
    }

    /// The sign of a polynomial by its factors: certificates for each, also for what is left of it by what is zero.
    fn searched_sign(&self, polynomial: &Polynomial) -> Sign {
        product_of_signs(polynomial, |factor| {
            let sign = self.certified(factor);
            if is_strict(sign) {
                return sign;
            }
            let lesser = self.without_zeros(factor);
            lesser.iter().fold(sign, |sign, lesser| sign & product_of_signs(lesser, |factor| self.certified(factor)))
        })
    }

    /// The polynomial without a multiple of something that is zero, in every way that takes a term away.
    fn without_zeros(&self, polynomial: &Polynomial) -> Vec<Polynomial> {
        let zeros =
            self.literals.iter().filter(|literal| literal.sign.is(Sign::ZERO)).map(|literal| &literal.polynomial);
        let terms = polynomial.terms();
        let without = |zero: &Polynomial| {
            let same = |known: &crate::algebra::Term| {
                let term = terms.iter().find(|term| term.exponents == known.exponents)?;
                Some(polynomial.minus(&zero.scaled(&(&term.coefficient / &known.coefficient))))
            };
            zero.terms().iter().filter_map(same).collect::<Vec<_>>()
        };
        zeros.flat_map(without).collect()
    }

    /// The sign of an irreducible polynomial, looked for only as long as it may help.
    fn certified(&self, polynomial: &Polynomial) -> Sign {
        let quick = self.quick_sign(polynomial);
        if is_strict(quick) {
            return quick;
        }
        let searched = searched(polynomial);
        let brief = quick & sign_of(self.search().brief_sign(&searched));
        if brief.is_definite() { brief } else { brief & sign_of(self.search().sign(&searched)) }
    }
}

fn is_strict(sign: Sign) -> bool {
    sign.is(Sign::POSITIVE) || sign.is(Sign::NEGATIVE)
}

/// The sign of a polynomial, by those of its irreducible factors.
fn product_of_signs(polynomial: &Polynomial, of_factor: impl Fn(&Polynomial) -> Sign) -> Sign {
    let factors = polynomial.factors();
    let signs = factors.powers.iter().map(|(factor, exponent)| of_factor(factor).power(*exponent));
    signs.fold(Sign::of(&factors.constant), |product, sign| product * sign)
}

fn sign_of(found: search::Sign) -> Sign {
    let parts = [(found.negative, Sign::NEGATIVE), (found.zero, Sign::ZERO), (found.positive, Sign::POSITIVE)];
    parts.into_iter().filter(|(possible, _)| !possible).fold(Sign::ANY, |sign, (_, part)| sign & part.complement())
}

/// A polynomial for the search, its variables as atoms.
fn searched(polynomial: &Polynomial) -> search::Polynomial {
    let term = |term: crate::algebra::Term| {
        let powers = term.exponents.iter().enumerate().filter(|(_, exponent)| **exponent > 0);
        let powers =
            powers.map(|(var, exponent)| search::Polynomial::atom(search::Atom(var)).power(u32::from(*exponent)));
        powers.fold(search::Polynomial::constant(term.coefficient.clone()), |product, power| product.times(&power))
    };
    let terms = polynomial.terms().into_iter().map(term);
    terms.fold(search::Polynomial::default(), |sum, term| sum.plus(&term))
}

fn signs(sign: Sign) -> search::Sign {
    let possible = |part: Sign| part.is(sign);
    search::Sign { negative: possible(Sign::NEGATIVE), zero: possible(Sign::ZERO), positive: possible(Sign::POSITIVE) }
}
