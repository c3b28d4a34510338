//! `SoftFloat` against the processor, where that does not over- or underflow, and against itself where it does.

use super::*;
use crate::function::Function;
use crate::real::Real;
use crate::terms::Terms;

/// Pairs of numbers of all exponents, and pairs that are close.
fn pairs() -> impl Iterator<Item = (f64, f64)> {
    let edges = [0.0, f64::from_bits(1), f64::MIN_POSITIVE, 1.0, 1.5, 3.0, 1.0 - f64::EPSILON / 2.0, 0.1, f64::MAX];
    let edges = move || edges.into_iter().flat_map(|x| [x, -x, x.next_up(), x.next_down()]).filter(|x| x.is_finite());
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state ^ state >> 29
    };
    let random = (0..40_000).map(move |round| {
        let a = random();
        let b = match round % 3 {
            0 => random(),
            1 => a ^ random() >> (12 + random() % 52),
            _ => a & !(0x7ff << 52) | (((a >> 52 & 0x7ff) + random() % 120).clamp(60, 2046) - 60) << 52,
        };
        (f64::from_bits(a), f64::from_bits(b))
    });
    edges()
        .flat_map(move |a| edges().map(move |b| (a, b)))
        .chain(random)
        .filter(|(a, b)| a.is_finite() && b.is_finite())
}

#[track_caller]
fn same(soft: SoftFloat, hardware: f64, what: &str) {
    // Neither infinity nor the sign of zero is known here.
    let found = soft.to_f64();
    assert!(found == hardware || found.is_nan() && !hardware.is_finite(), "{what}: {found:e}, not {hardware:e}");
}

#[test]
fn one_operation_rounds_as_the_processor_does() {
    for (a, b) in pairs() {
        let (x, y) = (SoftFloat::from_f64(a), SoftFloat::from_f64(b));
        same(x, a, "itself");
        same(x.add(&y), a + b, &std::format!("{a:e} + {b:e}"));
        same(x.sub(&y), a - b, &std::format!("{a:e} - {b:e}"));
        same(x.mul(&y), a * b, &std::format!("{a:e} * {b:e}"));
        same(x.div(&y), a / b, &std::format!("{a:e} / {b:e}"));
        same(x.call(Function::Sqrt), a.sqrt(), &std::format!("sqrt({a:e})"));
        assert_eq!(x.partial_cmp(&y), a.partial_cmp(&b), "{a:e}, {b:e}");
    }
}

#[test]
fn operations_undo_each_other_to_all_but_some_bits() {
    for (a, b) in pairs().filter(|(a, b)| *a != 0.0 && *b != 0.0) {
        let (x, y) = (SoftFloat::from_f64(a), SoftFloat::from_f64(b).magnitude());
        let root = y.call(Function::Sqrt);
        for (back, origin) in [(x.div(&y).mul(&y), x), (root.mul(&root), y)] {
            let error = back.sub(&origin).div(&origin).magnitude();
            assert!(error <= SoftFloat::new(false, 1, -121, false), "{a:e}, {b:e}: {:e}", error.to_f64());
        }
    }
}

#[test]
fn exponents_do_not_run_out() {
    let huge = SoftFloat::from_f64(f64::MAX);
    let tower = (0..40).fold(huge, |power, _| power.mul(&power));
    assert_eq!(tower.to_f64(), f64::INFINITY);
    assert_eq!(huge.div(&tower).to_f64(), 0.0);
    let back = (0..40).fold(tower, |power, _| power.call(Function::Sqrt));
    assert_eq!(back.to_f64(), f64::MAX);
}

#[test]
fn sums_of_numbers_beyond_f64_are_exact() {
    let number = |significand: u64, exponent| SoftFloat::new(false, significand.into(), exponent, false);
    let one = |exponent| number(1, exponent);
    // `x*y - z*w`
    let terms = Terms::of(&[2, 0, 1, 0x82, 2, 3]);
    let difference = |x, y, z, w| SoftFloat::compensated(&SoftFloat::NAN, 0.0, &[&x, &y, &z, &w], terms);
    let next = (1 << 52) + 1;
    for exponent in [-9_000, -2_000, 0, 2_000, 9_000] {
        let cancelling = difference(number(next, exponent), number(next, -52), number(next + 1, exponent), one(0));
        assert_eq!(cancelling, one(exponent - 52), "2^{exponent}");
        let product = number(next, exponent);
        assert_eq!(difference(product, one(100), product, one(100)), SoftFloat::ZERO, "2^{exponent}");
    }
    // farther apart than any products of f64: what the large terms leave, and nothing else where they leave something
    let terms = Terms::of(&[1, 0, 0x81, 1, 1, 2]);
    let sum = |x, y, z| SoftFloat::compensated(&SoftFloat::NAN, 0.0, &[&x, &y, &z], terms);
    assert_eq!(sum(one(90_000), one(90_000), one(-90_000)), one(-90_000));
    assert_eq!(sum(one(90_001), one(90_000), one(-90_000)), one(90_000));
    assert_eq!(sum(one(90_000), one(90_001), one(-90_000)), one(90_000).negated());
}

#[test]
fn splits_add_up() {
    let third = SoftFloat::from_f64(1.0).div(&SoftFloat::from_f64(3.0));
    let (high, low) = third.split();
    assert_eq!((high, low), (1.0 / 3.0, 1.0 / 3.0 * 0.5_f64.powi(54)));
}
