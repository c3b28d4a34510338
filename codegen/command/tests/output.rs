//! Standard output and error that are closed or full: no command panics, and a full disk is said.
#![cfg(target_os = "linux")]

mod common;

use common::{repository, turn};
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn run(folder: &Path, arguments: &[&str], output: Stdio, errors: Stdio) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform"));
    command.args(arguments).current_dir(folder).env("CLOSEDFORM_WAIT", "300");
    command.stdin(Stdio::null()).stdout(output).stderr(errors);
    command.spawn().unwrap().wait_with_output().unwrap()
}

fn full() -> File {
    OpenOptions::new().write(true).open("/dev/full").unwrap()
}

/// A pipe that nobody reads.
fn closed() -> io::PipeWriter {
    io::pipe().unwrap().1
}

/// The command is done, reader or not; but a full disk is an error.
fn holds(folder: &Path, arguments: &[&str]) {
    let said = |output: &Output| String::from_utf8_lossy(&output.stderr).into_owned();
    let unread = run(folder, arguments, closed().into(), Stdio::piped());
    assert_eq!(unread.status.code(), Some(0), "{arguments:?}: {}", said(&unread));
    assert!(!said(&unread).contains("rror") && !said(&unread).contains("panic"), "{arguments:?}: {}", said(&unread));
    let lost = run(folder, arguments, full().into(), Stdio::piped());
    assert_eq!(lost.status.code(), Some(1), "{arguments:?}: {}", said(&lost));
    let about =
        said(&lost).lines().filter(|line| line.contains("No space left")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(about.len(), 1, "{arguments:?}: {}", said(&lost));
    assert!(about[0].starts_with("closedform: cannot write to standard output: "), "{arguments:?}: {}", said(&lost));
    for errors in [Stdio::from(closed()), Stdio::from(full())] {
        assert_eq!(run(folder, arguments, Stdio::null(), errors).status.code(), Some(0), "{arguments:?}");
    }
}

#[test]
fn commands_that_answer() {
    let folder = repository();
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["eval", "--help"],
        &["list"],
        &["list", "--json"],
        &["show", "pvt::turn_out"],
        &["verify", "pvt::turn_out", "--points", "3"],
    ] {
        holds(&folder, arguments);
    }
}

#[test]
fn a_table_of_points() {
    let folder = tempfile::tempdir().unwrap();
    let points = folder.path().join("points.csv");
    let rows: String = (1..5000).map(|row| format!("{row},-1\n")).collect();
    fs::write(&points, format!("v0,a1\n{rows}")).unwrap();
    holds(&repository(), &["eval", "pvt::turn_out", "--batch", points.to_str().unwrap()]);
}

#[test]
fn commands_that_write() {
    let _turn = turn();
    let project = tempfile::tempdir().unwrap();
    fs::create_dir(project.path().join("maxima-ref")).unwrap();
    for name in ["pvt.mac", "pvt.toml", "pvt.ref", "pvt.tsv"].map(|name| Path::new("maxima-ref").join(name)) {
        fs::copy(repository().join(&name), project.path().join(name)).unwrap();
    }
    for arguments in [&["derive", "pvt"][..], &["generate", "--points", "5"], &["check"]] {
        holds(project.path(), arguments);
    }
}

#[test]
fn errors_that_nobody_reads() {
    for errors in [Stdio::from(closed()), Stdio::from(full())] {
        let output = run(&repository(), &["show", "nothing"], Stdio::null(), errors);
        assert_eq!(output.status.code(), Some(1));
    }
}
