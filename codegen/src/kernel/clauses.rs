//! Formulas about signs of polynomials, and what follows from what.

use crate::algebra::Polynomial;
use crate::field::{Facts, Sign};

/// The most clauses that a formula is split into; one of more is not shown to imply anything.
const CLAUSES: usize = 256;

/// That a polynomial is of a sign.
#[derive(Clone, Debug)]
pub struct Literal {
    /// The polynomial.
    pub polynomial: Polynomial,
    /// Its possible signs.
    pub sign: Sign,
}

/// Literals, joined.
#[derive(Clone, Debug)]
pub enum Formula {
    /// One literal.
    Literal(Literal),
    /// All hold.
    And(Vec<Formula>),
    /// One holds at least.
    Or(Vec<Formula>),
}

impl Formula {
    /// Lists of literals of which one holds where the formula does; `None` if there are too many.
    fn clauses(&self) -> Option<Vec<Vec<Literal>>> {
        match self {
            Self::Literal(literal) => Some(vec![vec![literal.clone()]]),
            Self::Or(parts) => {
                let clauses: Vec<_> = parts.iter().map(Self::clauses).collect::<Option<Vec<_>>>()?.concat();
                (clauses.len() <= CLAUSES).then_some(clauses)
            }
            Self::And(parts) => parts.iter().try_fold(vec![Vec::new()], |clauses: Vec<Vec<Literal>>, part| {
                let more = part.clauses()?;
                let joined =
                    clauses.iter().flat_map(|one| more.iter().map(move |other| [&one[..], &other[..]].concat()));
                (clauses.len() * more.len() <= CLAUSES).then(|| joined.collect())
            }),
        }
    }
}

/// What holds.
#[derive(Clone)]
pub struct Known {
    facts: Facts,
    literals: Vec<Literal>,
}

impl Known {
    /// What some facts say.
    pub fn new(facts: Facts) -> Self {
        Self { facts, literals: Vec::new() }
    }

    /// Records that a formula holds; of one that leaves a choice, nothing.
    pub fn learn(&mut self, formula: &Formula) {
        if let Some([clause]) = formula.clauses().as_deref() {
            self.learn_all(clause);
        }
    }

    fn learn_all(&mut self, clause: &[Literal]) {
        for literal in clause {
            self.facts.learn(&literal.polynomial, literal.sign);
            self.literals.push(literal.clone());
        }
    }

    /// Whether one formula is shown to hold wherever all this and the other one do.
    pub fn implies(&self, formula: &Formula, other: &Formula) -> bool {
        let follows = |clause: Vec<Literal>| {
            let mut there = self.clone();
            there.learn_all(&clause);
            clause.iter().any(|literal| there.sign(&literal.polynomial).is_impossible()) || there.shows(other)
        };
        formula.clauses().is_some_and(|clauses| clauses.into_iter().all(follows))
    }

    /// Whether a formula is shown to hold.
    pub fn shows(&self, formula: &Formula) -> bool {
        match formula {
            Formula::Literal(literal) => self.sign(&literal.polynomial).is(literal.sign),
            Formula::And(parts) => parts.iter().all(|part| self.shows(part)),
            Formula::Or(parts) => parts.iter().any(|part| self.shows(part)),
        }
    }

    /// The sign of a polynomial: by the facts, and by literals that differ from it in factors of known sign only.
    fn sign(&self, polynomial: &Polynomial) -> Sign {
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
}
