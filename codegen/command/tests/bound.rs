//! `closedform bound` on hand-written files: what it prints, what it enters, and what it leaves alone.

mod common;

use common::{fails, succeeds};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const LIE: &str = "#[kernel(bound = 0.5)]
pub fn lie(a: f64, b: f64) -> f64 {
    require!(a > 0.0);
    require!(b > 0.0);
    (a + 1.0) * (a + 1.0) - b * b - 2.0 * a
}
";

const GOOD: &str =
    "//! Mine.\n\nmod inner {\n    /// Third.\n    #[kernel]\n    pub fn third(a: f64) -> f64 { a / 3.0 }\n}\n
#[kernel(
    family = \"mine\", // whose
)]
fn ends(a: f64) -> Ends {
    require!(a >= 0.0);
    Ends { low: -a, high: PI * sqrt(a) }
}
";

fn file(text: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.rs");
    fs::write(&path, text).unwrap();
    (folder, path)
}

fn names(folder: &Path) -> Vec<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn bounds_are_printed_and_nothing_is_written() {
    let (folder, path) = file(GOOD);
    let said = succeeds(folder.path(), &["bound", "mine.rs"]);
    for line in
        ["mine.rs:6: third: at most 0.5 ulp, not stated", "ends, low: at most 0 ulp", "ends, high: at most 3 ulp"]
    {
        assert!(said.contains(line), "{line:?} is not in\n{said}");
    }
    assert_eq!(fs::read_to_string(path).unwrap(), GOOD);
}

#[test]
fn bounds_are_entered_and_stay() {
    let (folder, path) = file(GOOD);
    succeeds(folder.path(), &["bound", "--write", "mine.rs"]);
    let written = fs::read_to_string(&path).unwrap();
    assert!(written.contains("    #[kernel(bound = 0.5, certificate = \"1-"), "{written}");
    assert!(written.contains("\"mine\",\n    bound(low = 0.0, high = 3.0),\n    certificate = \"1-"), "{written}");
    assert!(written.contains(", // whose\n)]"), "{written}");
    let said = succeeds(folder.path(), &["bound", "--write", "mine.rs"]);
    assert_eq!(said.matches("as stated").count(), 3, "{said}");
    assert_eq!(fs::read_to_string(&path).unwrap(), written, "a second run changes nothing");
    assert_eq!(names(folder.path()), ["mine.rs"]);
}

#[test]
fn a_changed_kernel_asks_for_a_new_proof() {
    let (folder, path) = file(GOOD);
    succeeds(folder.path(), &["bound", "--write", "mine.rs"]);
    common::edit(&path, "a / 3.0", "a / 7.0");
    let said = fails(folder.path(), &["bound", "mine.rs"]);
    assert!(said.contains("the kernel has changed since its bound was proved"), "{said}");
    succeeds(folder.path(), &["bound", "--write", "mine.rs"]);
    succeeds(folder.path(), &["bound", "mine.rs"]);
}

#[test]
fn a_bound_that_is_made_up_is_refused_with_its_place_and_taken_out() {
    let text = format!("{LIE}{GOOD}");
    let (folder, path) = file(&text);
    for part in
        ["lie: no bound is proved", "may cancel", "write it as `compensated!`", "mine.rs:5:6", "third: at most 0.5"]
    {
        let said = fails(folder.path(), &["bound", "mine.rs"]);
        assert!(said.contains(part), "{part:?} is not in\n{said}");
    }
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    fails(folder.path(), &["bound", "--write", "mine.rs"]);
    let written = fs::read_to_string(&path).unwrap();
    assert!(written.starts_with(&LIE.replace("(bound = 0.5)", "")), "{written}");
    assert!(written.contains("#[kernel(bound = 0.5, certificate"), "the others are entered: {written}");
}

#[test]
fn what_is_no_file_of_kernels_is_said_so() {
    let cases = [
        ("fn f() {}", "no `#[kernel]` function in mine.rs"),
        ("fn f( {", "not Rust"),
        ("#[kernel] fn f(a: f64) -> f64 { a.sin() }", "methods are not part"),
        ("#[kernel] fn f(a: f32) -> f64 { 1 }", "inputs are `f64`"),
    ];
    for (text, message) in cases {
        let (folder, path) = file(text);
        let said = fails(folder.path(), &["bound", "--write", "mine.rs"]);
        assert!(said.contains(message), "{message:?} is not in\n{said}");
        assert_eq!(fs::read_to_string(path).unwrap(), text);
    }
    let (folder, _) = file("");
    assert!(fails(folder.path(), &["bound", "other.rs"]).contains("cannot read other.rs"));
}
