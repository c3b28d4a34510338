//! Limits: what is just within them is read on a small stack, and what is beyond is refused by name, however deep.

use closedform_arith::limits::{MAX_HEIGHT, MAX_NESTING};
use closedform_syntax::{parse_file, sources};

fn kernel(body: &str) -> String {
    format!("#[kernel] fn f(x: f64) -> f64 {{ {body} }}")
}

fn nested(before: &str, after: &str, levels: usize) -> String {
    kernel(&format!("{}x{}", before.repeat(levels), after.repeat(levels)))
}

fn row(operator: &str, terms: usize) -> String {
    kernel(&vec!["x"; terms].join(operator))
}

fn chosen(branches: usize) -> String {
    kernel(&format!("{} else {{ x }}", vec!["if x > 1.0 { x }"; branches].join(" else ")))
}

/// The levels that are left inside a function, which takes a few itself.
const INSIDE: usize = MAX_NESTING - 4;

#[track_caller]
fn read(text: &str) {
    if let Err(error) = parse_file(text) {
        panic!("{error}: {} ..", &text[..text.len().min(100)]);
    }
}

#[track_caller]
fn refused(text: &str, message: &str) {
    let start = &text[..text.len().min(100)];
    let said = parse_file(text).expect_err(start).to_string();
    assert!(said.contains(message), "{said}: {start} ..");
}

#[test]
fn within_the_limits_everything_is_read() {
    read(&nested("(", ")", INSIDE));
    read(&nested("- ", "", INSIDE));
    read(&nested("sqrt(", ")", INSIDE));
    read(&nested("if x > 0.0 { ", " } else { 1.0 }", INSIDE / 2));
    read(&chosen(INSIDE / 2));
    read(&row(" + ", MAX_HEIGHT - 10));
    read(&row(" * ", MAX_HEIGHT - 10));
    read(&row(" * x + ", 600));
    read(&kernel(&format!("compensated!({})", vec!["x * x * x"; 900].join(" - "))));
}

#[test]
fn beyond_them_one_message_says_what_to_do() {
    for levels in [MAX_NESTING, 100_000] {
        refused(&nested("(", ")", levels), "nested deeper than 256");
        refused(&nested("- ", "", levels), "nested deeper");
        refused(&nested("-", "", levels), "nested deeper");
        refused(&nested("&", "", levels), "nested deeper");
        refused(&nested("if x > 0.0 { ", " } else { 1.0 }", levels), "nested deeper");
        refused(&chosen(levels), "nested deeper");
        refused(&nested("return ", "", levels), "nested deeper");
        refused(&nested("|x| ", "", levels), "nested deeper");
        refused(&nested("x = ", "", levels), "nested deeper");
        refused(&kernel(&format!("require!({}(x > 0.0)); x", "!".repeat(levels))), "nested deeper");
        refused(
            &kernel("x").replace("x: f64", &format!("x: {}f64{}", "Vec<".repeat(levels), ">".repeat(levels))),
            "nested",
        );
        refused(&kernel("x").replace("f64 {", &format!("{}f64 {{", "fn() -> ".repeat(levels))), "nested");
        refused(&format!("#[kernel(bound = {}1)] fn f(x: f64) -> f64 {{ x }}", "-".repeat(levels)), "nested deeper");
    }
    for terms in [MAX_HEIGHT + 2, 100_000] {
        refused(&row(" + ", terms), "more than 1024 operators");
        refused(&row(" * ", terms), "more than 1024 operators");
        refused(&row(" && ", terms), "more than 1024 operators");
        refused(&row(".", terms), "more than 1024 operators");
        refused(&row(" as ", terms), "more than 1024 operators");
        refused(&nested("", "()", terms), "more than 1024 operators");
        refused(&nested("", "?", terms), "more than 1024 operators");
    }
    let steps: String = (1..=1025).map(|step| format!("let x{step} = x; ")).collect();
    refused(&kernel(&format!("{steps} x")), "one too many");
}

#[test]
fn what_is_no_kernel_may_be_as_deep_as_it_likes() {
    let deep = format!("fn g() {{ {}{} }} {}", "(".repeat(100_000), ")".repeat(100_000), kernel("x"));
    assert_eq!(sources(&deep).expect("tokens").len(), 1);
}
