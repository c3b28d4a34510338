//! Printing and parsing undo each other, and no text makes the parser panic.

mod support;

use closedform_maxima::{definitions, parse_expression, parse_statements, print, print_statement, to_latex};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn parse_undoes_print(expression in support::expression()) {
        let text = print(&expression);
        let parsed = parse_expression(&text).map_err(|error| TestCaseError::fail(format!("{text}: {error}")))?;
        prop_assert_eq!(&parsed, &expression, "{}", text);
        prop_assert_eq!(print(&parsed), text);
    }

    #[test]
    fn parentheses_are_minimal(expression in support::expression()) {
        let text = print(&expression);
        for (open, close) in parentheses(&text) {
            let mut shorter = text.clone();
            shorter.replace_range(close..=close, " ");
            shorter.replace_range(open..=open, " ");
            prop_assert!(parse_expression(&shorter).as_ref() != Ok(&expression), "{} needs no parentheses", text);
        }
    }

    #[test]
    fn braces_of_latex_balance(expression in support::expression()) {
        let latex = to_latex(&expression).replace(r"\{", "").replace(r"\}", "").replace(r"\backslash", "");
        prop_assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{}", latex);
        prop_assert_eq!(latex.matches(r"\left").count(), latex.matches(r"\right").count(), "{}", latex);
    }

    #[test]
    fn garbage_never_panics(text in "\\PC{0,60}") {
        read(&text);
    }

    #[test]
    fn garbage_of_tokens_never_panics(words in prop::collection::vec(prop::sample::select(WORDS), 0..40)) {
        read(&words.concat());
        read(&words.join(" "));
    }
}

const WORDS: &[&str] = &[
    "(", ")", "[", "]", "{", "}", "+", "-", "*", "/", "^", "^^", ".", "!", "!!", "'", "''", ":", "::", ":=", "::=",
    "=", "#", "<", "<=", ">", ">=", "@", ",", ";", "$", "and", "or", "not", "if", "then", "else", "elseif", "for",
    "from", "in", "step", "next", "thru", "while", "unless", "do", "x", "f", "1", "1.5", "1e", "1b3", "\"s\"", "\"",
    "/*", "*/", "\\", "\\\n", "?", "(%i1)", "\n", "é", "·",
];

/// Reads text in every way, and what was read once more.
fn read(text: &str) {
    let _ = definitions(text);
    if let Ok(expression) = parse_expression(text) {
        assert_eq!(parse_expression(&print(&expression)).as_ref(), Ok(&expression), "{text}");
    }
    let Ok(statements) = parse_statements(text) else { return };
    for statement in statements {
        let again = parse_statements(&print_statement(&statement)).expect("printed statements parse");
        assert_eq!(again.first().map(|again| &again.expression), Some(&statement.expression), "{text}");
    }
}

/// The places of parentheses around an expression; not of argument lists, and not of `(a!)!`, where a blank would do.
fn parentheses(text: &str) -> Vec<(usize, usize)> {
    let (mut open, mut pairs) = (Vec::new(), Vec::new());
    for (place, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => return Vec::new(), // brackets inside strings are none
            b'(' => open.push(place),
            b')' => pairs.extend(open.pop().map(|start| (start, place))),
            _ => {}
        }
    }
    let applied = |start| text[..start].ends_with(|c: char| c.is_alphanumeric() || ")]}'_".contains(c));
    pairs.into_iter().filter(|&(start, end)| !applied(start) && !text[end..].starts_with(")!")).collect()
}

/// Text that nests `count` times.
fn nested(open: &str, count: usize, middle: &str, close: &str) -> String {
    format!("{}{middle}{}", open.repeat(count), close.repeat(count))
}

#[test]
fn depth_is_an_error() {
    for (open, close) in
        [("(", ")"), ("[", "]"), ("-", ""), ("f(", ")"), ("'", ""), ("a^", ""), ("do ", ""), ("not ", ""), ("a:", "")]
    {
        let error = parse_expression(&nested(open, 100_000, "x", close)).expect_err(open);
        assert_eq!(error.to_string(), "nested deeper than 256 levels", "{open}");
        parse_expression(&nested(open, 200, "x", close)).expect(open);
    }
    parse_expression(&nested("(", 100_000, "", "")).expect_err("unclosed");
}

#[test]
fn length_is_an_error() {
    for link in ["+x", "!", "(x)", "[1]", " and x"] {
        let error = parse_expression(&format!("x{}", link.repeat(100_000))).expect_err(link);
        assert_eq!(error.to_string(), "more than 1024 operators in a row", "{link}");
    }
    let long = parse_expression(&format!("x{}", "+x^2".repeat(1000))).expect("a thousand terms");
    assert_eq!(parse_expression(&print(&long)).as_ref(), Ok(&long));
    assert!(!to_latex(&long).is_empty());
}

#[test]
fn comments_nest_without_end() {
    let text = format!("{} x {}", "/*".repeat(100_000), "*/".repeat(100_000));
    assert_eq!(parse_statements(&text), Ok(Vec::new()));
}

#[test]
fn definitions_of_odd_names_read_back() {
    let text = "f\\-1(x\\-y,2\\ z):=x\\-y+1$".replace("2\\ z", "a\\ z");
    let definitions = closedform_maxima::definitions(&text).expect("parses");
    assert_eq!(definitions[0].parameters, ["x-y", "a z"]);
    let again = closedform_maxima::definitions(&format!("{}$", definitions[0])).expect("parses again");
    assert_eq!((&again[0].name, &again[0].body), (&definitions[0].name, &definitions[0].body));
    assert_eq!(again[0].parameters, definitions[0].parameters);
}
