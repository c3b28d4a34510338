//! Signs: what is inferred holds at every point of the domain, and the obvious is inferred.

use super::values::{ALGEBRA, cases, nonzero_terms, point, polynomial, value};
use closedform_generator::algebra::Var;
use closedform_generator::field::{Facts, Sign};
use num_rational::BigRational;
use proptest::collection::vec;
use proptest::prelude::*;

const VARIABLES: usize = 3;

const SIGNS: [Sign; 7] =
    [Sign::ANY, Sign::POSITIVE, Sign::NEGATIVE, Sign::ZERO, Sign::NONNEGATIVE, Sign::NONPOSITIVE, Sign::NONZERO];

fn of(number: i64) -> Sign {
    Sign::of(&BigRational::from_integer(number.into()))
}

/// The least set of signs that holds the results of an operation on numbers of these signs.
fn tight(a: Sign, b: Sign, operation: impl Fn(i64, i64) -> i64) -> Vec<Sign> {
    let numbers = |sign: Sign| (-2..=2).filter(move |&number| of(number).is(sign));
    let results = numbers(a).flat_map(|x| numbers(b).map(move |y| (x, y)));
    let union = results.map(|(x, y)| of(operation(x, y))).reduce(Sign::or);
    union.into_iter().collect()
}

#[test]
fn operations_on_signs_are_those_on_numbers() {
    for a in SIGNS {
        for b in SIGNS {
            assert_eq!(vec![a.plus(b)], tight(a, b, |x, y| x + y), "{a} + {b}");
            assert_eq!(vec![a * b], tight(a, b, |x, y| x * y), "{a} * {b}");
        }
        assert_eq!(vec![-a], tight(a, a, |x, _| -x), "-{a}");
        for exponent in 0..4 {
            assert_eq!(vec![a.power(exponent)], tight(a, a, |x, _| x.pow(exponent)), "{a}^{exponent}");
        }
        assert!((a & a.complement()).is_impossible() && a.or(a.complement()) == Sign::ANY);
        assert_eq!(a.is_definite(), !(Sign::POSITIVE.is(a) && Sign::NEGATIVE.is(a)));
    }
}

proptest! {
    #![proptest_config(cases(40))]

    /// The conditions are true of the point, so whatever follows from them must be.
    #[test]
    fn what_is_inferred_holds(
        at in point(VARIABLES),
        conditions in vec((nonzero_terms(VARIABLES, 1, 3), any::<bool>()), 1..4),
        asked in vec(nonzero_terms(VARIABLES, 2, 3), 2),
    ) {
        let ring = ALGEBRA.ring(VARIABLES + 1);
        let mut facts = Facts::new(&ring, Var(VARIABLES));
        let mut known = Vec::new();
        for (condition, strict) in conditions {
            let condition = polynomial(&ring, &condition);
            let sign = Sign::of(&value(&condition, &at));
            facts.learn(&condition, if strict { sign } else { sign.or(Sign::ZERO) });
            known.push(condition);
        }
        let asked: Vec<_> = asked.iter().map(|terms| polynomial(&ring, terms)).collect();
        let products = asked.iter().flat_map(|a| known.iter().map(move |b| a.times(b)));
        let sums = asked.iter().flat_map(|a| known.iter().map(move |b| a.plus(b)));
        for polynomial in asked.iter().cloned().chain(products).chain(sums).chain(known.clone()) {
            let (sign, found) = (Sign::of(&value(&polynomial, &at)), facts.sign(&polynomial));
            prop_assert!(sign.is(found), "{:?} is {sign} at {at:?}, not {found}", polynomial.terms());
        }
    }
}

#[test]
fn the_obvious_is_inferred() {
    let ring = ALGEBRA.ring(VARIABLES + 1);
    let [x, y, z] = [0, 1, 2].map(|var| ring.variable(Var(var)));
    let mut facts = Facts::new(&ring, Var(VARIABLES));
    facts.learn(&x, Sign::POSITIVE);
    facts.learn(&y.minus(&x), Sign::POSITIVE);
    facts.learn(&z.times(&x), Sign::NONNEGATIVE);
    let sign = |polynomial| facts.sign(&polynomial);
    assert_eq!(sign(x.times(&x).plus(&x)), Sign::POSITIVE);
    assert_eq!(sign(z.clone()), Sign::NONNEGATIVE, "the sign of a product whose other factor is known");
    assert_eq!(sign(y.clone()), Sign::POSITIVE, "a variable through a linear form of known sign");
    assert_eq!(sign(x.minus(&y).times(&x)), Sign::NEGATIVE, "by factors");
    assert_eq!(sign(y.plus(&z).minus(&x)), Sign::POSITIVE, "a known form and a rest of its sign");
    assert_eq!(sign(x.minus(&z)), Sign::ANY);
}

#[test]
fn a_square_is_known_of_where_its_root_is_not() {
    let ring = ALGEBRA.ring(VARIABLES + 1);
    let (x, y) = (ring.variable(Var(0)), ring.variable(Var(1)));
    let facts = Facts::new(&ring, Var(VARIABLES));
    assert_eq!(facts.sign(&x.minus(&y).power(2)), Sign::NONNEGATIVE);
    assert_eq!(facts.sign(&x.minus(&y)), Sign::ANY);
}
