//! What the tests of the command share: running it, one at a time, in folders of their own.
#![allow(dead_code, reason = "every test binary uses its own part")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

/// Symbolica runs once a machine: tests that generate take turns.
static TURN: Mutex<()> = Mutex::new(());

/// Waits for this test's turn.
pub fn turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The root of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()
        .expect("codegen/command stands in the repository")
}

/// Runs the command in a folder; if somebody else on the machine is at it, after them.
pub fn closedform(folder: &Path, arguments: &[&str]) -> Output {
    closedform_waiting(folder, arguments, 300)
}

/// Runs the command in a folder, waiting some seconds for others at most.
pub fn closedform_waiting(folder: &Path, arguments: &[&str], seconds: u32) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform"));
    command.env("CLOSEDFORM_WAIT", seconds.to_string());
    command.args(arguments).current_dir(folder).output().expect("the command starts")
}

/// Runs the command and expects success; returns what it printed.
pub fn succeeds(folder: &Path, arguments: &[&str]) -> String {
    let output = closedform(folder, arguments);
    assert!(output.status.success(), "closedform {arguments:?} failed:\n{}", said(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Runs the command and expects a plain failure: status 1, no panic; returns what it said, white space folded.
pub fn fails(folder: &Path, arguments: &[&str]) -> String {
    failure(&closedform(folder, arguments), arguments)
}

/// What a command that failed plainly has said.
pub fn failure(output: &Output, arguments: &[&str]) -> String {
    assert_eq!(output.status.code(), Some(1), "closedform {arguments:?}:\n{}", said(output));
    let said = said(output);
    assert!(!said.contains("panicked"), "{said}");
    said.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn said(output: &Output) -> String {
    format!("{}\n{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

/// A project of its own with this repository's worksheets, records and kernels.
pub fn project() -> tempfile::TempDir {
    let project = tempfile::tempdir().expect("a temporary folder");
    for folder in ["maxima-ref", "kernels", "tests/worst"] {
        copy(&repository().join(folder), &project.path().join(folder));
    }
    for file in ["closedform.toml", "tests/LEDGER.csv", "tests/EQUIVALENT.toml", "tests/POINTS.toml"] {
        fs::copy(repository().join(file), project.path().join(file)).expect("a copy");
    }
    project
}

/// A project with two of this repository's families, as generated.
pub fn small_project() -> tempfile::TempDir {
    let project = tempfile::tempdir().expect("a temporary folder");
    copy(SMALL.path(), project.path());
    project
}

/// The small project, generated once.
static SMALL: LazyLock<tempfile::TempDir> = LazyLock::new(|| {
    let project = tempfile::tempdir().expect("a temporary folder");
    let worksheets = project.path().join("maxima-ref");
    fs::create_dir(&worksheets).expect("a folder");
    for family in ["pvt", "turnaround"] {
        for file in ["mac", "toml", "ref", "tsv"].map(|end| format!("{family}.{end}")) {
            fs::copy(repository().join("maxima-ref").join(&file), worksheets.join(&file)).expect("a copy");
        }
    }
    succeeds(project.path(), &["generate"]);
    project
});

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("the folder is there") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy(&entry.path(), &target),
            false => _ = fs::copy(entry.path(), target).expect("a copy"),
        }
    }
}

/// Replaces the first occurrence of a text in a file, which must be there.
pub fn edit(file: &Path, old: &str, new: &str) {
    let text = fs::read_to_string(file).expect("the file is there");
    assert!(text.contains(old), "{} has no {old:?}", file.display());
    fs::write(file, text.replacen(old, new, 1)).expect("the file is written");
}

/// Stamps a generated file anew, as somebody does who means to deceive.
pub fn restamp(file: &Path) {
    let text = fs::read_to_string(file).expect("the file is there");
    let stamp = closedform_build::Stamp::read(&text).expect("a stamp");
    let without: Vec<&str> = text.lines().enumerate().filter(|(at, _)| *at != 1).map(|(_, line)| line).collect();
    let forged = closedform_build::stamped(&(without.join("\n") + "\n"), &stamp.version, stamp.inputs);
    fs::write(file, forged).expect("the file is written");
}

/// Sends a signal, by the shell's own `kill`: small systems have no program of that name.
pub fn signal(name: &str, process: u32) {
    let kill = ["-c", r#"kill "$0" "$1""#, name, &process.to_string()];
    assert!(Command::new("sh").args(kill).status().unwrap().success());
}
