//! The small ring: its laws, divisors, quotients and factors, on random polynomials and on those that are hard to factor.

use super::values::{ALGEBRA, cases, nonzero_terms, point, polynomial, product, terms, value};
use closedform_generator::algebra::{Polynomial, Ring, Var};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

const VARIABLES: usize = 3;

fn ring() -> Ring {
    ALGEBRA.ring(VARIABLES)
}

/// Equal but for a constant.
fn associated(a: &Polynomial, b: &Polynomial) -> bool {
    a.primitive().1 == b.primitive().1
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn sums_and_products_have_the_values_of_sums_and_products(
        a in terms(VARIABLES, 3, 5), b in terms(VARIABLES, 3, 5), at in point(VARIABLES), power in 0_u32..4
    ) {
        let (a, b) = (polynomial(&ring(), &a), polynomial(&ring(), &b));
        prop_assert_eq!(value(&a.plus(&b), &at), value(&a, &at) + value(&b, &at));
        prop_assert_eq!(value(&a.minus(&b), &at), value(&a, &at) - value(&b, &at));
        prop_assert_eq!(value(&a.times(&b), &at), value(&a, &at) * value(&b, &at));
        prop_assert_eq!(value(&a.power(power), &at), num_traits::pow(value(&a, &at), power as usize));
        prop_assert_eq!(value(&a.scaled(&at[0]), &at), value(&a, &at) * &at[0]);
        prop_assert_eq!(value(&a.substituted(Var(1), &b), &at), value(&a, &[at[0].clone(), value(&b, &at), at[2].clone()]));
    }

    #[test]
    fn the_laws_of_a_ring_hold_of_the_forms(
        a in terms(VARIABLES, 2, 4), b in terms(VARIABLES, 2, 4), c in terms(VARIABLES, 2, 4)
    ) {
        let [a, b, c] = [a, b, c].map(|terms| polynomial(&ring(), &terms));
        prop_assert_eq!(a.plus(&b), b.plus(&a));
        prop_assert_eq!(a.times(&b), b.times(&a));
        prop_assert_eq!(a.plus(&b).plus(&c), a.plus(&b.plus(&c)));
        prop_assert_eq!(a.times(&b).times(&c), a.times(&b.times(&c)));
        prop_assert_eq!(a.times(&b.plus(&c)), a.times(&b).plus(&a.times(&c)));
        prop_assert!(a.minus(&a).is_zero());
        prop_assert_eq!(a.times(&ring().integer(1)), a);
    }

    #[test]
    fn coefficients_make_the_polynomial_again(a in terms(VARIABLES, 3, 6)) {
        let a = polynomial(&ring(), &a);
        for var in [Var(0), Var(1), Var(2)] {
            let coefficients = a.coefficients(var);
            prop_assert_eq!(coefficients.len(), usize::from(a.degree(var)) + 1);
            let powers = coefficients.iter().zip(0..);
            let sum = powers.map(|(coefficient, power)| coefficient.times(&ring().variable(var).power(power)));
            prop_assert_eq!(sum.fold(ring().integer(0), |sum, term| sum.plus(&term)), a.clone());
        }
    }

    #[test]
    fn a_product_is_divided_by_its_parts_and_by_nothing_else(
        a in nonzero_terms(VARIABLES, 2, 4), b in nonzero_terms(VARIABLES, 2, 4), rest in nonzero_terms(VARIABLES, 2, 4)
    ) {
        let [a, b, rest] = [a, b, rest].map(|terms| polynomial(&ring(), &terms));
        prop_assert_eq!(a.times(&b).divided_by(&b), Some(a.clone()));
        match a.times(&b).plus(&rest).divided_by(&b) {
            Some(quotient) => prop_assert_eq!(quotient.times(&b), a.times(&b).plus(&rest)),
            None => prop_assert!(rest.divided_by(&b).is_none()),
        }
        prop_assert_eq!(ring().integer(0).divided_by(&b), Some(ring().integer(0)));
        prop_assert!(b.divided_by(&ring().integer(0)).is_none());
    }

    #[test]
    fn a_common_divisor_divides_and_is_the_greatest(
        a in nonzero_terms(VARIABLES, 2, 4), b in nonzero_terms(VARIABLES, 2, 4), common in nonzero_terms(VARIABLES, 2, 3)
    ) {
        let [a, b, common] = [a, b, common].map(|terms| polynomial(&ring(), &terms));
        let (left, right) = (a.times(&common), b.times(&common));
        let gcd = left.gcd(&right);
        let (left, right) = (left.divided_by(&gcd), right.divided_by(&gcd));
        prop_assert!(left.is_some() && right.is_some());
        prop_assert!(gcd.divided_by(&common).is_some());
        // the cofactors are coprime: no factor of the one divides the other
        let (left, right) = (left.unwrap(), right.unwrap());
        prop_assert!(left.factors().powers.iter().all(|(factor, _)| right.divided_by(factor).is_none()));
        prop_assert!(associated(&a.gcd(&ring().integer(0)), &a));
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn factors_of_a_product_are_those_of_its_parts(
        a in nonzero_terms(VARIABLES, 2, 3), b in nonzero_terms(VARIABLES, 1, 3), exponent in 1_u32..3
    ) {
        let (a, b) = (polynomial(&ring(), &a), polynomial(&ring(), &b));
        let whole = a.times(&b.power(exponent));
        let factors = whole.factors();
        prop_assert_eq!(product(&ring(), &factors.powers).scaled(&factors.constant), whole);
        // factorisation is unique: the exponents are the sums of those of the parts
        let (of_a, of_b) = (a.factors().powers, b.factors().powers);
        let power_in = |factor: &Polynomial, powers: &[(Polynomial, u32)]| {
            powers.iter().find(|(known, _)| known == factor).map_or(0, |(_, power)| *power)
        };
        for (factor, power) in &factors.powers {
            prop_assert_eq!(*power, power_in(factor, &of_a) + exponent * power_in(factor, &of_b), "{:?}", factor.terms());
        }
    }

    #[test]
    fn factors_have_no_factors(a in nonzero_terms(2, 3, 5)) {
        let ring = ALGEBRA.ring(2);
        for (factor, _) in polynomial(&ring, &a).factors().powers {
            prop_assert_eq!(factor.factors().powers, vec![(factor, 1)]);
        }
    }
}

/// What the factors are known of: by Eisenstein's criterion and by identities.
#[test]
fn known_factors_are_found() {
    let ring = ring();
    let [x, y, z] = [0, 1, 2].map(|var| ring.variable(Var(var)));
    let power = |p: &Polynomial, exponent| p.power(exponent);
    let count = |p: &Polynomial| p.factors().powers.iter().map(|(_, exponent)| *exponent).sum::<u32>();
    let one = ring.integer(1);
    for (what, polynomial, factors) in [
        ("x^12 - 1 has a factor for every divisor of 12", power(&x, 12).minus(&one), 6),
        ("x^8 + 1 is cyclotomic", power(&x, 8).plus(&one), 1),
        ("x^4 + 1 has factors modulo every prime", power(&x, 4).plus(&one), 1),
        ("Eisenstein: x^5 - 2", power(&x, 5).minus(&ring.integer(2)), 1),
        (
            "Sophie Germain: x^4 + 4*y^4",
            power(&x, 4).plus(&power(&y, 4).scaled(&BigRational::from_integer(4.into()))),
            2,
        ),
        ("x^6 - y^6", power(&x, 6).minus(&power(&y, 6)), 4),
        (
            "x^3 + y^3 + z^3 - 3*x*y*z",
            power(&x, 3)
                .plus(&power(&y, 3))
                .plus(&power(&z, 3))
                .minus(&x.times(&y).times(&z).scaled(&BigRational::from_integer(3.into()))),
            2,
        ),
        ("x^3 + y^3 + z^3 is smooth", power(&x, 3).plus(&power(&y, 3)).plus(&power(&z, 3)), 1),
        (
            "(x^3 + y^3 + 1)*(x^3 + 2*y^3 + 3)",
            power(&x, 3).plus(&power(&y, 3)).plus(&one).times(
                &power(&x, 3).plus(&power(&y, 3).scaled(&BigRational::from_integer(2.into()))).plus(&ring.integer(3)),
            ),
            2,
        ),
        ("(x + 1)*(y + 1), whose images share a factor", x.plus(&one).times(&y.plus(&one)), 2),
        (
            "((x^3 + 2)*(y^3 + 2))^2",
            power(&x, 3).plus(&ring.integer(2)).times(&power(&y, 3).plus(&ring.integer(2))).power(2),
            4,
        ),
        ("x^2*y^3*z", power(&x, 2).times(&power(&y, 3)).times(&z), 6),
        ("the difference of two squares of sums", power(&x.plus(&y), 2).minus(&power(&z, 2)), 2),
        (
            "a quadratic without a rational root",
            power(&x, 2).minus(&power(&y, 2).scaled(&BigRational::from_integer(2.into()))),
            1,
        ),
    ] {
        let found = polynomial.factors();
        assert_eq!(count(&polynomial), factors, "{what}: {:?}", found.powers);
        assert_eq!(product(&ring, &found.powers).scaled(&found.constant), polynomial, "{what}");
    }
}

/// Wilkinson's polynomial and a product with large coefficients: primes must grow with them.
#[test]
fn large_coefficients_are_no_hindrance() {
    let ring = ALGEBRA.ring(1);
    let x = ring.variable(Var(0));
    let wilkinson = (1..=20).fold(ring.integer(1), |product, root| product.times(&x.minus(&ring.integer(root))));
    assert_eq!(wilkinson.factors().powers.len(), 20);
    let large = BigRational::from_integer(num_traits::pow(10.into(), 40));
    let cubic = |constant: &BigRational| x.power(3).minus(&ring.constant(constant));
    let (one, other) = (cubic(&(&large + BigRational::one())), cubic(&(large * BigRational::from_integer(7.into()))));
    assert_eq!(one.times(&other).factors().powers.len(), 2);
}

#[test]
fn constants_have_no_factors() {
    let half = BigRational::new(1.into(), 2.into());
    for constant in [BigRational::zero(), half] {
        let factors = ring().constant(&constant).factors();
        assert!(factors.powers.is_empty());
        assert_eq!(factors.constant, constant);
    }
}
