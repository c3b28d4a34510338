//! Results that `f64` cannot hold, and steps that it cannot.

use closedform::{CallError, RangeReason, ValueError, kernel};

/// Its square may leave the range where it does not.
#[kernel]
pub fn quotient(a: f64, b: f64) -> f64 {
    a / (b * b)
}

/// Terms that cancel, of three factors.
#[kernel]
pub fn cubes(a: f64, b: f64) -> f64 {
    compensated!((a - b) * (a + b) * a - b * b * b)
}

/// Reproducible numbers of all exponents, subnormal ones among them, and some of few bits near each other.
fn extremes(count: usize) -> Vec<f64> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let random = std::iter::repeat_with(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from_bits(state ^ state >> 29)
    });
    let special = [0.0, -0.0, 1.0, 3.0, f64::MIN_POSITIVE, f64::from_bits(1), f64::MAX, 1e155, 1e154, 1e-108, 1e-107];
    special.into_iter().chain(random.filter(|number| number.is_finite())).take(count).collect()
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

#[test]
fn checked_never_returns_what_is_no_number() {
    let numbers = extremes(3000);
    let mut lost = 0;
    for window in numbers.windows(2) {
        let (mut results, mut plain) = ([0.0], [0.0]);
        cubes::KERNEL.eval(window, &mut plain).unwrap();
        match cubes::KERNEL.checked(window, &mut results) {
            Ok(()) => assert!(results[0].is_finite() && same(results[0], plain[0]), "{window:?}: {results:?}"),
            Err(CallError::Range(error)) => {
                assert!(same(error.rounded(), plain[0]), "{error}");
                lost += 1;
            }
            Err(other) => panic!("{other}"),
        }
    }
    assert!(lost > 100, "{lost}");
}

#[test]
fn a_result_that_f64_cannot_hold_is_named() {
    let reason = |a: f64, b: f64| match quotient::checked(a, b) {
        Err(ValueError::Range(error)) => Some((error.result(), error.reason())),
        Err(other) => panic!("{other}"),
        Ok(_) => None,
    };
    assert_eq!(reason(1e200, 1e-200), Some(("quotient", RangeReason::Overflow)));
    assert_eq!(reason(1e-200, 1e200), Some(("quotient", RangeReason::Underflow)));
    assert_eq!(reason(1.0, 0.0), Some(("quotient", RangeReason::Undefined)));
    assert_eq!(reason(0.0, 1e-163), None);
    assert_eq!(quotient::checked(0.0, 1e-163), Ok(0.0));
    assert_eq!(quotient(1e200, 1e-200), f64::INFINITY);
    assert_eq!(quotient(1e-200, 1e200), 0.0);
    assert!(quotient(1.0, 0.0).is_nan() && quotient::faithful(1.0, 0.0).is_nan());
    let text = quotient::checked(1e200, 1e-200).unwrap_err().to_string();
    let expected =
        "quotient: the result `quotient` is beyond the largest f64 for a = 1e200, b = 1e-200; take other units";
    assert_eq!(text, expected);
    assert!(quotient::checked(1.0, 0.0).unwrap_err().to_string().ends_with("exclude such inputs by a `require!`"));
}
