//! `closedform bind` in a project of one's own: written, built, called from C, and careful with what others wrote.

mod common;

use common::{fails, succeeds};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs a command that must succeed; returns what it printed.
fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).env_remove("RUSTFLAGS").env("RUSTFLAGS", "-Dwarnings");
    let output = command.env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/bind")).output().unwrap();
    assert!(output.status.success(), "{program} {arguments:?}:\n{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_project_of_ones_own_is_called_from_c() {
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["new", "braking"]);
    let project = folder.path().join("braking");
    assert!(succeeds(&project.join("kernels"), &["bind", "c"]).contains("2 kernels of braking for C"));
    let bound = project.join("bindings/c");
    run(&bound, env!("CARGO"), &["build", "--offline"]);
    let archive = concat!(env!("CARGO_TARGET_TMPDIR"), "/bind/debug/libbraking_c.a");
    let strict = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "-Iinclude"];
    let record = ["-o", "record", "examples/record.c", archive, "-lm", "-lpthread", "-ldl"];
    run(&bound, "cc", &[&strict[..], &record].concat());
    assert!(run(&bound, "./record", &[]).starts_with("braking::stopping_distance: 1.80"));
    run(&bound, "cc", &[&strict[..], &["-c", "-o", "tier1.o", "c99/braking_tier1.c"]].concat());
}

#[test]
fn what_others_wrote_stays() {
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["new", "braking"]);
    let project = folder.path().join("braking");
    let header = project.join("elsewhere/include/braking.h");
    fs::create_dir_all(header.parent().unwrap()).unwrap();
    fs::write(&header, "mine\n").unwrap();
    let said = fails(&project, &["bind", "c", "--out", "elsewhere"]);
    assert!(said.contains("its first line does not say that `closedform bind` wrote it"), "{said}");
    assert_eq!(fs::read_to_string(&header).unwrap(), "mine\n");
    assert!(!project.join("elsewhere/Cargo.toml").exists());
}
