//! Certificates: what they stand for, and what they do not depend on.

use closedform_syntax::{RULES, certificate, certified, parse_file};

const KERNEL: &str = "#[kernel(bound = 0.5)] fn f(a: f64, b: f64) -> f64 { require!(b > 0.0); let c = a; c / b }";

fn of(text: &str) -> String {
    certificate(&parse_file(text).expect("kernel language")[0])
}

#[test]
fn what_is_proved_makes_the_certificate() {
    let changes = [
        ("a: f64, b: f64", "b: f64, a: f64"),
        ("b > 0.0", "b >= 0.0"),
        ("let c = a;", "let c = b;"),
        ("c / b", "c / a"),
        ("c / b", "(c / b)  + 1.0"),
        ("0.5", "0.51"),
        ("bound = 0.5", "bound = 0.5, precision = \"double-double\""),
        ("0.0", "1e-300"),
    ];
    for (from, to) in changes {
        assert!(KERNEL.contains(from), "{from}");
        assert_ne!(of(KERNEL), of(&KERNEL.replace(from, to)), "{from} as {to}");
    }
    let two = "#[kernel(bound(x = 0.0, y = 0.5))] fn f(a: f64) -> P { P { x: a, y: 3.0 * a } }";
    assert_ne!(of(two), of(&two.replace("y", "z")));
}

#[test]
fn what_no_proof_reads_does_not_make_it() {
    let changes = [
        ("c / b", "/* by */ (c)\n  / b"),
        ("b > 0.0", "b > 0.0, \"b must be positive\""),
        ("fn f", "pub fn another"),
        ("#[kernel(", "/// What it is.\n#[kernel(family = \"mine\", rules(\"one\"), "),
        ("a: f64", "#[input(unit = \"m\")] a: f64"),
        ("0.5", "0.50"),
        ("0.5", "5e-1"),
    ];
    for (from, to) in changes {
        assert!(KERNEL.contains(from), "{from}");
        assert_eq!(of(KERNEL), of(&KERNEL.replace(from, to)), "{from} as {to}");
    }
}

#[test]
fn bounds_need_theirs() {
    let said = |text: &str| certified(&parse_file(text).expect("kernel language")[0]).map_err(|e| e.to_string());
    let with = |certificate: &str| KERNEL.replace("0.5", &format!("0.5, certificate = {certificate:?}"));
    let right = of(KERNEL);
    assert_eq!(said(&with(&right)), Ok(()));
    assert_eq!(said("#[kernel] fn f(a: f64) -> f64 { a }"), Ok(()));
    let refused = [
        (KERNEL.to_owned(), "carries no certificate"),
        (with(&right).replace("c / b", "a / b"), "has changed"),
        (with(&right).replace("0.5", "0.4"), "has changed"),
        (with(&format!("{}-{}", RULES + 1, &right[2..])), "another version"),
        (with("proved"), "no certificate"),
        (with(&right[..right.len() - 1]), "no certificate"),
        (with(&right).replace("bound = 0.5, ", ""), "of no bound"),
    ];
    for (text, message) in refused {
        let said = said(&text).expect_err(&text);
        assert!(said.contains(message), "{said}: {text}");
    }
}
