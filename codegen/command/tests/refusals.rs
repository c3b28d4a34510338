//! A worksheet with mistakes: one run tells all of them, with their places, and how many formulas would be fine.

mod common;

use common::{fails, repository, turn};
use std::fs;

/// What is said of a worksheet, white space folded; nothing is written.
fn refusal(worksheet: &str) -> String {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("my.mac"), folder.path().join("mine"));
    fs::write(&input, worksheet).unwrap();
    let said = fails(&repository(), &["generate", "--input", input.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert!(!out.exists(), "{said}");
    said
}

#[test]
fn mistakes_of_every_stage_are_told_together() {
    let said = refusal(
        "good(x) := x^2+1$\n\
         torn(x) := x+$\n\
         zero(x) := 1/0+x$\n\
         loose(x) := x+y$\n\
         nowhere(x) := 1/(x-x)+1$\n\
         open(a,b) := positive_root(z^2-a*z-b,z)$\n\
         sine(x) := erf(x)$\n\
         fine(x) := sqrt(x+1)-sqrt(x)$\n",
    );
    // the text; the formulas; their domains and their roots, which the algebra finds out
    for words in [
        "my.mac:2:14",
        "my.mac:3:14",
        "divides by zero",
        "my.mac:5:1",
        "has an empty domain",
        "my.mac:6:1",
        "my.mac:7:12",
        "3 other kernels would be fine",
        "nothing was generated",
    ] {
        assert!(said.contains(words), "`{words}` is not in {said}");
    }
    for fine in ["my.mac:1:", "my.mac:4:", "my.mac:8:"] {
        assert!(!said.contains(fine), "{fine} is in {said}");
    }
}

#[test]
fn formulas_that_are_fine_are_counted() {
    let said = refusal("good(x) := x^2+1$\nfor(x) := x$\nbad(do) := do^2$\n");
    for words in ["`do` is a keyword of Maxima", "my.mac:3:5", "1 other kernel would be fine", "named above"] {
        assert!(said.contains(words), "`{words}` is not in {said}");
    }
}

#[test]
fn strict_refuses_what_is_passed_over() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("my.mac"), folder.path().join("mine"));
    fs::write(&input, "good(x) := x^2+1$\nsine(x) := erf(x)$\nfor i thru 3 do print(i)$\n").unwrap();
    let [input, written] = [&input, &out].map(|path| path.to_str().unwrap());
    let said = fails(&repository(), &["generate", "--strict", "--input", input, "--out", written]);
    assert!(!out.exists() && said.contains("my.mac:2:12") && said.contains("calls `erf`"), "{said}");
    let input = folder.path().join("other.mac");
    fs::write(&input, "good(x) := x^2+1$\nfor i thru 3 do print(i)$\n").unwrap();
    let said = fails(&repository(), &["generate", "--strict", "--input", input.to_str().unwrap(), "--out", written]);
    for words in ["line 2: passed over: a loop", "1 statement of the worksheet would be passed over"] {
        assert!(!out.exists() && said.contains(words), "`{words}` is not in {said}");
    }
}
