//! Contracts: what is read, and one clear error for each mistake.

use std::path::Path;

use super::*;
use crate::drawn::drawn;

const GOOD: &str = r#"[family]
title = "Turn-around of the step axis"
source = "2.3.1"

[inputs]
tOut = { name = "t_out", unit = "s", typical = [1e-4, 1e-1], doc = "time of the ramp out" }
a2Max = { name = "a2_max", unit = "m/s^2" }

[[kernel]]
name = "t_in"
doc = "Time of the ramp in."
source = "%o50"
inputs = ["a2Max", "tOut"]
domain = ["a2Max > 0", "tOut >= 0 or a2Max*tOut < -1"]

[[kernel.result]]
name = "t_in"
worksheet = "tInFn"
unit = "s"
"#;

/// The good contract with one text replaced.
fn with(old: &str, new: &str) -> String {
    assert!(GOOD.contains(old), "{old}");
    GOOD.replacen(old, new, 1)
}

fn report(path: &str, text: &str) -> String {
    drawn(&parse(Path::new(path), text).unwrap_err())
}

/// Checks that the one mistake is told in these words, with a caret under `place`.
#[track_caller]
fn points(text: &str, place: &str, words: &[&str]) {
    let error = parse(Path::new("turnaround.toml"), text).unwrap_err();
    let ContractError::Mistakes { mistakes, .. } = &error else { panic!("{error}") };
    let report = report("turnaround.toml", text);
    assert_eq!(mistakes.len(), 1, "{report}");
    for word in words {
        assert!(report.contains(word), "`{word}` is not in\n{report}");
    }
    let labels = miette::Diagnostic::labels(&mistakes[0]).into_iter().flatten();
    let spans: Vec<&str> = labels.map(|label| &text[label.offset()..label.offset() + label.len()]).collect();
    assert_eq!(spans.last().copied().unwrap_or_default(), place, "{report}");
}

#[test]
fn a_contract_is_read() {
    let contract = parse(Path::new("turnaround.toml"), GOOD).unwrap();
    let kernel = &contract.kernels[0];
    assert_eq!(kernel.domain.texts().collect::<Vec<_>>(), ["a2Max > 0", "tOut >= 0 or a2Max*tOut < -1"]);
    let names: Vec<&str> = contract.inputs_of(kernel).iter().map(|input| input.name.as_str()).collect();
    assert_eq!(names, ["a2_max", "t_out"]);
    assert_eq!(contract.inputs["a2Max"].typical, TYPICAL);
    assert_eq!(contract.results().map(|(_, result)| result.worksheet.as_str()).collect::<Vec<_>>(), ["tInFn"]);
}

#[test]
fn a_report_draws_its_carets() {
    let text = with("a2Max > 0", "a2Mx > 0").replace("[1e-4, 1e-1]", "[1, -1]");
    assert_eq!(report("turnaround.toml", &text), REPORT.trim_matches('\n'));
}

const REPORT: &str = r#"
  x the contract turnaround.toml has 2 mistakes

Error:
  x `typical` must be two finite magnitudes 0 < low <= high, but is [1e0, -1e0]
   ,-[turnaround.toml:6:48]
 5 | [inputs]
 6 | tOut = { name = "t_out", unit = "s", typical = [1, -1], doc = "time of the ramp out" }
   :                                                ^^^|^^^
   :                                                   `-- not a range of magnitudes
 7 | a2Max = { name = "a2_max", unit = "m/s^2" }
   `----
  help: give the range of magnitudes; signs follow from the domain

Error:
  x kernel `t_in`: the domain condition names `a2Mx`, which is not an input of this kernel
    ,-[turnaround.toml:14:12]
 13 | inputs = ["a2Max", "tOut"]
 14 | domain = ["a2Mx > 0", "tOut >= 0 or a2Max*tOut < -1"]
    :            ^^|^
    :              `-- not an input of this kernel
 15 |
    `----
  help: add it to the kernel's `inputs`, or correct its name
"#;

#[test]
fn inputs_must_be_listed() {
    let unknown = with(r#"["a2Max", "tOut"]"#, r#"["a2Max", "tOut", "t_Out"]"#);
    points(
        &unknown,
        r#""t_Out""#,
        &["kernel `t_in` takes `t_Out`, which [inputs] does not list", "did you mean `tOut`?"],
    );
    let unknown = with(r#"["a2Max", "tOut"]"#, r#"["a2Max", "tOut", "dStep"]"#);
    points(&unknown, r#""dStep""#, &["add it: dStep = { name = \"d_step\""]);
    let unused = with("[[kernel]]", "x = { name = \"x\", unit = \"m\" }\n[[kernel]]");
    points(&unused, "x", &["no kernel takes the input `x`"]);
    let twice = with(r#"["a2Max", "tOut"]"#, r#"["a2Max", "tOut", "tOut"]"#);
    points(&twice, r#""tOut""#, &["the input `tOut` occurs twice", "first here"]);
}

#[test]
fn conditions_must_be_decidable() {
    let condition = |text: &str| with("a2Max > 0", text);
    points(&condition("a2Max > z"), "z", &["names `z`, which is not an input of this kernel"]);
    points(&condition("a2Max >"), "", &["cannot be read"]);
    points(&condition("a2Max"), "a2Max", &["is not a comparison", "compare with < <= > >= = #"]);
    points(&condition("sqrt(a2Max) > 1"), "sqrt(a2Max)", &["not a rational function", "square away roots"]);
    let escaped = r"a2Max > \u007A";
    points(&condition(escaped), &format!("\"{escaped}\""), &["names `z`"]);
}

#[test]
fn results_and_structs_belong_together() {
    let second = "unit = \"s\"\n\n[[kernel.result]]\nname = \"v\"\nworksheet = \"vFn\"\nunit = \"m/s\"\n";
    let several = GOOD.trim_end().trim_end_matches("unit = \"s\"").to_owned() + second;
    points(&several, r#""t_in""#, &["kernel `t_in` has 2 results, but no `returns`", "returns = \"TIn\""]);
    let returning = |name: &str| several.replace("source = \"%o50\"", &format!("returns = \"{name}\""));
    assert!(parse(Path::new("turnaround.toml"), &returning("Ramp")).is_ok());
    points(&returning("ramp"), r#""ramp""#, &["is not an UpperCamelCase name"]);
    points(&returning("Self"), r#""Self""#, &["clashes with a name"]);
    let twice = returning("Ramp").replace("\"v\"", "\"t_in\"");
    points(&twice, r#""t_in""#, &["the result `t_in` occurs twice"]);
    let twice = returning("Ramp").replace("vFn", "tInFn");
    points(&twice, r#""tInFn""#, &["the worksheet function `tInFn` occurs twice"]);
    let needless = with("source = \"%o50\"", "returns = \"Ramp\"");
    points(&needless, r#""Ramp""#, &["has one result", "remove `returns`"]);
    let none = GOOD.split("[[kernel.result]]").next().unwrap_or_default();
    points(none, "[[kernel]]", &["kernel `t_in` has no result"]);
}

#[test]
fn names_must_be_possible_in_rust_and_maxima() {
    points(&with("\"t_in\"", "\"gen\""), r#""gen""#, &["`gen` is a Rust keyword"]);
    points(&with("\"t_in\"", "\"tIn\""), r#""tIn""#, &["`tIn` is not a snake_case name"]);
    points(&with("\"t_in\"", "\"f64\""), r#""f64""#, &["`f64` clashes with a name"]);
    points(&with("\"t_out\"", "\"move\""), r#""move""#, &["`move` is a Rust keyword"]);
    points(&with("\"a2_max\"", "\"t_out\""), r#""t_out""#, &["the Rust name `t_out` occurs twice"]);
    points(&with("\"tInFn\"", "\"t-in\""), r#""t-in""#, &["`t-in` is not a name in Maxima"]);
    let twice = format!("{GOOD}{}", &GOOD[GOOD.find("[[kernel]]").unwrap_or(0)..].replace("tInFn", "other"));
    points(&twice, r#""t_in""#, &["the kernel `t_in` occurs twice"]);
    assert!(report("Turn-Around.toml", GOOD).contains("rename the worksheet and its contract, e.g. to `turn_around`"));
}

#[test]
fn values_must_make_sense() {
    for range in ["[0, 1]", "[2, 1]", "[-1, 1]", "[1, inf]", "[nan, 1]"] {
        points(&with("[1e-4, 1e-1]", range), range, &["two finite magnitudes 0 < low <= high"]);
    }
    points(&with("\"m/s^2\"", "\" \""), "\" \"", &["the unit is empty", "or \"1\" where there is none"]);
    points(
        &with("title = \"Turn-around of the step axis\"", "title = \"\""),
        "\"\"",
        &["the title of the family is empty"],
    );
    let no_inputs = with("[\"a2Max\", \"tOut\"]", "[]");
    assert!(report("turnaround.toml", &no_inputs).contains("the list of inputs is empty"));
}

#[test]
fn units_must_be_known() {
    for unit in ["kg*m/s^2", "N", "mrad", "m^(1/2)", "V/um", "deg", "%", "J/(kg*K)", "mm/s^2"] {
        let text = with("\"m/s^2\"", &format!("\"{unit}\""));
        assert!(parse(Path::new("turnaround.toml"), &text).is_ok(), "{unit}");
    }
    points(&with("\"m/s^2\"", "\"m/sec^2\""), "sec", &["`sec` is no known unit", "did you mean `s`, second?"]);
    points(&with("\"m/s^2\"", "\"furlong\""), "furlong", &["no known unit", "write 1 for what is counted"]);
    points(&with("\"m/s^2\"", "\"N m\""), "m", &["write `*` between factors"]);
}

#[test]
fn toml_mistakes_point_too() {
    points(&with("unit = \"m/s^2\"", "units = \"m\""), "units", &["unknown field `units`"]);
    points(&with(", unit = \"m/s^2\"", ""), "{ name = \"a2_max\" }", &["missing field `unit`"]);
    points(&with("title = ", "title = ="), "=", &[]);
    points(&with("[1e-4, 1e-1]", "[1e-4]"), "[1e-4]", &[]);
    points(&GOOD.replace("[[kernel", "[[kernels"), "kernels", &["unknown field `kernels`"]);
    points("[family]\ntitle = \"t\"\n", "", &["the contract has no kernel"]);
}

#[test]
fn a_missing_contract_says_so() {
    let error = load(Path::new("/nowhere/family.toml")).unwrap_err();
    assert!(error.to_string().starts_with("cannot read /nowhere/family.toml"));
}
