//! The judge of bounds refuses doctored kernels, and says what of them it cannot prove.

use closedform_bounds::check_text;
use closedform_tests::bounds::refusal;

use crate::bounded;

/// A kernel, what is changed in it to what, and what must be said.
type Case = (&'static str, &'static str, &'static str, &'static [&'static str]);

const CANCELS: &str = "may cancel";

fn refuse(cases: &[Case]) {
    for (kernel, from, to, expected) in cases {
        let said = refusal(bounded::TEXT, kernel, from, to);
        assert!(said.contains(&format!("kernel `{kernel}`")), "{said}");
        for text in *expected {
            assert!(said.contains(text), "`{from}` as `{to}` in `{kernel}`: {text:?} is not said in:\n{said}");
        }
    }
}

#[test]
fn right_bounds_are_proved() {
    assert_eq!(check_text(bounded::TEXT).map(|proved| proved.len()), Ok(11));
}

#[test]
fn wrong_bounds_are_refused() {
    let cases: [Case; 10] = [
        ("quotient", "bound = 6.01", "bound = 5.01", &["`quotient`", "5.01 ulp", "6.01 ulp is what"]),
        ("quotient", "bound = 6.01", "bound = 6.0", &["stated as 6 ulp"]),
        ("quotient", "bound = 6.01", "bound = 6.04", &["stated as 6.04 ulp", "to be 6.01 ulp"]),
        ("quotient", "bound = 6.01,", "", &["no bound is stated", "6.01 ulp"]),
        ("quotient", "bound = 6.01", "precision = \"double-double\", bound = 6.01", &["0.51 ulp"]),
        ("cubic", "bound = 0.51", "bound = 0.5", &["0.51 ulp is what"]),
        ("twice", "t = 0.51", "t = 0.5", &["`t`", "0.51 ulp is what"]),
        ("twice", "precision = \"double-double\"", "precision = \"double\"", &["stated as 0.51 ulp"]),
        ("roundings", "s = 1.5", "s = 1", &["`s`", "1.5 ulp is what"]),
        ("roundings", "v = 0.5", "v = 0.4", &["`v`", "0.5 ulp is what"]),
    ];
    refuse(&cases);
}

#[test]
fn sums_that_may_cancel_are_refused() {
    let cases: [Case; 6] = [
        ("quotient", "(root + 3.0", "(root - 3.0", &["`quotient`", CANCELS, "the right one not positive"]),
        ("quotient", "+ 48.0 * d", "- 48.0 * d", &["`root`", CANCELS]),
        ("length", "x * x + ", "x * y + ", &["`length`", CANCELS, "open"]),
        ("signed", "{ root + u }", "{ root - u }", &["`signed`", "root - u", CANCELS]),
        ("both_signed", "q * root + p", "q * root - p", &["`both_signed`", CANCELS]),
        ("twice", "+ 5.0 * t_in", "- 5.0 * t_in", &["`sum`", CANCELS]),
    ];
    refuse(&cases);
}

#[test]
fn dropped_compensation_is_refused() {
    let cases: [Case; 3] = [
        ("quotient", "let left = compensated!(", "let left = (", &["`left`", CANCELS]),
        ("twice", "require!(compensated!(", "require!((", &["`require!`", "rounding may turn"]),
        ("twice", "t_in * k / sum", "compensated!(k * sum)", &["`k`", "takes `sum` for exact"]),
    ];
    refuse(&cases);
}

#[test]
fn dropped_conditions_are_refused() {
    let cases: [Case; 7] = [
        ("quotient", "require!(t >= 0.0", "require!(t <= 0.0", &["`quotient`", CANCELS]),
        ("quotient", "require!(a > 0.0, \"a > 0\");", "", &["`root`"]),
        ("both_signed", "require!(r > 0.0, \"r > 0\");", "", &["`root`", "stands under a root, and may be negative"]),
        ("signed", "if u >= 0.0", "if u <= 0.0", &["`signed`", "root + u", CANCELS]),
        ("signed", "if u >= 0.0", "if e >= 0.0", &["`signed`", "root + u", CANCELS]),
        ("both_signed", "q >= 0.0) ||", "q <= 0.0) ||", &["`both_signed`", CANCELS]),
        ("cubic", "require!(d > 0.0, \"d > 0\");", "", &["`cubic`"]),
    ];
    refuse(&cases);
}

#[test]
fn more_roundings_are_refused() {
    let cases: [Case; 4] = [
        ("quotient", "2.0 * left /", "3.0 * left /", &["`quotient`", "7.01 ulp is what"]),
        ("roundings", "2.0 * root", "root / 3.0", &["`s`", "2.5 ulp is what"]),
        ("roundings", "v: x / t", "v: x * (1.0 / t)", &["`v`", "2 ulp is what"]),
        ("roundings", "sqrt(6.0 * x / a)", "sqrt(6.0 * x) / sqrt(a)", &["`t`", "3.5 ulp is what"]),
    ];
    refuse(&cases);
}

#[test]
fn wrong_corrections_of_roots_are_refused() {
    let cases: [Case; 4] = [
        ("cubic", "(a * start * start", "(3.0 * a * start * start", &["`cubic`", "the divisor is not the sum"]),
        ("cubic", "+ b) - d", "- b) - d", &["the remainder is not the polynomial"]),
        ("cubic", "start - start * (remainder", "start + start * (remainder", &["`remainder`", "no bound of its own"]),
        ("cancelling_cubic", "remainder = compensated!", "remainder = residual!", &["write `compensated!`"]),
    ];
    refuse(&cases);
}
