//! Nested forms: they are the polynomial, and what is plain does not cancel on the domain.

use super::values::{ALGEBRA, cases, nonzero_terms, point, polynomial, value};
use closedform_generator::algebra::{Polynomial, Ring, Var};
use closedform_generator::field::{Facts, Sign};
use closedform_generator::stable::nest::{Mode, Nested, Nester};
use num_rational::BigRational;
use proptest::prelude::*;

const VARIABLES: usize = 3;

fn expanded(ring: &Ring, nested: &Nested) -> Polynomial {
    match nested {
        Nested::Constant(value) => ring.constant(value),
        Nested::Var(var) => ring.variable(*var),
        Nested::Sum(a, b, _) => expanded(ring, a).plus(&expanded(ring, b)),
        Nested::Product(a, b) => expanded(ring, a).times(&expanded(ring, b)),
    }
}

/// Whether the signs that sums state hold at a point, and their terms do not cancel unless both are exact.
fn does_not_cancel(ring: &Ring, nested: &Nested, at: &[BigRational]) -> bool {
    match nested {
        Nested::Constant(_) | Nested::Var(_) => true,
        Nested::Product(a, b) => does_not_cancel(ring, a, at) && does_not_cancel(ring, b, at),
        Nested::Sum(a, b, signs) => {
            let parts = [expanded(ring, a), expanded(ring, b)];
            let [left, right] = [0, 1].map(|part| Sign::of(&value(&parts[part], at)));
            let exact = parts.iter().all(|part| part.len() == 1 && part.terms()[0].exponents.iter().sum::<u16>() <= 1);
            let stated =
                left.is(signs[0]) && right.is(signs[1]) && Sign::of(&value(&expanded(ring, nested), at)).is(signs[2]);
            let agree = left.plus(right).is_definite();
            stated && (agree || exact) && does_not_cancel(ring, a, at) && does_not_cancel(ring, b, at)
        }
    }
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn nested_forms_are_the_polynomial(
        terms in nonzero_terms(VARIABLES, 3, 6), condition in nonzero_terms(VARIABLES, 1, 2), at in point(VARIABLES)
    ) {
        let ring = ALGEBRA.ring(VARIABLES + 1);
        let polynomial_of = |terms: &[(i64, Vec<u16>)]| polynomial(&ring, terms);
        let mut facts = Facts::new(&ring, Var(VARIABLES));
        for (var, value) in at.iter().enumerate() {
            facts.learn(&ring.variable(Var(var)), Sign::of(value).or(Sign::ZERO));
        }
        let condition = polynomial_of(&condition);
        facts.learn(&condition, Sign::of(&value(&condition, &at)));
        let polynomial = polynomial_of(&terms);
        let expression = Nester::new(&facts, VARIABLES, Mode::DoubleDouble).nest(&polynomial);
        prop_assert_eq!(expression.map(|nested| expanded(&ring, &nested)), Some(polynomial.clone()));
        if let Some(plain) = Nester::new(&facts, VARIABLES, Mode::Plain).nest(&polynomial) {
            prop_assert_eq!(expanded(&ring, &plain), polynomial);
            prop_assert!(does_not_cancel(&ring, &plain, &at), "{plain:?} at {at:?}");
        }
    }
}

#[test]
fn a_plain_form_is_there_where_terms_agree_and_not_where_they_may_cancel() {
    let ring = ALGEBRA.ring(VARIABLES + 1);
    let mut facts = Facts::new(&ring, Var(VARIABLES));
    let [x, y] = [0, 1].map(|var| ring.variable(Var(var)));
    let product = x.times(&x).minus(&y.times(&y).times(&y));
    let plain = |facts: &Facts, polynomial: &Polynomial| Nester::new(facts, VARIABLES, Mode::Plain).nest(polynomial);
    assert!(plain(&facts, &product).is_none());
    assert!(plain(&facts, &x.minus(&y)).is_some(), "the difference of inputs is one rounding");
    assert!(plain(&facts, &x.power(2).minus(&y.power(2))).is_some(), "by factors");
    facts.learn(&y, Sign::NEGATIVE);
    assert!(plain(&facts, &product).is_some());
}
