//! The command away from where cargo built it: in another folder, with and without the programs that it hands work on to.
#![cfg(unix)]

mod common;

use common::{failure, turn};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The command in a folder of its own, and a project.
struct Installed {
    folder: TempDir,
}

impl Installed {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let installed = Self { folder };
        for name in ["bin", "other"] {
            fs::create_dir(installed.at(name)).unwrap();
        }
        fs::copy(env!("CARGO_BIN_EXE_closedform"), installed.at("bin/closedform")).unwrap();
        let output = installed.run(installed.folder.path(), &["new", "braking"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        installed
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs it with one other folder on the path.
    fn run(&self, folder: &Path, arguments: &[&str]) -> Output {
        let mut command = Command::new(self.at("bin/closedform"));
        command.args(arguments).current_dir(folder).env("PATH", self.at("other"));
        command.output().unwrap()
    }

    /// What it says where it fails.
    fn fails(&self, arguments: &[&str]) -> String {
        failure(&self.run(&self.at("braking"), arguments), arguments)
    }

    /// Puts a program there that knows its version, and else says a word.
    fn program(&self, path: &str, version: &str, word: &str) {
        let name = path.rsplit('/').next().unwrap();
        let script = format!(
            "#!/bin/sh\nif test \"$1\" = --version; then echo {name} {version}; else echo {word} >&2; exit 1; fi\n"
        );
        fs::write(self.at(path), script).unwrap();
        fs::set_permissions(self.at(path), fs::Permissions::from_mode(0o755)).unwrap();
    }
}

#[test]
fn a_command_that_was_moved_works() {
    let _turn = turn();
    let installed = Installed::new();
    for arguments in [&["list"][..], &["show", "safe_speed"], &["eval", "safe_speed", "d=1", "a=8", "tr=1"], &["check"]]
    {
        let output = installed.run(&installed.at("braking"), arguments);
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn a_program_that_is_missing_is_named_with_what_installs_it() {
    let _turn = turn();
    let installed = Installed::new();
    for (arguments, program, folder) in [
        (&["generate"][..], "closedform-symbolica", "codegen/symbolica"),
        (&["check", "--prove"], "closedform-symbolica", "codegen/symbolica"),
        (&["plan", "step"], "closedform-motion", "motion"),
    ] {
        let said = installed.fails(arguments);
        assert!(said.contains(&format!("the program `{program}` is not installed")), "{said}");
        assert!(said.contains(&format!("cargo install --path {folder}` in a checkout of closedform")), "{said}");
    }
}

#[test]
fn a_program_is_of_the_version_of_the_command() {
    let _turn = turn();
    let installed = Installed::new();
    installed.program("other/closedform-symbolica", "9.9.9", "wrong");
    let said = installed.fails(&["generate"]);
    let words = format!("is closedform-symbolica 9.9.9, but this command is of version {VERSION}");
    assert!(said.contains(&words) && said.contains("install both from one checkout"), "{said}");
    assert!(!said.contains("wrong"), "{said}");
}

#[test]
fn what_stands_beside_the_command_comes_before_the_path() {
    let _turn = turn();
    let installed = Installed::new();
    installed.program("other/closedform-symbolica", VERSION, "on the path");
    assert!(installed.fails(&["generate"]).contains("on the path"));
    installed.program("bin/closedform-symbolica", VERSION, "beside");
    let said = installed.fails(&["generate"]);
    assert!(said.contains("beside") && !said.contains("on the path"), "{said}");
}
