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

proptest! {
    #![proptest_config(cases(60))]

    /// Whatever is inferred of a box holds at its points, on its edges too.
    #[test]
    fn what_is_inferred_on_a_box_holds(
        at in point(VARIABLES),
        ends in vec((0_i64..=3, 0_i64..=3, any::<bool>()), VARIABLES),
        asked in vec(nonzero_terms(VARIABLES, 3, 4), 3),
        constants in vec(-40_i64..=40, 3),
    ) {
        let ring = ALGEBRA.ring(VARIABLES + 1);
        let mut facts = Facts::new(&ring, Var(VARIABLES));
        for (var, (below, above, strict)) in ends.iter().enumerate() {
            let from = |number: BigRational| ring.variable(Var(var)).minus(&ring.constant(&number));
            let allowed = |sign: Sign, distance: i64| if *strict && distance > 0 { sign } else { sign.or(Sign::ZERO) };
            let [low, high] = [-*below, *above].map(|step| &at[var] + BigRational::from_integer(step.into()));
            facts.learn(&from(low), allowed(Sign::POSITIVE, *below));
            facts.learn(&from(high), allowed(Sign::NEGATIVE, *above));
        }
        for (terms, constant) in asked.iter().zip(constants) {
            let polynomial = polynomial(&ring, terms).plus(&ring.integer(constant));
            let (sign, found) = (Sign::of(&value(&polynomial, &at)), facts.sign(&polynomial));
            prop_assert!(sign.is(found), "{:?} is {sign} at {at:?}, not {found}", polynomial.terms());
        }
    }
}

/// Facts that variables, in their order, lie between such numbers; what is strict excludes them.
fn between(ends: &[[i64; 2]], strict: bool) -> Facts {
    let ring = ALGEBRA.ring(VARIABLES + 1);
    let mut facts = Facts::new(&ring, Var(VARIABLES));
    let [above, below] = if strict { [Sign::POSITIVE, Sign::NEGATIVE] } else { [Sign::NONNEGATIVE, Sign::NONPOSITIVE] };
    for (var, [low, high]) in ends.iter().enumerate() {
        facts.learn(&ring.variable(Var(var)).minus(&ring.integer(*low)), above);
        facts.learn(&ring.variable(Var(var)).minus(&ring.integer(*high)), below);
    }
    facts
}

#[test]
fn a_box_decides_signs() {
    let ring = ALGEBRA.ring(VARIABLES + 1);
    let [u, t, z] = [0, 1, 2].map(|var| ring.variable(Var(var)));
    let sum = |constant: i64| ring.integer(constant).plus(&t.times(&ring.integer(6))).plus(&u.times(&ring.integer(10)));
    let (closed, open) = (between(&[[-100, 100], [-30, 50]], false), between(&[[-100, 100], [-30, 50]], true));
    assert_eq!(closed.sign(&sum(3314)), Sign::POSITIVE);
    assert_eq!(closed.sign(&sum(1180)), Sign::NONNEGATIVE, "zero at a corner");
    assert_eq!(open.sign(&sum(1180)), Sign::POSITIVE, "the corner is outside");
    assert_eq!(open.sign(&sum(1179)), Sign::ANY);
    assert_eq!(closed.sign(&sum(-1301)), Sign::NEGATIVE);
    assert_eq!(closed.sign(&u.plus(&z.times(&z)).plus(&ring.integer(101))), Sign::POSITIVE, "z is anywhere");
    assert_eq!(closed.sign(&u.plus(&z).plus(&ring.integer(101))), Sign::ANY);
    // x^3 - 3*x^2 + x + 4 is at least 1.91 on [1, 4], and its interval reaches down to -42
    let (x, part) = (u, between(&[[1, 4]], false));
    let cubic = x.power(3).minus(&x.power(2).times(&ring.integer(3))).plus(&x).plus(&ring.integer(4));
    assert_eq!(part.sign(&cubic), Sign::POSITIVE, "in halves");
    assert_eq!(part.sign(&cubic.minus(&ring.integer(2))), Sign::ANY, "-0.08 at 1.8");
}
