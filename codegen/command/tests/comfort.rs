//! What makes the command pleasant: narrow lists, quiet runs, exit codes, completions, manual pages, and watching.

mod common;

use common::{closedform, edit, repository, signal, small_project, succeeds, turn};
use std::fs;
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
fn a_list_fits_a_terminal_and_its_names_are_whole() {
    let list = succeeds(&repository(), &["list"]);
    let long: Vec<&str> = list.lines().filter(|line| line.chars().count() > 80).collect();
    assert!(long.is_empty(), "{long:#?}");
    let json: serde_json::Value = serde_json::from_str(&succeeds(&repository(), &["list", "--json"])).unwrap();
    for kernel in json.as_array().unwrap() {
        let name = kernel["kernel"].as_str().unwrap();
        assert!(list.lines().any(|line| line.split_whitespace().next() == Some(name)), "{name} cannot be copied");
    }
}

#[test]
fn exit_codes_say_who_is_wrong() {
    let code = |arguments: &[&str]| closedform(&repository(), arguments).status.code();
    assert_eq!(code(&["list"]), Some(0));
    assert_eq!(code(&["--help"]), Some(0));
    for wrong in [&["show", "nothing"][..], &["eval", "pvt::turn_out", "v0=-1", "a1=-2"], &["list", "nothing"]] {
        assert_eq!(code(wrong), Some(1), "{wrong:?}");
    }
    for unread in [&["frobnicate"][..], &["list", "--frobnicate"], &["verify", "--points", "many"], &[]] {
        assert_eq!(code(unread), Some(2), "{unread:?}");
    }
}

#[test]
fn a_quiet_command_says_errors_and_what_was_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let output = closedform(folder.path(), &["--quiet", "new", "mine"]);
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
    let project = folder.path().join("mine");
    let output = closedform(&project, &["check", "--quiet"]);
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
    assert!(!succeeds(&project, &["list", "-q"]).is_empty());
    edit(&project.join("kernels/src/generated/braking.rs"), "+", "-");
    assert!(common::fails(&project, &["check", "--quiet"]).contains("changed after it was generated"));
}

#[test]
fn shells_and_manuals_know_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let text = succeeds(&repository(), &["completions", shell]);
        assert!(["generate", "mutants", "watch"].iter().all(|word| text.contains(word)), "{shell}");
    }
    let folder = tempfile::tempdir().unwrap();
    succeeds(folder.path(), &["man", "man1"]);
    for page in ["closedform.1", "closedform-generate.1", "closedform-check.1"] {
        let text = fs::read_to_string(folder.path().join("man1").join(page)).unwrap();
        assert!(text.contains(".SH NAME") && text.contains("closedform"), "{page}");
    }
}

/// A process that ends with the test.
struct Watching(Child);

impl Drop for Watching {
    fn drop(&mut self) {
        _ = self.0.kill();
    }
}

fn until(what: &str, mut holds: impl FnMut() -> bool) {
    let begin = Instant::now();
    while !holds() {
        assert!(begin.elapsed() < Duration::from_secs(240), "{what}");
        sleep(Duration::from_millis(100));
    }
}

#[test]
fn watching_survives_a_mistake_and_ends_quietly() {
    let _turn = turn();
    let project = small_project();
    let said = project.path().join("said");
    let log = fs::File::create(&said).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform"));
    command.args(["generate", "--watch", "--points", "5"]).current_dir(project.path()).env("CLOSEDFORM_WAIT", "300");
    command.stdin(Stdio::null()).stdout(log.try_clone().unwrap()).stderr(log);
    let mut watching = Watching(command.spawn().unwrap());
    let times = |text: &str| {
        let mut read = String::new();
        fs::File::open(&said).unwrap().read_to_string(&mut read).unwrap();
        read.matches(text).count()
    };
    until("the first run", || times("Ctrl-C ends it") == 1);
    let worksheet = project.path().join("maxima-ref/own.mac");
    fs::write(&worksheet, "own(x) := x+$\n").unwrap();
    until("the mistake is told", || times("Ctrl-C ends it") == 2);
    assert!(times("own.mac:1:") > 0);
    fs::write(&worksheet, "own(x) := x+1$\n").unwrap();
    let module = project.path().join("kernels/src/generated/own.rs");
    until("the mended worksheet is generated", || module.is_file() && times("Ctrl-C ends it") == 3);
    assert!(interrupt(&mut watching.0), "{}", fs::read_to_string(&said).unwrap());
}

/// Sends what Ctrl-C sends; whether the process then ends without complaint.
fn interrupt(child: &mut Child) -> bool {
    signal("-INT", child.id());
    child.wait().is_ok_and(|status| status.success())
}
