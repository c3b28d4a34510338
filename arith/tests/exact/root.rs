//! The falling root iteration against known roots and against the sign of the exact polynomial.

use crate::numbers::{Random, exact};
use closedform_arith::limits::MAX_DEGREE;
use closedform_arith::positive_root;
use rug::Float;

/// The polynomial at `x`, exactly.
fn value(coefficients: &[f64], x: &Float) -> Float {
    coefficients.iter().rev().fold(exact(0.0), |value, &c| value * x + c)
}

/// That the exact polynomial changes sign within `share` ulp of `root`.
fn assert_root(coefficients: &[f64], root: f64, share: f64) {
    assert!(root.is_finite() && root > 0.0, "{root:?} of {coefficients:?}");
    let distance = exact(root.next_up() - root) * share;
    let below = value(coefficients, &(exact(root) - &distance));
    let above = value(coefficients, &(exact(root) + &distance));
    assert!(below < 0.0 && above > 0.0, "{root:?} of {coefficients:?}");
}

/// Coefficients with one change of sign, some of them zero, over a range of 2^-`spread` to 2^`spread`.
fn one_change(random: &mut Random, spread: u64) -> Vec<f64> {
    let degree = 1 + random.below(8);
    let change = random.below(degree);
    let coefficient = |power: u64| {
        let size = random.number(spread).abs();
        let inner = power != change && power != degree;
        let size = if inner && random.below(4) == 0 { 0.0 } else { size };
        if power <= change { -size } else { size }
    };
    (0..=degree).map(coefficient).collect()
}

/// The quartic of the optimum of a raster scan.
fn quartic(a: f64, v: f64, step: f64, d: f64) -> [f64; 5] {
    let c2 = 8.0 * v * v + 22.0 * step * v - 3.0 * a * a * d + 15.0 * step * step;
    [-3.0 * step * step * d, -6.0 * step * a * d, c2, (6.0 * v + 8.0 * step) * a, a * a]
}

#[test]
fn known_roots() {
    assert_eq!(positive_root(&[-2.0, 1.0]), 2.0);
    assert_eq!(positive_root(&[-2.0, 0.0, 1.0]), 2f64.sqrt());
    assert_eq!(positive_root(&[-6.0, 1.0, 1.0]), 2.0);
    assert_eq!(positive_root(&[-1.0, -1.0, 1.0]), 1.618_033_988_749_895);
    assert_eq!(positive_root(&[-1e-300, 0.0, 1e300]), 1e-300);
    assert_eq!(positive_root(&quartic(500.0, 0.5, 0.001, 0.001)), 0.051_775_535_648_672_68);
}

#[test]
fn roots_are_within_a_hair_of_half_an_ulp() {
    let mut random = Random::new(3);
    for round in 0..20_000 {
        let coefficients = one_change(&mut random, [4, 40, 200][round % 3]);
        assert_root(&coefficients, positive_root(&coefficients), 0.51);
    }
}

#[test]
fn extreme_coefficients_do_not_overflow() {
    for coefficients in [
        [-f64::MAX, 0.0, f64::MAX],
        [-f64::MAX, f64::MAX, f64::MAX],
        [-f64::MIN_POSITIVE, 0.0, f64::MIN_POSITIVE],
        [-5e-324, 5e-324, 5e-324],
        [-1.0, 1e300, 1e-300],
        [-1e-300, 1e-300, 1e300],
    ] {
        assert_root(&coefficients, positive_root(&coefficients), 0.51);
    }
}

#[test]
fn powers_of_two_scale_exactly() {
    let mut random = Random::new(4);
    for _ in 0..2_000 {
        let coefficients = one_change(&mut random, 40);
        let root = positive_root(&coefficients);
        for shift in [-30, -1, 7, 60] {
            let unknown = |power: usize, c: f64| c * 2f64.powi(-shift * power as i32);
            let scaled: Vec<_> = coefficients.iter().enumerate().map(|(power, &c)| unknown(power, c)).collect();
            assert_eq!(positive_root(&scaled), root * 2f64.powi(shift), "{coefficients:?}, unknown by 2^{shift}");
            let whole: Vec<_> = coefficients.iter().map(|c| c * 2f64.powi(shift)).collect();
            assert_eq!(positive_root(&whole), root, "{coefficients:?}, all by 2^{shift}");
        }
    }
}

#[test]
fn vanishing_ends_leave_the_lower_degree() {
    let root = positive_root(&[-1.0, -1.0, 1.0]);
    assert_eq!(positive_root(&[0.0, -1.0, -1.0, 1.0]), root);
    assert_eq!(positive_root(&[-1.0, -1.0, 1.0, 0.0, 0.0]), root);
}

#[test]
fn anything_but_one_change_of_sign_is_nan() {
    let rejected: &[&[f64]] = &[
        &[],
        &[1.0],
        &[0.0, 0.0],
        &[1.0, 2.0],
        &[-1.0, -2.0],
        &[1.0, -1.0],
        &[-1.0, 3.0, -2.0, 1.0],
        &[1.0, -3.0, 1.0],
        &[0.0, 0.0, 1.0],
        &[f64::NAN, 1.0],
        &[-1.0, f64::INFINITY],
        &[f64::NEG_INFINITY, 1.0],
    ];
    for coefficients in rejected {
        assert!(positive_root(coefficients).is_nan(), "{coefficients:?}");
    }
}

#[test]
fn the_highest_degree_is_taken_and_no_higher() {
    let mut coefficients = [0.0; MAX_DEGREE + 2];
    coefficients[0] = -2.0_f64.powi(MAX_DEGREE as i32);
    coefficients[MAX_DEGREE] = 1.0;
    assert_eq!(positive_root(&coefficients[..=MAX_DEGREE]), 2.0);
    assert!(positive_root(&coefficients).is_nan());
}
