//! The arithmetic of arbitrary precision: precisions, and roots to all digits.

#![cfg(feature = "mpfr")]

use closedform_arith::{Function, Mpfr, Real, positive_root};

#[test]
fn a_result_takes_the_larger_precision() {
    let (short, long) = (Mpfr::new(60, 1.0), Mpfr::new(200, 3.0));
    for result in [short.add(&long), long.sub(&short), short.mul(&long), short.div(&long)] {
        assert_eq!(result.0.prec(), 200);
    }
    assert_eq!(short.div(&long).mul(&long), short);
    assert_eq!((short.call(Function::Sqrt).0.prec(), long.pi().0.prec()), (60, 200));
}

#[test]
fn a_root_has_all_its_digits() {
    for precision in [60, 200, 5000] {
        let root = Mpfr::new(precision, 0.0).positive_root(&[-2.0, 0.0, 1.0].map(|c| Mpfr::new(precision, c)));
        assert_eq!(root, Mpfr::new(precision, 2.0).call(Function::Sqrt));
    }
}

#[test]
fn roots_agree_with_those_in_f64() {
    for coefficients in [[-1.0, -1.0, 1.0], [-1e-100, 1e100, 1.0], [-5.0, 0.0, 3.0], [-1e300, 1e-300, 1e-300]] {
        let precise = Mpfr::new(300, 0.0).positive_root(&coefficients.map(|c| Mpfr::new(300, c)));
        assert_eq!(precise.0.to_f64(), positive_root(&coefficients));
    }
}

#[test]
fn what_has_no_single_positive_root_is_nan() {
    for coefficients in [[1.0, -3.0, 1.0], [1.0, 1.0, 1.0], [f64::NAN, 1.0, 1.0]] {
        assert!(Mpfr::new(100, 0.0).positive_root(&coefficients.map(|c| Mpfr::new(100, c))).0.is_nan());
    }
    assert!(Mpfr::new(100, 0.0).positive_root(&[]).0.is_nan());
}
