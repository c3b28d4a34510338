//! A worksheet with mistakes: one run tells all of them, with their places, and how many formulas would be fine.

mod common;

use common::{closedform, fails, repository, succeeds, turn};
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
    fs::write(&input, "good(x) := x^2+1$\nfor i thru n do print(i)$\n").unwrap();
    let said = fails(&repository(), &["generate", "--strict", "--input", input.to_str().unwrap(), "--out", written]);
    for words in ["line 2: passed over: a loop", "1 statement of the worksheet would be passed over"] {
        assert!(!out.exists() && said.contains(words), "`{words}` is not in {said}");
    }
}

#[test]
fn what_the_algebra_refuses_stops_no_other_formula() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("my.mac"), folder.path().join("mine"));
    let text = "good(x) := x^2+1$\nnowhere(x) := 1/(x-x)+1$\nopen(a,b) := positive_root(z^2-a*z-b,z)$\n";
    fs::write(&input, text).unwrap();
    let [input, written] = [&input, &out].map(|path| path.to_str().unwrap());
    let output = closedform(&repository(), &["generate", "--input", input, "--out", written]);
    let said = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(output.status.success(), "{said}");
    for words in
        ["passed over:", "my.mac:2:1: kernel `my::nowhere` has an empty domain", "my.mac:3:1: kernel `my::open`"]
    {
        assert!(said.contains(words), "`{words}` is not in {said}");
    }
    let made = fs::read_to_string(out.join("src/generated/my.rs")).unwrap();
    assert!(made.contains("pub fn good") && !made.contains("nowhere"), "{made}");
    let said = fails(&repository(), &["generate", "--strict", "--input", input, "--out", written]);
    assert!(said.contains("kernel `my::nowhere` has an empty domain") && said.contains("1 other kernel would be fine"));
}

#[test]
fn a_folder_becomes_one_crate() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("sheets"), folder.path().join("mine"));
    fs::create_dir(&input).unwrap();
    for (name, text) in [
        ("a b.mac", "f(x) := x^2$"),
        ("cores.fpcore", "(FPCore g (x) :pre (> x 0) (/ 1 x))"),
        ("none.mac", "f(x) := erf(x)$"),
        ("notes.txt", "no worksheet"),
        ("two.wxm", "/* [wxMaxima: input start ] */\nh: x+1$\n/* [wxMaxima: input end ] */\n"),
    ] {
        fs::write(input.join(name), text).unwrap();
    }
    let [input, written] = [&input, &out].map(|path| path.to_str().unwrap());
    let output = closedform(&repository(), &["generate", "--input", input, "--out", written]);
    let said = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        output.status.success() && said.contains("3 of 4 worksheets are modules") && said.contains("`erf`"),
        "{said}"
    );
    let index = fs::read_to_string(out.join("src/generated/mod.rs")).unwrap();
    for kernel in ["a_b::f", "cores::g", "two::h"] {
        assert!(index.contains(&format!("&{kernel}::KERNEL")), "{kernel} is not in {index}");
    }
}

#[test]
fn a_worksheet_that_computes_is_derived_and_generated() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (input, out) = (folder.path().join("calc.mac"), folder.path().join("mine"));
    fs::write(&input, "s: solve(a*x^2 = b, x)$\nroot: rhs(s[2])$\narea(r) := integrate(2*t, t, 0, r)$\n").unwrap();
    let [input, written] = [&input, &out].map(|path| path.to_str().unwrap());
    let said = fails(&repository(), &["generate", "--input", input, "--out", written]);
    assert!(said.contains("calls `solve`") && said.contains("closedform derive FILE"), "{said}");
    let derived = succeeds(&repository(), &["derive", input]);
    assert!(derived.contains("3 names with a value"), "{derived}");
    let table = succeeds(&repository(), &["generate", "--input", input, "--out", written]);
    for kernel in ["calc::s", "calc::root", "calc::area"] {
        assert!(table.contains(kernel), "{kernel} is not in {table}");
    }
}
