//! Errata with a real Maxima, right and doctored: a wrong verdict fails with its row, what was found, what to do.

use std::fs;

use super::*;
use closedform_project::drawn::{drawn, has};

const REPLAY: &str = "assume(v > 0)$ out1: x: 5$ kill(x)$ out1: [t = 2*s/(v+u), u < v]$ out2: (d+e)^2$ \
                      out4: sqrt(d^2-2*d+1)$ out3: solve(k^2 = w, k)$ linel: 20$ fpprintprec: 4$ display2d: true$";

const CONTRACT: &str = r#"[family]
title = "A family"
[inputs]
s = { name = "s", unit = "m" }
u = { name = "u", unit = "m/s" }
[[kernel]]
name = "time"
doc = "Time."
inputs = ["s", "u"]
[[kernel.result]]
name = "t"
worksheet = "time_of"
unit = "s"
"#;

/// A row for every verdict, all right.
const ROWS: &str = r#"[derivation]
title = "A derivation"
source = "section 1"

[[output]]
cell = "1 %o1 t"
live = "out1"
printed = '''[t = (2*s)/(u+v), u < v]'''
verdict = "equal"
example = "[s = 1/3, u = 1, v = 2]"

[[output.kernel]]
call = "time_of(s,u)"
part = [1]

[[output]]
cell = "1 %o1, again"
live = "out1[1]"
printed = '''t = (2*s/(u+v)'''
verdict = "repaired"
repair = "a parenthesis | is lost"
reads = "t = 2*s/(u+v)"

[[output]]
cell = "1 %o1, once more"
live = "out1[1]"
printed = "t = 2*s/u+v"
verdict = "garbled"
repair = "the parentheses of the denominator are lost"
reads = "t = 2*s/(u+v)"
example = "[s = 1, u = 1, v = 1]"

[[output]]
cell = "1 %o2"
live = "out2"
verdict = "elided"
reads = "d^2+2*d*e+e^2"

[[output]]
cell = "1 %o3"
live = "out3"
printed = "[k = -sqrt(w), k = sqrt(w)]"
verdict = "worksheet error"
error = "The first root is negative."
right = "[k = sqrt(w)]"
proof = ["rhs(right[1])^2 - w", "lhs(right[1]) - k"]
example = "[w = 4]"
shows = ["rhs(live[1])", "rhs(right[1])"]
"#;

/// A folder with these rows.
fn folder(rows: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let errata = folder.path().join(FOLDER);
    fs::create_dir(&errata).unwrap();
    fs::write(folder.path().join("family.toml"), CONTRACT).unwrap();
    let files = [("ORDER", "# the order\none\n"), ("one.mac", REPLAY), ("one.toml", rows)];
    files.iter().for_each(|(name, text)| fs::write(errata.join(name), text).unwrap());
    folder
}

fn judged(rows: &str) -> Result<String, VerdictError> {
    let folder = folder(rows);
    Errata::load(folder.path())?.unwrap().judge(&Maxima::default())
}

/// The page is refused with all of these words.
#[track_caller]
fn fails(rows: &str, words: &[&str]) {
    has(&drawn(&judged(rows).unwrap_err()), words);
}

/// The rows with one text replaced fail with all of these words.
#[track_caller]
fn doctored(old: &str, new: &str, words: &[&str]) {
    assert!(ROWS.contains(old), "{old}");
    fails(&ROWS.replacen(old, new, 1), words);
}

#[test]
fn a_right_scan_becomes_a_page() {
    let page = judged(ROWS).unwrap();
    assert!(page.starts_with("<!-- written by `closedform derive`"), "{page}");
    for line in [
        "| worksheet error | 1 | what the cell gives is not true; the right form is proved |",
        "| | 5 | |",
        "### 1. 1 %o3 ([one](errata/one.toml))",
        "- right: `[k=sqrt(w)]`",
        "- at: `w = 4`: **-2**, right **2** (off by 200 %)",
        "| 1 %o1 t | equal |  | 0.222222222222, 2 at `s = 1/3, u = 1, v = 2` \
         | [`family::time`](../kernels/src/generated/family.rs) |",
        "| 1 %o1, again | repaired | Read: a parenthesis \\| is lost. |  |  |",
        "| 1 %o1, once more | garbled | Read: the parentheses of the denominator are lost. \
         | 3 instead of 1 at `s = 1, u = 1, v = 1` |  |",
    ] {
        assert!(page.lines().any(|found| found == line), "`{line}` is not in\n{page}");
    }
    let folder = folder(ROWS);
    assert_eq!(listed(&page), Errata::load(folder.path()).unwrap().unwrap().stated());
}

#[test]
fn a_folder_without_scans_has_no_page() {
    let folder = tempfile::tempdir().unwrap();
    assert!(Errata::load(folder.path()).unwrap().is_none());
}

#[test]
fn what_is_not_equal_is_not_called_equal() {
    doctored(
        "(2*s)/(u+v), u < v",
        "(2*s)/(u-v), u < v",
        &[
            "1 of the verdicts",
            "one.toml has a mistake",
            "1 %o1 t: `printed` is not shown",
            "entry 1 is",
            "one.toml:8:11",
        ],
    );
    doctored("u < v]'''", "u > v]'''", &["entry 2 is `>` instead of `<`", "correct the transcription"]);
    doctored("u < v]'''", "u < v, 0]'''", &["`printed` has 3 entries, but the cell gives 2"]);
    doctored("\"equal\"", "\"repaired\"", &["1 %o1 t: the verdict is stated as `repaired`, but the facts say `equal`"]);
    doctored("\"elided\"", "\"equal\"", &["1 %o2: the verdict is stated as `equal`, but the facts say `elided`"]);
    doctored("\"worksheet error\"", "\"equal\"", &["stated as `equal`, but the facts say `worksheet error`"]);
}

#[test]
fn what_does_not_parse_never_reaches_maxima() {
    doctored(
        "(2*s)/(u+v), u < v]",
        "(2*s)/(u+v, u < v]",
        &["1 %o1 t: what is printed does not parse, and no repair is named", "name the `repair`"],
    );
    doctored("live = \"out2\"", "live = \"out2$ quit()\"", &["1 %o2: expected an operator or the end", "one.toml:35:"]);
    doctored("[w = 4]", "[w = 0.5]", &["1 %o3: an example is a list", "write e.g. [tIn = 1/50"]);
    doctored("d^2+2*d*e+e^2", "f(d) := e", &["1 %o2: a formula defines nothing", "right of `:=`"]);
}

#[test]
fn a_wrong_proof_says_what_is_left() {
    let words = ["1 %o3: term 1 of the proof is not 0: -2*w is left", "correct `right` or its proof"];
    doctored("[1])^2 - w", "[1])^2 - 3*w", &words);
    doctored("[1])^2 - w", "[1])^2 - 1/0", &["1 %o3: Maxima cannot work out term 1 of `proof`: ", "0 to a negative"]);
    doctored("proof = [\"", "shows_not = [\"", &["unknown field `shows_not`", "every key it may have"]);
    doctored("error = \"The", "# \"The", &["1 %o3: `error` is missing"]);
}

#[test]
fn an_example_must_differ() {
    doctored("rhs(live[1])", "rhs(live[2])", &["1 %o3: form 1 of `shows` and form 2 of `shows` have the same value"]);
    doctored("u = 1, v = 1", "u = 1, v = 0", &["once more: `printed` and `reads` have the same value", "choose an"]);
    doctored("[s = 1, u = 1, v = 1]", "[s = 1, u = 1]", &["once more: the example leaves no number, but"]);
    doctored("example = \"[w = 4]\"", "", &["1 %o3: `example` is missing: only an example shows"]);
}

#[test]
fn the_branch_of_a_root_is_seen_at_the_example() {
    let row = "live = \"out4\"\nscan = \"d-1\"\nverdict = \"equal\"\nexample = \"[d = 1/2]\"\n";
    let rows = format!("{ROWS}\n[[output]]\ncell = \"1 %o4\"\n{row}");
    fails(&rows, &["1 %o4: `printed` and `live` agree", "but not at the example", "another branch"]);
    doctored("lhs(right[1]) - k", "sqrt(w^2-10*w+25) - (w-5)", &["term 2 of the proof is not 0: 2.0b0 at the example"]);
}

#[test]
fn repairs_must_be_needed_and_right() {
    doctored("reads = \"t = 2*s/(u+v)\"", "reads = \"t = s/(u+v)\"", &["again: `reads` is not shown to be"]);
    doctored("'''t = (2*s/(u+v)'''", "'t = 2*s/(u+v)'", &["again: a repair is named, but the form as printed is"]);
    doctored("repair = \"a p", "# \"a p", &["again: `reads` has no place in this row: no `repair` says"]);
    doctored("reads = \"d^2+2*d*e+e^2\"", "", &["1 %o2: `reads` is missing: a row without `printed`"]);
}

#[test]
fn the_live_form_comes_from_the_replay() {
    doctored("live = \"out2\"", "live = \"(d+e)^2\"", &["1 %o2: `live` names nothing that the replay binds"]);
    doctored("live = \"out2\"", "live = \"out2/0\"", &["1 %o2: Maxima cannot work out `live`: "]);
}

#[test]
fn one_bad_row_loses_no_other() {
    let rows = ROWS.replacen("2*s)/(u+v), u", "2*s)/0, u", 1).replacen("[1])^2 - w", "[1])^2 - 2*w", 1);
    fails(&rows, &["2 of the verdicts", "2 mistakes", "1 %o1 t: Maxima cannot work out `printed`", "-w is left"]);
}

#[test]
fn kernels_are_those_of_contracts() {
    doctored("time_of(s,u)", "time_off(s,u)", &["1 %o1 t: no kernel computes `time_off`"]);
    doctored("time_of(s,u)", "time_of(s)", &["1 %o1 t: `time_of` takes 2 arguments, not 1"]);
    doctored("time_of(s,u)", "time_of", &["called as `function(argument, ..)`"]);
    doctored("part = [1]", "part = [0]", &["counted from 1"]);
}

#[test]
fn files_must_be_complete() {
    doctored("cell = \"1 %o2\"", "cell = \"1 %o3\"", &["two rows are called `1 %o3`", "first here", "again here"]);
    doctored("verdict = \"elided\"", "verdict = \"lost\"", &["unknown variant `lost`"]);
    let folder = folder(ROWS);
    fs::write(folder.path().join("errata/two.toml"), "").unwrap();
    let error = Errata::load(folder.path()).unwrap_err().to_string();
    assert!(error.contains("`two` is not listed, but two.toml is there"), "{error}");
}
