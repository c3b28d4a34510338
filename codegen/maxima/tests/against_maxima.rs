//! Maxima itself reads every text as this crate does.
//!
//! The crate's reading is handed over as Lisp, which leaves nothing to precedence, and compared with what Maxima's own
//! parser makes of the text. One Maxima process answers for all texts.

mod lisp;
mod support;

use std::io::Write;
use std::process::{Command, Stdio};

use closedform_maxima::{Expr, parse_expression, print};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

/// Texts that both must accept and read alike.
const ACCEPTED: &str = include_str!("against_maxima/accepted.txt");

/// Texts that both must refuse.
const REFUSED: &str = include_str!("against_maxima/refused.txt");

/// What Maxima defines before it reads: its parser, and trees without the marks that differ by spelling only.
const PREAMBLE: &str = include_str!("against_maxima/preamble.lisp");

/// Whether Maxima is there. It must be where `CI` is set.
fn maxima_is_here() -> bool {
    let here = Command::new("maxima").arg("--version").output().is_ok_and(|output| output.status.success());
    assert!(here || std::env::var_os("CI").is_none(), "install Maxima: CI compares with it");
    if !here {
        println!("skipped: Maxima is not installed");
    }
    here
}

/// The lines that Maxima prints when it loads the Lisp program.
fn run(program: &str) -> Vec<String> {
    let path = std::env::temp_dir().join(format!("closedform-maxima-{}-{}.lisp", std::process::id(), program.len()));
    std::fs::write(&path, program).expect("temporary files can be written");
    let mut maxima = Command::new("maxima")
        .arg("--very-quiet")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("Maxima starts");
    let command = format!("load(eval_string)$\n:lisp (load \"{}\")\nquit()$\n", path.display());
    maxima.stdin.take().expect("piped").write_all(command.as_bytes()).expect("Maxima reads");
    let output = maxima.wait_with_output().expect("Maxima ends");
    std::fs::remove_file(&path).expect("temporary files can be removed");
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

fn texts(file: &str) -> Vec<&str> {
    file.lines().filter(|line| !line.is_empty()).collect()
}

/// Asks Maxima about every text; the texts that it reads otherwise than the expression beside it.
fn disagreements(cases: &[(String, Expr)]) -> Vec<String> {
    let mut program = PREAMBLE.to_owned();
    for (index, (text, expression)) in cases.iter().enumerate() {
        program += &format!("(compare-reading {index} {} '{})\n", lisp::string(text), lisp::tree(expression));
    }
    let answers = run(&program);
    let asked = cases.iter().enumerate();
    let wrong = asked.filter(|(index, _)| !answers.contains(&format!("case {index} same")));
    wrong.map(|(index, (text, _))| format!("{text}\n  {}", answer_to(index, &answers))).collect()
}

fn answer_to(index: usize, answers: &[String]) -> &str {
    let answer = answers.iter().find(|line| line.starts_with(&format!("case {index} ")));
    answer.map_or("no answer", String::as_str)
}

fn assert_agreement(cases: &[(String, Expr)]) {
    let disagreements = disagreements(cases);
    assert!(disagreements.is_empty(), "Maxima reads otherwise:\n{}", disagreements.join("\n"));
}

#[test]
fn accepted_texts_are_read_alike() {
    if !maxima_is_here() {
        return;
    }
    let parse = |text: &str| parse_expression(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let cases: Vec<_> = texts(ACCEPTED).into_iter().map(|text| (text.to_owned(), parse(text))).collect();
    assert_agreement(&cases);
    let printed: Vec<_> = cases.into_iter().map(|(_, expression)| (print(&expression), expression)).collect();
    assert_agreement(&printed);
}

#[test]
fn refused_texts_are_refused_by_both() {
    for text in texts(REFUSED) {
        parse_expression(text).expect_err(text);
    }
    if !maxima_is_here() {
        return;
    }
    let mut program = PREAMBLE.to_owned();
    for (index, text) in texts(REFUSED).into_iter().enumerate() {
        program += &format!("(refuse-reading {index} {})\n", lisp::string(text));
    }
    let answers = run(&program);
    for (index, text) in texts(REFUSED).into_iter().enumerate() {
        assert!(answers.contains(&format!("case {index} refused")), "Maxima accepts {text}");
    }
}

#[test]
fn random_expressions_print_as_maxima_reads_them() {
    if !maxima_is_here() {
        return;
    }
    let mut runner = TestRunner::deterministic();
    let strategy = support::expression();
    let random = || strategy.new_tree(&mut runner).expect("an expression").current();
    let printed = std::iter::repeat_with(random).map(|expression| (print(&expression), expression));
    let evaluates = |text: &str| text.contains("''"); // at reading time
    let cases: Vec<_> = printed.filter(|(text, _)| !evaluates(text)).take(1500).collect();
    assert_agreement(&cases);
}
