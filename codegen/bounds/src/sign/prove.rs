//! The search for a sign: certificates over the rationals, each of them exact.

use super::range::Range;
use super::{Facts, Sign, boxes};
use crate::polynomial::{Atom, Polynomial};
use num_rational::BigRational;
use num_traits::One;
use std::cell::Cell;

/// How many times a search may use a fact on its way to one certificate.
const DEPTH: usize = 3;

/// How many polynomials it looks at before it gives up.
const PATIENCE: usize = 1500;

/// Both where little is gained by an answer.
const BRIEF: (usize, usize) = (1, 30);

/// How many terms a polynomial on its way may have.
const TERMS: usize = 200;

/// A search.
pub struct Search {
    depth: usize,
    left: Cell<usize>,
}

impl Default for Search {
    fn default() -> Self {
        Self { depth: DEPTH, left: Cell::new(PATIENCE) }
    }
}

impl Search {
    /// A search that is soon given up.
    pub fn brief() -> Self {
        Self { depth: BRIEF.0, left: Cell::new(BRIEF.1) }
    }

    /// The sign of a polynomial: by the box that bounds its atoms, if there is one, then looked for ever deeper.
    pub fn sign(&self, facts: &Facts, polynomial: &Polynomial) -> Sign {
        let mut sign = boxes::sign(polynomial, |atom| Range::of(atom, facts.atom(atom), facts.known()));
        if sign.is_strict() {
            return sign;
        }
        for depth in 0..=self.depth {
            sign = sign.and(self.infer(facts, polynomial, depth));
            if sign.is_definite() {
                break;
            }
        }
        sign
    }

    fn infer(&self, facts: &Facts, polynomial: &Polynomial, depth: usize) -> Sign {
        let common = polynomial.content().only(|atom| facts.atom(atom).is_definite());
        let core = polynomial.over(&common);
        facts.monomial(&common).times(self.infer_core(facts, &core, depth))
    }

    fn infer_core(&self, facts: &Facts, core: &Polynomial, depth: usize) -> Sign {
        let mut sign = facts.direct(core);
        let left = self.left.get();
        if sign.is_definite() || depth == 0 || left == 0 || core.size() > TERMS {
            return sign;
        }
        self.left.set(left - 1);
        let ways = [Self::by_factors, Self::by_slack, Self::by_multiples, Self::by_discriminant];
        for way in ways {
            sign = sign.and(way(self, facts, core, depth));
            if sign.is_definite() {
                break;
            }
        }
        sign
    }

    /// A fact that divides the polynomial, and the sign of the quotient; or one that is not zero, which it divides.
    fn by_factors(&self, facts: &Facts, polynomial: &Polynomial, depth: usize) -> Sign {
        let by_fact = |(known, sign): &(Polynomial, Sign)| match polynomial.quotient(known) {
            Some(quotient) => sign.times(self.infer(facts, &quotient, depth - 1)),
            None if sign.is(Sign::NONZERO) && known.quotient(polynomial).is_some() => Sign::NONZERO,
            None => Sign::ANY,
        };
        facts.known().iter().map(by_fact).fold(Sign::ANY, Sign::and)
    }

    /// A fact that is linear in an atom stands for that atom: `f = a*x + b` of known sign, `a` of known sign.
    fn by_slack(&self, facts: &Facts, polynomial: &Polynomial, depth: usize) -> Sign {
        let swaps = Swap::all(facts, polynomial, Atom(usize::MAX - depth));
        let quick = swaps.iter().map(|swap| (swap, self.swapped(facts, polynomial, swap, 0)));
        let slow = swaps.iter().map(|swap| (swap, self.swapped(facts, polynomial, swap, depth - 1)));
        let mut sign = Sign::ANY;
        for (swap, there) in quick.chain(slow.take(if depth > 1 { usize::MAX } else { 0 })) {
            sign = sign.and(there.times(swap.factor(polynomial)));
            if sign.is_definite() {
                break;
            }
        }
        sign
    }

    fn swapped(&self, facts: &Facts, polynomial: &Polynomial, swap: &Swap, depth: usize) -> Sign {
        let swapped = swap.facts(facts, depth > 0);
        self.infer(&swapped, &swap.polynomial(polynomial), depth)
    }

    /// A multiple of a fact, and a rest of the same sign: the multiple takes one term away whose sign does not fit.
    fn by_multiples(&self, facts: &Facts, polynomial: &Polynomial, depth: usize) -> Sign {
        let shown = |target| self.is_sum_of_multiples(facts, polynomial, target, depth);
        [Sign::NONNEGATIVE, Sign::NONPOSITIVE].into_iter().find(|target| shown(*target)).unwrap_or(Sign::ANY)
    }

    fn is_sum_of_multiples(&self, facts: &Facts, polynomial: &Polynomial, target: Sign, depth: usize) -> bool {
        let fits = |sign: Sign| sign.is(target);
        let wrong = polynomial.terms().find(|(m, value)| !fits(facts.monomial(m).times(Sign::of(value))));
        let Some((wrong, value)) = wrong else { return true };
        facts.known().iter().any(|(known, known_sign)| {
            known.terms().any(|(monomial, coefficient)| {
                let Some(quotient) = wrong.over(monomial) else { return false };
                let factor = Polynomial::term(quotient, value / coefficient);
                let rest = polynomial.minus(&known.times(&factor));
                fits(facts.by_terms(&factor).times(*known_sign)) && fits(self.infer(facts, &rest, depth - 1))
            })
        })
    }

    /// A quadratic without two real roots has the sign of its highest coefficient.
    fn by_discriminant(&self, facts: &Facts, polynomial: &Polynomial, depth: usize) -> Sign {
        let four = Polynomial::constant(BigRational::from_integer(4.into()));
        for atom in polynomial.atoms() {
            let coefficients = polynomial.coefficients(atom);
            let [c, b, a] = coefficients.as_slice() else { continue };
            let sign = self.infer(facts, a, depth - 1);
            if sign.is_strict()
                && self.infer(facts, &b.times(b).minus(&a.times(c).times(&four)), depth - 1).is(Sign::NONPOSITIVE)
            {
                return sign.or(Sign::ZERO);
            }
        }
        Sign::ANY
    }
}

/// An atom written through a fact: `x = (s - b)/a` where `s = a*x + b`.
struct Swap {
    /// Where the fact stands.
    position: usize,
    atom: Atom,
    slack: Atom,
    slack_sign: Sign,
    /// `a*x`
    numerator: Polynomial,
    /// `a`
    denominator: Polynomial,
    denominator_sign: Sign,
}

impl Swap {
    /// Every one that facts offer for the atoms of a polynomial.
    fn all(facts: &Facts, polynomial: &Polynomial, slack: Atom) -> Vec<Self> {
        let atoms = polynomial.atoms();
        let definite = facts.known().iter().enumerate().filter(|(_, (_, sign))| sign.is_definite());
        let pairs = definite.flat_map(|(position, _)| atoms.iter().map(move |atom| (position, *atom)));
        pairs.filter_map(|(position, atom)| Self::new(facts, position, atom, slack)).collect()
    }

    fn new(facts: &Facts, position: usize, atom: Atom, slack: Atom) -> Option<Self> {
        let (known, slack_sign) = facts.known().get(position)?;
        let coefficients = known.coefficients(atom);
        let [rest, slope] = coefficients.as_slice() else { return None };
        let (denominator, denominator_sign) = (slope.clone(), facts.by_terms(slope));
        let numerator = Polynomial::atom(slack).minus(rest);
        let swap = Self { position, atom, slack, slack_sign: *slack_sign, numerator, denominator, denominator_sign };
        denominator_sign.is_strict().then_some(swap)
    }

    /// A polynomial, times the power of `a` that its degree asks for.
    fn polynomial(&self, polynomial: &Polynomial) -> Polynomial {
        let coefficients = polynomial.coefficients(self.atom);
        let mut coefficients = coefficients.into_iter().rev();
        let highest = coefficients.next().unwrap_or_default();
        let mut power = Polynomial::constant(BigRational::one());
        coefficients.fold(highest, |value, coefficient| {
            power = power.times(&self.denominator);
            value.times(&self.numerator).plus(&coefficient.times(&power))
        })
    }

    /// The sign of the factor that [`polynomial`](Self::polynomial) puts in.
    fn factor(&self, polynomial: &Polynomial) -> Sign {
        self.denominator_sign.power(polynomial.degree(self.atom))
    }

    /// The facts without the atom; the one that was used has become the sign of the slack.
    fn facts(&self, facts: &Facts, polynomials: bool) -> Facts {
        let mut swapped = facts.with_known(if polynomials { self.known(facts) } else { Vec::new() });
        swapped.forget_atom(self.atom);
        swapped.set_atom(self.slack, self.slack_sign);
        swapped
    }

    fn known(&self, facts: &Facts) -> Vec<(Polynomial, Sign)> {
        let others = facts.known().iter().enumerate().filter(|(position, _)| *position != self.position);
        let others = others.map(|(_, (known, sign))| (self.polynomial(known), sign.times(self.factor(known))));
        let atom = (self.numerator.clone(), facts.atom(self.atom).times(self.denominator_sign));
        others.chain([atom]).filter(|(known, sign)| *sign != Sign::ANY && known.size() <= TERMS).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn atom(index: usize) -> Polynomial {
        Polynomial::atom(Atom(index))
    }

    fn number(value: i64) -> Polynomial {
        Polynomial::constant(BigRational::from_integer(value.into()))
    }

    fn positive(count: usize) -> Facts {
        let mut facts = Facts::default();
        (0..count).for_each(|index| facts.set_atom(Atom(index), Sign::POSITIVE));
        facts
    }

    #[test]
    fn terms_of_one_sign_need_nothing_else() {
        let (x, y) = (atom(0), atom(1));
        assert_eq!(positive(2).sign(&x.plus(&y)), Sign::POSITIVE);
        assert_eq!(positive(2).sign(&x.minus(&y)), Sign::ANY);
        assert_eq!(Facts::default().sign(&x.times(&x).plus(&number(1))), Sign::POSITIVE);
    }

    #[test]
    fn linear_facts_stand_for_their_atoms() {
        let (x, y, z) = (atom(0), atom(1), atom(2));
        let mut facts = positive(3);
        facts.learn(&x.minus(&y), Sign::POSITIVE);
        assert_eq!(facts.sign(&x.times(&number(4)).minus(&y)), Sign::POSITIVE);
        assert_eq!(facts.sign(&y.minus(&x.times(&number(4)))), Sign::NEGATIVE);
        assert_eq!(facts.sign(&x.minus(&y.times(&number(2)))), Sign::ANY);
        facts.learn(&y.minus(&z), Sign::NONNEGATIVE);
        assert!(facts.sign(&x.minus(&z)).is(Sign::NONNEGATIVE), "two facts");
        assert_eq!(facts.sign(&x.times(&x).minus(&y.times(&z))), Sign::POSITIVE);
    }

    #[test]
    fn facts_divide_and_are_divided() {
        let (x, y) = (atom(0), atom(1));
        let square = |p: &Polynomial| p.times(p);
        let difference = square(&x).minus(&number(1));
        let mut facts = Facts::default();
        facts.learn(&difference, Sign::NONZERO);
        facts.learn(&x, Sign::NONZERO);
        assert!(facts.sign(&square(&square(&x)).minus(&number(1))).is(Sign::NONZERO), "times x^2+1");
        assert!(facts.sign(&x.times(&difference).times(&number(-3))).is(Sign::NONZERO), "times x");
        assert!(facts.sign(&x.plus(&number(1))).is(Sign::NONZERO), "a factor");
        assert_eq!(facts.sign(&x.plus(&number(2))), Sign::ANY);
        assert_eq!(facts.sign(&difference.times(&y)), Sign::ANY);
        let mut facts = positive(2);
        facts.learn(&x.minus(&y), Sign::NONPOSITIVE);
        assert_eq!(facts.sign(&square(&x).minus(&square(&y))), Sign::NONPOSITIVE);
        assert_eq!(Facts::default().sign(&difference), Sign::ANY);
    }

    #[test]
    fn facts_with_factors_stand_for_atoms_too() {
        let (x, y, z) = (atom(0), atom(1), atom(2));
        let mut facts = positive(3);
        facts.learn(&x.times(&y).minus(&z.times(&z)), Sign::NONNEGATIVE);
        assert_eq!(facts.sign(&x.times(&y).times(&number(2)).minus(&z.times(&z))), Sign::POSITIVE);
        assert_eq!(facts.sign(&x.times(&x).times(&y).times(&y).minus(&z.power(4))), Sign::NONNEGATIVE);
    }

    #[test]
    fn quadratics_without_roots_keep_their_sign() {
        let (x, y) = (atom(0), atom(1));
        let form = |middle: i64| x.times(&x).plus(&x.times(&y).times(&number(middle))).plus(&y.times(&y));
        assert!(Facts::default().sign(&form(1)).is(Sign::NONNEGATIVE));
        assert!(Facts::default().sign(&form(-2)).is(Sign::NONNEGATIVE));
        assert_eq!(Facts::default().sign(&form(3)), Sign::ANY);
    }

    #[test]
    fn contradictions_are_seen() {
        let (x, y) = (atom(0), atom(1));
        let mut facts = positive(2);
        facts.learn(&x.minus(&y), Sign::POSITIVE);
        assert!(!facts.is_impossible());
        facts.learn(&y.minus(&x), Sign::NONNEGATIVE);
        assert!(facts.is_impossible());
        let mut facts = positive(2);
        facts.learn(&x.plus(&y), Sign::NEGATIVE);
        assert!(facts.is_impossible());
    }

    /// Small integers, the same in every run.
    struct Numbers(u64);

    impl Numbers {
        fn within(&mut self, size: i64) -> i64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 33) as i64 % (2 * size + 1) - size
        }

        fn polynomial(&mut self, terms: usize) -> Polynomial {
            let term = |_: usize| {
                let powers = (0..3).map(|index| atom(index).power(self.within(3).max(0) as u32 % 3));
                let monomial = powers.fold(number(1), |product, power| product.times(&power));
                monomial.times(&number(self.within(4)))
            };
            (0..terms).map(term).fold(Polynomial::default(), |sum, term| sum.plus(&term))
        }
    }

    fn value(polynomial: &Polynomial, point: &[i64]) -> BigRational {
        let integer = |value: i64| BigRational::from_integer(value.into());
        let power = |(atom, exponent): &(Atom, u32)| integer(point[atom.0].pow(*exponent));
        let terms = polynomial.terms().map(|(m, value)| m.powers().iter().map(power).fold(value.clone(), |a, b| a * b));
        terms.fold(integer(0), |sum, term| sum + term)
    }

    /// Facts that hold at a point never show a sign that is not the sign there.
    #[test]
    fn what_is_shown_holds_where_the_facts_do() {
        let mut numbers = Numbers(1);
        let mut shown = 0;
        for _ in 0..500 {
            let point: Vec<i64> = (0..3).map(|_| numbers.within(5)).collect();
            let mut facts = Facts::default();
            for (index, coordinate) in point.iter().enumerate() {
                let sign = Sign::of(&BigRational::from_integer((*coordinate).into()));
                facts.set_atom(Atom(index), if numbers.within(1) == 0 { sign.or(Sign::ZERO) } else { sign });
            }
            for terms in [2, 2, 3] {
                let polynomial = numbers.polynomial(terms);
                facts.learn(&polynomial, Sign::of(&value(&polynomial, &point)).or(Sign::ZERO));
            }
            facts.settle();
            facts.settle_atoms();
            assert!(!facts.is_impossible() && !facts.are_contradictory(), "{facts:?} at {point:?}");
            let polynomial = numbers.polynomial(3);
            let (there, sign) = (Sign::of(&value(&polynomial, &point)), facts.sign(&polynomial));
            assert!(there.is(sign), "{polynomial:?} is shown to be {sign} by {facts:?}, and is {there} at {point:?}");
            let by_terms = facts.by_terms(&polynomial).is_definite();
            shown += usize::from(sign.is_definite() && !by_terms);
        }
        assert!(shown > 5, "only {shown} signs are shown that terms alone do not");
    }
}
