//! What the tests of bindings share: the repository's kernels bound, the library built, C compiled and run.
#![allow(dead_code, reason = "every test binary uses its own part")]

use closedform_bind::{Library, c};
use closedform_measure::catalogue::Catalogue;
use closedform_project::Project;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{LazyLock, Mutex, PoisonError};

/// The root of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("codegen/bind stands in the repository")
}

/// The repository's kernels.
pub fn library() -> Library {
    let project = Project::at(&repository()).unwrap();
    Library::new(&project, &Catalogue::open(&project).unwrap()).unwrap()
}

/// The binding, written.
pub static BOUND: LazyLock<PathBuf> = LazyLock::new(|| {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c");
    c::tree(&library(), &out).unwrap().write(&out).unwrap();
    out
});

/// Where the static library is, built once.
pub static ARCHIVE: LazyLock<PathBuf> = LazyLock::new(|| {
    cargo(&["build"]);
    let archive = target().join("debug/libclosedform_kernels_c.a");
    assert!(archive.is_file(), "{}", archive.display());
    archive
});

/// Runs cargo on the binding crate, one at a time.
pub fn cargo(arguments: &[&str]) {
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(arguments).arg("--offline").current_dir(&*BOUND).env_remove("RUSTFLAGS");
    cargo.env("CARGO_TARGET_DIR", target()).env("CARGO_PROFILE_DEV_DEBUG", "false");
    demand(&mut cargo);
}

/// Where cargo builds.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("c-target")
}

/// Every C compiler here: `cc`, which must be there, and `gcc` and `clang` where they are.
pub fn compilers() -> Vec<&'static str> {
    let is_there =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success());
    let found: Vec<&str> = ["cc", "gcc", "clang"].into_iter().filter(is_there).collect();
    assert!(found.contains(&"cc"), "this test needs a C compiler called `cc`: install gcc or clang");
    found
}

/// Compiles with warnings as errors.
pub fn compile(compiler: &str, arguments: &[&str]) {
    let mut command = Command::new(compiler);
    command.args(["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror"]).args(arguments).current_dir(&*BOUND);
    demand(&mut command);
}

/// Runs a command that must succeed; returns what it printed.
pub fn demand(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|cause| panic!("{command:?}: {cause}"));
    let [said, complained] = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(output.status.success(), "{command:?}: {}\n{said}\n{complained}", output.status);
    said
}

/// Runs a program with this on its standard input; returns its standard output.
pub fn answer(program: &Path, input: &str) -> String {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()).unwrap());
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success(), "{}: {}", program.display(), output.status);
    String::from_utf8(output.stdout).unwrap()
}
