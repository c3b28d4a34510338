//! The pages of the book that show commands, and README.md, print what they show.
//!
//! Every command of a block of `console` code is run. With the variable `UPDATE`, pages are written anew.

mod common;
#[path = "book/page.rs"]
mod page;

use std::fs;
use std::path::Path;
use std::process::Command;

use common::{project, repository, succeeds, turn};
use tempfile::TempDir;

/// A shell that finds this command first, and builds without network in a folder that is kept.
fn shell() -> Command {
    let own = Path::new(env!("CARGO_BIN_EXE_closedform")).parent().unwrap().to_owned();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths([own].into_iter().chain(std::env::split_paths(&path))).unwrap();
    let mut shell = Command::new("sh");
    shell.env("PATH", path).env("CLOSEDFORM_WAIT", "300").env("CARGO_NET_OFFLINE", "true").env_remove("RUSTFLAGS");
    shell.env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/own")).env("CARGO_TERM_COLOR", "never");
    shell
}

/// Runs a page in a folder.
#[track_caller]
fn holds(name: &str, folder: &Path) {
    let _turn = turn();
    let path = repository().join(name);
    let text = fs::read_to_string(&path).unwrap();
    let examples = page::examples(&text);
    assert!(!examples.is_empty(), "{name} has no examples");
    let outputs = page::run(&examples, &mut shell(), folder);
    let complaints = page::complaints(&examples, &outputs);
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, page::updated(&text, &examples, &outputs)).unwrap();
    }
    assert!(complaints.is_empty(), "{name}: another output; with UPDATE=1 this test writes it\n{complaints}");
}

fn empty() -> TempDir {
    tempfile::tempdir().unwrap()
}

#[test]
fn start_in_five_minutes() {
    holds("book/src/start.md", empty().path());
}

#[test]
fn the_command() {
    holds("book/src/command.md", empty().path());
}

#[test]
fn every_command_has_an_example() {
    let text = fs::read_to_string(repository().join("book/src/command.md")).unwrap();
    let examples = page::examples(&text);
    let help = succeeds(&repository(), &["--help"]);
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names: Vec<&str> = commands.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 10, "{help}");
    for name in names.into_iter().filter(|name| *name != "help") {
        let begin = format!("closedform {name}");
        assert!(examples.iter().any(|example| example.command.starts_with(&begin)), "book/src/command.md: {begin}");
    }
}

#[test]
fn the_first_page() {
    let folder = tempfile::tempdir().unwrap();
    let checkout = folder.path().join("closedform");
    fs::rename(project().keep(), &checkout).unwrap();
    fs::create_dir(checkout.join("target")).unwrap();
    let own = Path::new(env!("CARGO_BIN_EXE_closedform")).parent().unwrap();
    std::os::unix::fs::symlink(own, checkout.join("target/debug")).unwrap();
    holds("README.md", &checkout);
}

#[test]
fn one_s_own_project() {
    holds("book/src/your-project.md", empty().path());
}

#[test]
fn one_s_own_worksheet() {
    holds("book/src/your-worksheet.md", empty().path());
}

#[test]
fn plans_of_moves() {
    holds("book/src/motion.md", empty().path());
}

/// What is not run is a block of another kind.
#[test]
fn no_page_shows_commands_that_are_not_run() {
    let tested = ["start.md", "command.md", "your-project.md", "your-worksheet.md", "motion.md"];
    for entry in fs::read_dir(repository().join("book/src")).unwrap().map(|entry| entry.unwrap()) {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".md") {
            let shows = !page::examples(&fs::read_to_string(entry.path()).unwrap()).is_empty();
            assert_eq!(shows, tested.contains(&name.as_str()), "{name}");
        }
    }
}

#[test]
fn shown_lines_may_leave_parts_open() {
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    let fits = |shown: &str, printed: &str| page::fits(&lines(shown), &lines(printed));
    assert!(fits("a\n...\nd", "a\nb\nc\nd") && fits("a\n...\nb", "a\nb") && fits("...", ""));
    assert!(fits("x [..] y", "x 12 y") && fits("[..]end", "the end") && !fits("x [..] y", "x 12 z"));
    assert!(!fits("a", "a\nb") && !fits("a\nb", "a") && !fits("a\n...\nb", "a\nc"));
}
