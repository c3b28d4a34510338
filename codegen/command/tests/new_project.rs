//! A project of one's own: made new, checked, and every mistake in it found with the right words.

mod common;

use common::{closedform, edit, fails, repository, restamp, succeeds, turn};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A new project `braking` in a folder of its own.
fn made() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["new", "braking"]);
    let project = folder.path().join("braking");
    (folder, project)
}

fn cargo(folder: &Path, arguments: &[&str]) -> Output {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(arguments).arg("--offline").current_dir(folder).env_remove("RUSTFLAGS");
    cargo.env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/own")).output().unwrap()
}

/// Where the generated kernels are.
const GENERATED: &str = "kernels/src/generated/braking.rs";

/// The example in this crate is what derivation and generation make of it today. If it is not: run `closedform new`,
/// `closedform derive` and `closedform generate`, and copy what they made into `codegen/command/example/`.
#[test]
fn the_example_is_fresh() {
    let _turn = turn();
    let (_folder, project) = made();
    let example = |name: &str| fs::read_to_string(repository().join("codegen/command/example").join(name)).unwrap();
    succeeds(&project, &["derive"]);
    succeeds(&project, &["generate"]);
    for name in ["braking.rs", "braking.tsv", "judges.rs", "mod.rs"] {
        let now = fs::read_to_string(project.join("kernels/src/generated").join(name)).unwrap();
        assert_eq!(now, example(&format!("generated/{name}")), "generated/{name}");
    }
    for (folder, name) in [("maxima-ref", "braking.ref"), ("maxima-ref", "braking.tsv"), ("records", "LEDGER.csv")] {
        let now = fs::read_to_string(project.join(folder).join(name)).unwrap();
        assert_eq!(now, example(name), "{name}");
    }
    assert!(succeeds(&project, &["check", "--prove", "--maxima"]).contains("every kernel is proved equal"));
}

#[test]
fn a_new_project_builds_tests_and_checks_at_once() {
    let (_folder, project) = made();
    let said = succeeds(&project, &["check", "--maxima"]);
    for part in ["fresh: kernels/src/generated", "equal: all 2 kernels", "live: every reference"] {
        assert!(said.contains(part), "`{part}` is not in {said}");
    }
    let output = cargo(&project, &["test", "--quiet"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for command in
        [&["list"][..], &["show", "safe_speed"], &["eval", "safe_speed", "d=1e-14", "a=8", "tr=1"], &["ledger"]]
    {
        succeeds(&project.join("kernels/src"), command);
    }
    assert!(succeeds(&project, &["eval", "safe_speed", "d=1e-14", "a=8", "tr=1"]).contains("9.999999999999994e-15"));
}

#[test]
fn every_mistake_is_found_without_symbolica() {
    let mistakes = [
        ("maxima-ref/braking.mac", "- a*t", "- 2*a*t", "braking.ref was made before a change of"),
        ("maxima-ref/braking.toml", "\"d >= 0\"", "\"d > 0\"", "braking.ref was made before a change of"),
        ("maxima-ref/braking.ref", "tr*v0", "tr*v0^2", "braking.ref was changed after it was generated"),
        ("maxima-ref/braking.tsv", "e", "e1", "braking.tsv was changed after it was generated"),
        (GENERATED, " + ", " - ", "braking.rs was changed after it was generated"),
        ("kernels/src/generated/judges.rs", "error <= bound", "true", "judges.rs was changed after it was generated"),
        ("records/LEDGER.csv", "braking", "baking", "stale: records/LEDGER.csv"),
        ("closedform.toml", "records", "recods", "unknown field `recods`"),
    ];
    for (file, old, new, words) in mistakes {
        let (_folder, project) = made();
        edit(&project.join(file), old, new);
        let said = fails(&project, &["check"]);
        assert!(said.contains(words), "{file}: `{words}` is not in {said}");
    }
    for file in ["braking.rs", "braking.tsv", "judges.rs", "mod.rs"].map(|name| format!("kernels/src/generated/{name}"))
    {
        let (_folder, project) = made();
        fs::remove_file(project.join(&file)).unwrap();
        let said = fails(&project, &["check"]);
        assert!(said.contains(&format!("missing: {file}")), "{said}");
    }
    let (_folder, project) = made();
    fs::remove_file(project.join("maxima-ref/braking.mac")).unwrap();
    for check in [&["check"][..], &["check", "--maxima"]] {
        assert!(fails(&project, check).contains("not there: put it back, or delete"), "{check:?}");
    }
    let (_folder, project) = made();
    fs::write(project.join("maxima-ref/more.mac"), "half(x) := x/2$").unwrap();
    assert!(fails(&project, &["check"]).contains("missing: kernels/src/generated/more.rs"));
}

/// Whoever edits a generated file and its stamp too is told by the proof.
#[test]
fn a_stamp_is_no_proof() {
    let (_folder, project) = made();
    let path = project.join(GENERATED);
    edit(&path, "product2 * deceleration / (root", "product2 / (root");
    restamp(&path);
    let said = fails(&project, &["check"]);
    assert!(said.contains("changed since its bound was proved"), "{said}");
    let (_folder, project) = made();
    let reference = project.join("maxima-ref/braking.ref");
    edit(&reference, "tr*v0", "2*tr*v0");
    restamp(&reference);
    assert!(fails(&project, &["check"]).contains("braking.rs was made before a change of"));
    let words = "another `distance`, of the kernel `braking::stopping_distance`";
    assert!(fails(&project, &["check", "--maxima"]).contains(words));
    let (_folder, project) = made();
    let golden = project.join("maxima-ref/braking.tsv");
    edit(&golden, "8.1917", "8.1918");
    restamp(&golden);
    let line = fs::read_to_string(&golden).unwrap().lines().position(|line| line.contains("8.1918")).unwrap() + 1;
    let words = format!("maxima-ref/braking.tsv:{line}: distance at v0=");
    let said = fails(&project, &["check", "--maxima"]);
    assert!(said.contains(&words), "`{words}` is not in {said}");
}

/// A new derivation changes all golden values of its function: some are enough to see that.
#[test]
fn few_golden_values_are_told_where_many_changed() {
    let (_folder, project) = made();
    edit(&project.join("maxima-ref/braking.mac"), "- a*t", "- 2*a*t");
    let said = fails(&project, &["check", "--maxima"]);
    assert_eq!(said.matches(": distance at v0=").count(), 3, "{said}");
    for words in
        ["maxima-ref/braking.ref: Maxima derives another `distance`", "more of `distance`", ": safe_speed at d="]
    {
        assert!(said.contains(words), "`{words}` is not in {said}");
    }
}

#[test]
fn the_judges_of_a_new_project_find_every_mutant() {
    let (_folder, project) = made();
    let said = succeeds(&project, &["mutants"]);
    assert!(said.lines().any(|line| line.starts_with(" all ")), "{said}");
    let list = project.join("records/EQUIVALENT.toml");
    let entry = "[[equivalent]]\nkernel = \"braking::safe_speed\"\nstep = \"result\"\nmistakes = [\"- as +\"]\n";
    fs::write(&list, format!("{entry}reason = \"..\"\n")).unwrap();
    let said = fails(&project, &["mutants", "safe_speed", "--points", "10"]);
    assert!(said.contains("why the results are the same"), "{said}");
}

#[test]
fn where_no_project_is_the_way_to_one_is_told() {
    let folder = tempfile::tempdir().unwrap();
    for command in [&["check"][..], &["generate"], &["derive"], &["list"], &["show", "f"], &["mutants"], &["ledger"]] {
        let said = fails(folder.path(), command);
        assert!(said.contains("`closedform new NAME` makes one"), "{command:?}: {said}");
    }
}

#[test]
fn a_stale_project_does_not_build() {
    for (file, old, new) in [("braking.mac", "- a*t", "- 2*a*t"), ("braking.toml", "\"d >= 0\"", "\"d > 0\"")] {
        let (_folder, project) = made();
        edit(&project.join("maxima-ref").join(file), old, new);
        let output = cargo(&project, &["build", "--quiet"]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && said.contains("closedform derive && closedform generate"), "{said}");
    }
}

#[test]
fn in_a_workspace_the_project_is_a_member() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("Cargo.toml"), "[workspace]\nresolver = \"3\"\nmembers = [\"crates/*\"]\n").unwrap();
    fs::create_dir(folder.path().join("crates")).unwrap();
    succeeds(folder.path(), &["new", "crates/braking"]);
    let project = folder.path().join("crates/braking");
    let manifest: toml::Table = fs::read_to_string(project.join("Cargo.toml")).unwrap().parse().unwrap();
    assert!(manifest.contains_key("package") && !manifest.contains_key("workspace"));
    succeeds(&project, &["check"]);
    let output = cargo(folder.path(), &["test", "--quiet", "--package", "braking"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn nothing_is_written_where_something_is() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.tex"), "words").unwrap();
    assert!(fails(folder.path(), &["new", "."]).contains("holds something already"));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    succeeds(folder.path(), &["new", "mine"]);
    assert!(fails(folder.path(), &["new", "mine"]).contains("holds something already"));
    let out = folder.path().join("mine/kernels");
    fs::write(folder.path().join("x.mac"), "f(x) := x$").unwrap();
    let input = folder.path().join("x.mac");
    let arguments = ["generate", "--input", input.to_str().unwrap(), "--out", out.to_str().unwrap()];
    assert!(fails(folder.path(), &arguments).contains("belongs to a project"));
}

#[test]
fn a_crate_says_where_it_takes_its_parts_from() {
    let folder = tempfile::tempdir().unwrap();
    let output = closedform(folder.path(), &["new", "mine", "--runtime", "https://host/closedform.git"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |name: &str| fs::read_to_string(folder.path().join("mine").join(name)).unwrap();
    let manifest: toml::Table = read("kernels/Cargo.toml").parse().unwrap();
    for (table, package) in [("dependencies", "closedform"), ("build-dependencies", "closedform-build")] {
        assert_eq!(manifest[table][package]["git"].as_str(), Some("https://host/closedform.git"));
    }
    assert!(read(".github/workflows/kernels.yml").contains("cargo install --locked --git https://host/closedform.git"));
}
