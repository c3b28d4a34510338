//! Kernels written by hand: what is proved of them, what is refused, where, and with which remedy.

use closedform_bounds::{assert_file_bounded, derive, place};
use closedform_syntax::parse_file;
use std::panic::catch_unwind;

/// The bound of a kernel in a, b, c with this body, or message and place of its first refusal.
fn bound(body: &str) -> Result<f64, (String, String)> {
    let text = format!("#[kernel]\nfn f(a: f64, b: f64, c: f64) -> f64 {{\n{body}\n}}\n");
    let kernel = &parse_file(&text).expect("kernel language")[0];
    match derive(kernel) {
        Ok(bounds) => Ok(bounds[0].ulp),
        Err(refusals) => {
            let place = place(kernel, &refusals[0]);
            Err((refusals[0].reason.to_string(), text[place.bytes].to_owned()))
        }
    }
}

#[track_caller]
fn refused(body: &str, message: &str, place: &str) {
    let (said, at) = bound(body).expect_err(body);
    assert!(said.contains(message), "{message:?} is not said of\n{body}\nbut: {said}");
    assert_eq!(at, place, "{body}");
}

#[test]
fn divisors_that_may_be_zero_are_refused() {
    refused("a / b", "say `require!(b != 0.0)`", "b");
    refused("require!(b >= 0.0); a / b", "say `require!(b != 0.0)`", "b");
    refused("a / (b - c)", "say `require!(b - c != 0.0)`", "b - c");
    refused("a / compensated!(b * b - c)", "say `require!(compensated!(b * b - c) != 0.0)`", "b * b - c");
    refused("let d = b; a / d", "what of the inputs keeps it from that", "d");
    refused("let d = a / b; 2.0 * d", "say `require!(b != 0.0)`", "b");
    refused("if b >= 0.0 { a / b } else { a }", "may be zero", "b");
    refused("a / max(b, c)", "may be zero", "b, c");
    refused("1.0 / (a * a)", "may be zero", "a * a");
    refused("require!(a / b > 0.0); a", "say `require!(b != 0.0)`", "b");
}

#[test]
fn divisors_that_are_never_zero_are_proved() {
    for body in [
        "require!(b != 0.0); a / b",
        "require!(b > 0.0); a / b",
        "require!(b < 0.0 || b > 1.0); a / b",
        "a / max(b, 1e-300)",
        "require!(c > 0.0); a / max(b, c)",
        "a / min(b, -1.0)",
        "if b != 0.0 { a / b } else { 0.0 }",
        "let d = a / b; if b > 0.0 { d } else { 0.0 }",
        "require!(b > 0.0); let d = if c > 0.0 { b } else { -b }; a / d",
        "a / 3.0",
    ] {
        assert_eq!(bound(body), Ok(0.5), "{body}");
    }
    assert_eq!(bound("require!(b - c != 0.0); a / (b - c)"), Ok(2.0));
    assert_eq!(bound("require!(b > c); a / (b - c)"), Ok(2.0));
    assert!(bound("a / (b * b + 1.0)").is_ok());
    let within = "require!(b >= -30.0); require!(b <= 50.0); require!(c > -100.0); require!(c < 100.0);";
    assert!(bound(&format!("{within} a / compensated!(331.4 + 0.6 * b + c)")).is_ok(), "a box");
    assert!(bound(&format!("{within} a / compensated!(118.0 + 0.6 * b + c)")).is_ok(), "zero in its corner, left out");
    refused(
        &format!("{within} a / compensated!(117.0 + 0.6 * b + c)"),
        "say `require!(compensated!(117.0 + 0.6 * b + c) != 0.0)`",
        "117.0 + 0.6 * b + c",
    );
    assert!(bound("require!(b >= 0.0); require!(c > 0.0); a / (sqrt(b) + c)").is_ok());
}

#[test]
fn integers_of_exact_numbers_are_exact_and_others_are_refused() {
    assert_eq!(bound("floor(a) - 1.5"), Ok(0.5));
    assert_eq!(
        bound("let n = round(-a); if n > b { compensated!(a - n * b) } else { truncate(ceiling(c)) }"),
        Ok(0.51)
    );
    assert!(bound("require!(a >= 2.5); 1.0 / (1.0 + abs(floor(a)))").is_ok());
    refused("floor(a + b)", "rounding may carry the argument of `floor(a + b)` over a step", "a + b");
    refused("require!(a >= 0.0); round(sqrt(a))", "say `precision = \"certified\"`", "a");
    // it may be zero, as that of a number above zero may be
    refused("require!(a > 0.0); b / floor(a)", "may be zero", "a");
    assert!(bound("require!(a > 0.0); b / ceiling(a)").is_ok());
}

#[test]
fn roots_of_what_may_be_negative_are_refused() {
    refused("sqrt(a)", "say `require!(a >= 0.0)`", "a");
    refused("sqrt(a - b)", "say `require!(a - b >= 0.0)`", "a - b");
    refused("let d = a; sqrt(d)", "what of the inputs keeps it from that", "d");
    refused("if a >= b { sqrt(b - a) } else { 0.0 }", "may be negative", "b - a");
    refused("require!(sqrt(a) != 0.0); a", "say `require!(a >= 0.0)`", "a");
    refused("sqrt(min(a, 1.0))", "may be negative", "a, 1.0");
}

#[test]
fn roots_of_what_is_never_negative_are_proved() {
    for body in
        ["require!(a >= 0.0); sqrt(a)", "sqrt(abs(a))", "sqrt(max(a, 0.0))", "if a > 0.0 { sqrt(a) } else { 0.0 }"]
    {
        assert_eq!(bound(body), Ok(0.5), "{body}");
    }
    assert!(bound("require!(a > b); sqrt(a - b)").is_ok());
    assert!(bound("sqrt(a * a + b * b)").is_ok());
    // a quotient has the sign of the product
    let of_product =
        |comparison: &str| bound(&format!("require!(b != 0.0); require!(a * b {comparison} 0.0); sqrt(a / b)"));
    assert!(of_product(">=").is_ok() && of_product("<=").is_err() && of_product("!=").is_err());
}

#[test]
fn positive_roots_need_one_change_of_sign() {
    assert_eq!(bound("require!(a > 0.0); require!(b > 0.0); positive_root([-a, c, b])"), Ok(0.51));
    for body in [
        "positive_root([-a, b])",
        "require!(a > 0.0); positive_root([-a, b])",
        "require!(a > 0.0); require!(b > 0.0); positive_root([a, b])",
        "require!(a >= 0.0); require!(b > 0.0); positive_root([-a, b])",
        "require!(a > 0.0); require!(b > 0.0); positive_root([-a, b, -a, b])",
    ] {
        let (said, _) = bound(body).expect_err(body);
        assert!(said.contains("may have no root, or several"), "{said}: {body}");
    }
}

#[test]
fn what_is_rounded_is_refused_with_its_place() {
    refused("let s = 3.0 * a; compensated!(s * b - c)", "takes `s` for exact", "s * b - c");
    refused("require!(a * b - c >= 0.0); a", "rounding may turn `a * b - c >= 0.0`", "a * b - c >= 0.0");
    refused("let d = a * b; d * d - c", "may cancel", "d * d - c");
    refused("residual!(a * b - c)", "no bound of its own", "a * b - c");
}

/// What the test of a file with this text says.
fn said_of(name: &str, text: &str) -> Result<(), String> {
    let folder = std::env::temp_dir();
    let file = format!("closedform-bounds-{}-{name}.rs", std::process::id());
    std::fs::write(folder.join(&file), text).expect("a file");
    let said = catch_unwind(|| assert_file_bounded(&folder.to_string_lossy(), &file));
    std::fs::remove_file(folder.join(&file)).expect("the file");
    said.map_err(|panic| panic.downcast_ref::<String>().cloned().unwrap_or_default())
}

#[test]
fn a_file_is_held_to_its_bounds() {
    assert_eq!(said_of("exact", "#[kernel]\nfn f(a: f64) -> f64 { a }"), Ok(()), "nothing is stated");
    assert_eq!(said_of("open", "#[kernel]\nfn f(a: f64, b: f64) -> f64 { a / b }"), Ok(()), "nothing is stated");
    let said = |name: &str, text: &str| said_of(name, text).expect_err(text);
    let lie = said("lie", "\n#[kernel(bound = 0.5)]\nfn f(a: f64, b: f64) -> f64 {\n    a * a - b\n}\n");
    for part in [".rs:4:5: kernel `f`", "may cancel", "4 |     a * a - b\n  |     ^^^^^^^^^"] {
        assert!(lie.contains(part), "{part:?} is not in\n{lie}");
    }
    let uncertified = said("uncertified", "#[kernel(bound = 0.5)] fn f(a: f64) -> f64 { 3.0 * a }");
    assert!(uncertified.contains("no certificate"), "{uncertified}");
    assert!(uncertified.contains("proved is `bound = 0.5, certificate = \"1-"), "{uncertified}");
    assert!(said("none", "fn f() {}").contains("no `#[kernel]` function"));
    assert!(said("method", "#[kernel] fn f(a: f64) -> f64 { a.sin() }").contains(".rs:1:33: methods"));
}
