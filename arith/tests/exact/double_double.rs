//! Double-double arithmetic against exact arithmetic: the theorems, on numbers chosen where it hurts.

use crate::numbers::{Random, exact};
use closedform_arith::DoubleDouble;
use closedform_arith::error_model::{UNIT, double_double as theorem};
use rug::Float;

const ROUNDS: usize = 20_000;

fn exact_sum(extended: DoubleDouble) -> Float {
    exact(extended.round()) + exact(extended.low())
}

/// Pairs of plain numbers: powers of two and their neighbours, near-equal ones, and random ones.
fn pairs() -> Vec<(f64, f64)> {
    let mut random = Random::new(1);
    let one = [1.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON / 2.0, 0.0, -0.0, 1.5, 134_217_729.0, 0.1];
    let nasty: Vec<f64> =
        one.iter().flat_map(|x| [*x, -x, x * 2f64.powi(53), x * 2f64.powi(-480), x * 2f64.powi(480)]).collect();
    let mut pairs: Vec<_> = nasty.iter().flat_map(|&a| nasty.iter().map(move |&b| (a, b))).collect();
    for _ in 0..ROUNDS {
        let a = random.number(400);
        let far = random.number(400);
        pairs.extend([(a, far), (a, random.near(a))]);
    }
    pairs
}

/// Pairs of extended numbers, whose low parts cancel too at times.
fn wide_pairs() -> Vec<(DoubleDouble, DoubleDouble)> {
    let mut random = Random::new(2);
    let mut wide_pairs = Vec::new();
    for (a, b) in pairs().into_iter().filter(|(a, b)| a.abs() < 1e130 && b.abs() < 1e130) {
        let low = |random: &mut Random, high: f64| high * f64::EPSILON * random.number(30).clamp(-0.5, 0.5);
        let first = DoubleDouble::two_sum(a, low(&mut random, a));
        let second = DoubleDouble::two_sum(b, low(&mut random, b));
        let opposite = DoubleDouble::two_sum(-first.round(), random.near(first.low()));
        wide_pairs.extend([(first, second), (first, opposite)]);
    }
    wide_pairs
}

/// That `computed` is within `bound` u^2 of `expected`, and normalised.
fn assert_close(computed: DoubleDouble, expected: Float, bound: f64, what: &dyn Fn() -> String) {
    assert_eq!(computed.round() + computed.low(), computed.round(), "{} is not normalised", what());
    let error = Float::with_val(crate::numbers::EXACT, &expected - exact_sum(computed)).abs();
    assert!(error <= expected.abs() * (bound * UNIT * UNIT), "{}: {computed:?}", what());
}

/// Whether errors of `a * b`, and of their low parts, can be represented.
fn product_is_safe(a: f64, b: f64) -> bool {
    let product = (a * b).abs();
    product == 0.0 && (a == 0.0 || b == 0.0) || (2f64.powi(-860)..2f64.powi(1000)).contains(&product)
}

#[test]
fn two_sum_is_exact() {
    for (a, b) in pairs() {
        assert_eq!(exact_sum(DoubleDouble::two_sum(a, b)), exact(a) + exact(b), "{a:e} + {b:e}");
    }
}

#[test]
fn two_product_is_exact() {
    for (a, b) in pairs().into_iter().filter(|&(a, b)| product_is_safe(a, b)) {
        assert_eq!(exact_sum(DoubleDouble::two_product(a, b)), exact(a) * exact(b), "{a:e} * {b:e}");
    }
}

#[test]
fn sums_keep_their_bounds() {
    for (a, b) in wide_pairs() {
        assert_close(a + b, exact_sum(a) + exact_sum(b), theorem::SUM, &|| format!("{a:?} + {b:?}"));
        assert_close(a - b, exact_sum(a) - exact_sum(b), theorem::SUM, &|| format!("{a:?} - {b:?}"));
        let plain = b.round();
        assert_close(a + plain, exact_sum(a) + exact(plain), theorem::SUM_WITH_F64, &|| format!("{a:?} + {plain:?}"));
        assert_close(a - plain, exact_sum(a) - exact(plain), theorem::SUM_WITH_F64, &|| format!("{a:?} - {plain:?}"));
    }
}

#[test]
fn products_keep_their_bounds() {
    for (a, b) in wide_pairs().into_iter().filter(|(a, b)| product_is_safe(a.round(), b.round())) {
        assert_close(a * b, exact_sum(a) * exact_sum(b), theorem::PRODUCT, &|| format!("{a:?} * {b:?}"));
        let plain = b.round();
        assert_close(a * plain, exact_sum(a) * exact(plain), theorem::PRODUCT_WITH_F64, &|| {
            format!("{a:?} * {plain:?}")
        });
    }
}

#[test]
fn quotients_keep_their_bounds() {
    let safe = |x: f64| (2f64.powi(-430)..2f64.powi(430)).contains(&x.abs());
    for (a, b) in wide_pairs().into_iter().filter(|(a, b)| safe(a.round()) && safe(b.round())) {
        let expected = Float::with_val(400, exact_sum(a) / exact_sum(b));
        assert_close(a / b, expected, theorem::QUOTIENT, &|| format!("{a:?} / {b:?}"));
    }
}

#[test]
fn roots_keep_their_bounds() {
    for (a, _) in wide_pairs().into_iter().filter(|(a, _)| a.round() > 2f64.powi(-400)) {
        assert_close(a.sqrt(), Float::with_val(400, exact_sum(a).sqrt()), theorem::ROOT, &|| format!("sqrt({a:?})"));
    }
    assert_eq!(DoubleDouble::from(0.0).sqrt(), DoubleDouble::from(0.0));
    assert!(DoubleDouble::from(-1.0).sqrt().round().is_nan());
}

#[test]
fn negation_is_exact() {
    for (a, _) in wide_pairs() {
        assert_eq!(exact_sum(-a), -exact_sum(a));
    }
}

#[test]
fn overflow_never_panics() {
    let huge = DoubleDouble::from(f64::MAX);
    for extended in
        [huge + huge, huge * huge, huge * 2.0, huge - f64::MIN, DoubleDouble::two_product(f64::MAX, f64::MAX)]
    {
        assert!(!extended.round().is_finite());
    }
}
