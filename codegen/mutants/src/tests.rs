//! Mutants of small kernels: how many there are, that judges find them, and that a weak judge does not.

use super::*;
use closedform_measure::catalogue::{Catalogue, Entry, fixture};

/// No points beyond a few, and no attack.
const WEAK: Effort = Effort { points: 1, attack: NONE, doubt: NONE };
const NONE: Attack = Attack { edges: 0, double_zeros: 0, climbs: 0, steps: 0 };

/// A kernel of this body and one of this reference.
fn kernel(attributes: &str, inputs: &str, body: &str) -> (tempfile::TempDir, Catalogue) {
    let folder = tempfile::tempdir().unwrap();
    let source = format!("#[kernel(family = \"hand\", {attributes})]\npub fn f({inputs}) -> f64 {{\n{body}\n}}\n");
    std::fs::write(folder.path().join("hand.rs"), source).unwrap();
    let catalogue = Catalogue::load(folder.path()).unwrap();
    (folder, catalogue)
}

fn outcome(entry: &Entry, effort: Effort) -> Outcome {
    examine(entry, &Lists::default(), effort, 1).unwrap()
}

fn survivors(outcome: &Outcome) -> Vec<String> {
    outcome.survivors().map(|change| change.is.clone()).collect()
}

const ROOT: (&str, &str, &str) = (
    "maxima = \"f(a,b):=sqrt(a^2-b)\", bound = 1.51",
    "#[input(unit = \"s\", typical(0.001, 1000.0))] a: f64, #[input(unit = \"s^2\", typical(0.001, 1000.0))] b: f64",
    "require!(b > 0.0, \"b > 0\");\n\
     require!(compensated!(a * a - b) >= 0.0, \"a^2-b >= 0\");\n\
     let square = compensated!(a * a - b);\n\
     sqrt(square)",
);

#[test]
fn every_kind_of_mistake_is_made() {
    let (_folder, catalogue) = kernel(ROOT.0, ROOT.1, ROOT.2);
    let mutants = mutants(&catalogue.entries()[0].kernel);
    let made = |is: &str| mutants.iter().any(|mutant| mutant.change.is == is);
    for is in [
        "let square = compensated!(a * a + b);",
        "let square = compensated!(b - a * a);",
        "let square = compensated!(a * a);",
        "let square = compensated!(a - b);",
        "let square = a * a - b;",
        "let square = residual!(a * a - b);",
        "let square = -compensated!(a * a - b);",
        "require!(0.0 == 0.0);",
        "require!(b >= 0.0);",
        "require!(!(b > 0.0));",
        "require!(b > 1.0);",
        "square",
        "-sqrt(square)",
        "bound(f = 0.755)",
    ] {
        assert!(made(is), "{is} is not made of\n{:#?}", mutants.iter().map(|m| &m.change.is).collect::<Vec<_>>());
    }
    let line = mutants.iter().find(|mutant| mutant.change.was.starts_with("let square")).map(|m| m.change.line);
    assert_eq!(line, Some(5));
}

#[test]
fn judges_find_every_mistake() {
    let (_folder, catalogue) = kernel(ROOT.0, ROOT.1, ROOT.2);
    let judged = outcome(&catalogue.entries()[0], Effort::USUAL);
    assert!(judged.mutants.len() > 40, "{}", judged.mutants.len());
    assert_eq!(survivors(&judged), [""; 0]);
    let (_folder, catalogue) = fixture::catalogue();
    let plane = outcome(catalogue.find("plane::slope").unwrap(), Effort::USUAL);
    assert_eq!(survivors(&plane), [""; 0]);
}

#[test]
fn a_weak_judge_lets_mistakes_pass() {
    let (_folder, catalogue) = kernel(ROOT.0, ROOT.1, ROOT.2);
    let entry = &catalogue.entries()[0];
    let mut judge = judge::Judge::new(entry, &points::Points { list: vec![vec![3.0, 1.0]] }).unwrap();
    let passing = mutants(&entry.kernel).into_iter().filter(|mutant| !judge.kills(&mutant.kernel).unwrap());
    let passing: Vec<String> = passing.map(|mutant| mutant.change.is).collect();
    assert!(passing.iter().any(|is| is == "let square = a * a - b;"), "{passing:?}");
    assert!(passing.iter().any(|is| is == "require!(b >= 0.0);"), "{passing:?}");
    assert!(passing.iter().all(|is| is != "-sqrt(square)"), "{passing:?}");
}

#[test]
fn what_is_the_same_function_is_proved() {
    let (_folder, catalogue) = kernel(
        "maxima = \"f(x,y):=(x-y)^2\", bound = 3.0",
        "#[input(unit = \"m\", typical(1.0, 10.0))] x: f64, #[input(unit = \"m\", typical(1.0, 10.0))] y: f64",
        "let difference = x - y;\ndifference * difference",
    );
    let judged = outcome(&catalogue.entries()[0], Effort::USUAL);
    let same = judged.mutants.iter().filter(|(_, verdict)| *verdict == Verdict::Same);
    let same: Vec<&str> = same.map(|(change, _)| change.is.as_str()).collect();
    assert_eq!(same, ["let difference = y - x;", "let difference = -(x - y);", "fn(y, x)"]);
    assert_eq!(survivors(&judged), [""; 0]);
}

/// `a <= 0` is `a = 0` on a domain of `a >= 0`, and what that branch holds is compared there.
#[test]
fn branches_that_only_zero_takes_are_compared_at_zero() {
    let (_folder, catalogue) = kernel(
        "maxima = \"f(a,b):=if a<=0 then sqrt(b)-a else b\", bound = 3.0",
        "#[input(unit = \"m\", typical(0.5, 10.0))] a: f64, #[input(unit = \"m\", typical(0.5, 10.0))] b: f64",
        "require!(a >= 0.0, \"a >= 0\");\nrequire!(b >= 1.0, \"b >= 1\");\nlet half = a * b;\nif a <= 0.0 { sqrt(b) - half } else { b }",
    );
    let kernel = &catalogue.entries()[0].kernel;
    let same = mutants(kernel).into_iter().filter(|mutant| same::same_function(kernel, &mutant.kernel));
    let same: Vec<String> = same.map(|mutant| mutant.change.mistake.to_string()).collect();
    let of_result = |kind: &str| same.contains(&format!("result, {kind}"));
    for kind in ["<= as ==", "- as +", "first operand alone", "name as its root #2"] {
        assert!(of_result(kind), "{kind}: {same:?}");
    }
    for kind in ["second operand alone", "first branch alone", "second branch alone", "<= as >="] {
        assert!(!of_result(kind), "{kind}: {same:?}");
    }
}

/// Numbers below zero take the branch too where zero alone is left out.
#[test]
fn branches_that_other_numbers_take_are_not_compared_at_zero() {
    for domain in ["a != 0.0", "a <= 0.0", "b >= 1.0"] {
        let (_folder, catalogue) = kernel(
            "maxima = \"f(a,b):=if a<=0 then b-a else b\", bound = 3.0",
            "#[input(unit = \"m\", typical(0.5, 10.0))] a: f64, #[input(unit = \"m\", typical(0.5, 10.0))] b: f64",
            &format!("require!({domain}, \"..\");\nif a <= 0.0 {{ b - a }} else {{ b }}"),
        );
        let kernel = &catalogue.entries()[0].kernel;
        let turned = mutants(kernel).into_iter().find(|mutant| mutant.change.mistake.to_string() == "result, - as +");
        assert!(!same::same_function(kernel, &turned.expect("a difference to turn").kernel), "{domain}");
    }
}

#[test]
fn a_wrong_kernel_is_guilty_itself() {
    let (_folder, catalogue) = fixture::catalogue();
    let error = examine(catalogue.find("line::slope").unwrap(), &Lists::default(), WEAK, 1).unwrap_err();
    assert!(matches!(error, MutateError::Guilty { .. }), "{error}");
}
