//! Boxes: where the domain bounds atoms by numbers, intervals decide the signs of polynomials.
//!
//! What the interval of a box leaves open is looked for in its halves, so that polynomials whose terms pull both ways are
//! decided too, unless they reach zero.

use super::range::Range;
use super::set::Sign;
use crate::polynomial::{Atom, Polynomial};
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::BTreeMap;

/// How many terms are evaluated, in one box after another, before a sign is given up.
const TERMS: usize = 4096;

/// The ranges of atoms.
type Ranges = BTreeMap<Atom, Range>;

/// The sign of a polynomial in the box of its atoms; open where their signs are all that is known.
pub(super) fn sign(polynomial: &Polynomial, range_of: impl Fn(Atom) -> Range) -> Sign {
    let whole: Ranges = polynomial.atoms().into_iter().map(|atom| (atom, range_of(atom))).collect();
    if !whole.values().any(Range::is_more_than_a_sign) {
        return Sign::ANY;
    }
    let mut boxes = vec![whole];
    let most = TERMS / polynomial.size().max(1);
    let (mut found, mut looked) = (NONE, 0);
    while let Some(part) = boxes.pop() {
        looked += 1;
        let there = value(polynomial, &part).sign();
        if there.is_definite() {
            found = found.or(there);
        } else {
            let Some(halves) = halves(polynomial, &part).filter(|_| looked + boxes.len() < most) else {
                return Sign::ANY;
            };
            // two points of different signs end the search
            found = found.or(at_middle(polynomial, &part));
            boxes.extend(halves);
        }
        if !found.is_definite() {
            return Sign::ANY;
        }
    }
    found
}

const NONE: Sign = Sign { negative: false, zero: false, positive: false };

/// An interval that holds the values of a polynomial in a box.
fn value(polynomial: &Polynomial, part: &Ranges) -> Range {
    let power = |(atom, exponent): &(Atom, u32)| part[atom].power(*exponent);
    let terms = polynomial.terms().map(|(monomial, coefficient)| {
        monomial
            .powers()
            .iter()
            .map(power)
            .fold(Range::number(coefficient.clone()), |product, power| product.times(&power))
    });
    terms.reduce(|sum, term| sum.plus(&term)).unwrap_or_else(|| Range::number(BigRational::zero()))
}

fn at_middle(polynomial: &Polynomial, part: &Ranges) -> Sign {
    let point = part.iter().map(|(atom, range)| (*atom, Range::number(range.middle()))).collect();
    value(polynomial, &point).sign()
}

/// The halves of a box along the widest of its ranges that matter: an atom in one term only has no part in what terms
/// take from each other.
fn halves(polynomial: &Polynomial, part: &Ranges) -> Option<[Ranges; 2]> {
    let occurs =
        |atom: Atom| polynomial.terms().filter(|(m, _)| m.powers().iter().any(|power| power.0 == atom)).count();
    let shared = part.iter().filter(|(atom, _)| occurs(**atom) > 1);
    let wide = shared.filter_map(|(atom, range)| Some((*atom, range.width()?))).max_by(|a, b| a.1.cmp(&b.1));
    let (atom, width) = wide?;
    let with =
        |half: Range| part.iter().map(|(a, r)| (*a, if *a == atom { half.clone() } else { r.clone() })).collect();
    (!width.is_zero()).then(|| part[&atom].halves().map(with))
}

#[cfg(test)]
mod tests {
    use super::super::Facts;
    use super::*;

    fn number(value: i64) -> Polynomial {
        Polynomial::constant(BigRational::from_integer(value.into()))
    }

    /// Facts that atoms, in their order, lie between such numbers; what is strict excludes them.
    fn between(ends: &[[i64; 2]], strict: bool) -> Facts {
        let mut facts = Facts::default();
        let [above, below] =
            if strict { [Sign::POSITIVE, Sign::NEGATIVE] } else { [Sign::NONNEGATIVE, Sign::NONPOSITIVE] };
        for (index, [low, high]) in ends.iter().enumerate() {
            let atom = Polynomial::atom(Atom(index));
            facts.learn(&atom.minus(&number(*low)), above);
            facts.learn(&atom.minus(&number(*high)), below);
        }
        facts.settle();
        facts
    }

    #[test]
    fn a_sum_is_as_far_from_zero_as_its_box_leaves_it() {
        let (u, t) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let sum = |constant: i64| number(constant).plus(&t.times(&number(6))).plus(&u.times(&number(10)));
        let facts = between(&[[-100, 100], [-30, 50]], false);
        assert_eq!(facts.sign(&sum(3314)), Sign::POSITIVE);
        assert_eq!(facts.sign(&sum(1180)), Sign::NONNEGATIVE, "zero at a corner");
        assert_eq!(facts.sign(&sum(1179)), Sign::ANY);
        assert_eq!(facts.sign(&sum(-1301)), Sign::NEGATIVE);
        let inside = between(&[[-100, 100], [-30, 50]], true);
        assert_eq!(inside.sign(&sum(1180)), Sign::POSITIVE, "the corner is outside");
    }

    #[test]
    fn halves_decide_what_pulls_both_ways() {
        let (x, y) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let facts = between(&[[1, 4], [-2, 3]], false);
        // x^3 - 3*x^2 + x + 4 is at least 1.91 there, and its interval reaches down to -42
        let cubic = x.power(3).minus(&x.power(2).times(&number(3))).plus(&x).plus(&number(4));
        assert_eq!(facts.sign(&cubic), Sign::POSITIVE);
        assert_eq!(facts.sign(&cubic.minus(&number(2))), Sign::ANY, "-0.08 at x = 1.8, 22 at x = 4");
        let mixed = x.power(2).times(&y.power(2)).minus(&x.times(&y).times(&number(3))).plus(&number(20));
        assert_eq!(facts.sign(&mixed), Sign::POSITIVE, "(x*y - 3/2)^2 + 71/4");
    }

    #[test]
    fn squares_and_open_sides_count() {
        let (x, z) = (Polynomial::atom(Atom(0)), Polynomial::atom(Atom(1)));
        let facts = between(&[[-2, 3]], false);
        assert_eq!(facts.sign(&number(9).minus(&x.power(2))), Sign::NONNEGATIVE);
        assert_eq!(facts.sign(&x.plus(&number(3)).plus(&z.power(2))), Sign::POSITIVE, "z is anywhere");
        assert_eq!(facts.sign(&x.plus(&number(3)).plus(&z)), Sign::ANY);
        assert_eq!(facts.sign(&x.plus(&number(3)).times(&z)), Sign::ANY);
    }
}
