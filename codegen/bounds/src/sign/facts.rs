//! What is known: the signs of atoms and of polynomials.

use super::Sign;
use super::prove::Search;
use crate::polynomial::{Atom, Monomial, Polynomial};
use std::collections::{BTreeMap, BTreeSet};

/// What is known about signs where a value is computed.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    atoms: BTreeMap<Atom, Sign>,
    known: Vec<(Polynomial, Sign)>,
    impossible: bool,
}

impl Facts {
    /// The sign of an atom.
    pub fn atom(&self, atom: Atom) -> Sign {
        self.atoms.get(&atom).copied().unwrap_or(Sign::ANY)
    }

    /// Records the sign of an atom.
    pub fn set_atom(&mut self, atom: Atom, sign: Sign) {
        let sign = self.atom(atom).and(sign);
        self.impossible |= sign.is_impossible();
        self.atoms.insert(atom, sign);
    }

    /// Takes an atom out.
    pub fn forget_atom(&mut self, atom: Atom) {
        self.atoms.remove(&atom);
    }

    /// The polynomials of known sign.
    pub fn known(&self) -> &[(Polynomial, Sign)] {
        &self.known
    }

    /// Whether facts contradict each other: nothing is computed there.
    pub fn is_impossible(&self) -> bool {
        self.impossible
    }

    /// The same atoms and other polynomials.
    pub fn with_known(&self, known: Vec<(Polynomial, Sign)>) -> Self {
        Self { atoms: self.atoms.clone(), known, impossible: self.impossible }
    }

    /// Records the sign of a polynomial, without the powers of atoms that multiply it.
    pub fn learn(&mut self, polynomial: &Polynomial, sign: Sign) {
        let content = polynomial.content();
        if sign.is(Sign::NONZERO) {
            content.powers().iter().for_each(|(atom, _)| self.set_atom(*atom, Sign::NONZERO));
        }
        let strict = content.only(|atom| self.atom(atom).is_strict());
        let (factor, core) = polynomial.over(&strict).monic();
        let sign = sign.times(self.monomial(&strict)).times(Sign::of(&factor));
        self.impossible |= self.by_terms(&core).and(sign).is_impossible();
        match core.as_atom() {
            Some(atom) => self.set_atom(atom, sign),
            None if core.as_constant().is_none() => self.record(core, sign),
            None => {}
        }
    }

    fn record(&mut self, core: Polynomial, sign: Sign) {
        let before = self.known.iter().position(|(known, _)| *known == core);
        let before = before.map_or(Sign::ANY, |position| self.known.remove(position).1);
        let sign = sign.and(before);
        self.impossible |= sign.is_impossible();
        self.known.push((core, sign));
    }

    /// Once more, now that all is known.
    pub fn settle(&mut self) {
        for (polynomial, sign) in std::mem::take(&mut self.known) {
            self.learn(&polynomial, sign);
        }
    }

    /// What polynomials of known sign say of single atoms.
    pub fn settle_atoms(&mut self) {
        let atoms: BTreeSet<Atom> = self.known.iter().flat_map(|(known, _)| known.atoms()).collect();
        for atom in atoms {
            if !self.atom(atom).is_strict() {
                let sign = self.brief_sign(&Polynomial::atom(atom));
                self.set_atom(atom, sign);
            }
        }
        self.settle();
    }

    /// Whether one of the facts contradicts the others.
    pub fn are_contradictory(&self) -> bool {
        let contradicts = |position: usize| {
            let mut others = self.known.clone();
            let (polynomial, sign) = others.swap_remove(position);
            self.with_known(others).sign(&polynomial).and(sign).is_impossible()
        };
        self.impossible || (0..self.known.len()).any(contradicts)
    }

    /// The sign of a monomial.
    pub fn monomial(&self, monomial: &Monomial) -> Sign {
        let powers = monomial.powers().iter().map(|(atom, exponent)| self.atom(*atom).power(*exponent));
        powers.fold(Sign::POSITIVE, Sign::times)
    }

    /// The sign that all terms of a polynomial have.
    pub fn by_terms(&self, polynomial: &Polynomial) -> Sign {
        let terms = polynomial.terms().map(|(monomial, value)| self.monomial(monomial).times(Sign::of(value)));
        terms.fold(Sign::ZERO, Sign::plus)
    }

    /// The sign of a polynomial, by its terms and by what is known of it itself.
    pub fn direct(&self, polynomial: &Polynomial) -> Sign {
        let known = self.known.iter().filter_map(|(known, sign)| Some(sign.times(Sign::of(&polynomial.ratio(known)?))));
        known.fold(self.by_terms(polynomial), Sign::and)
    }

    /// The sign of a polynomial, if it is soon found.
    pub fn brief_sign(&self, polynomial: &Polynomial) -> Sign {
        Search::brief().sign(self, polynomial)
    }

    /// The sign of a polynomial.
    pub fn sign(&self, polynomial: &Polynomial) -> Sign {
        Search::default().sign(self, polynomial)
    }
}
