//! Turns at Symbolica: commands side by side, killed ones, and ones that crash or take too long.
#![cfg(target_os = "linux")]

mod common;

use common::{closedform_waiting, failure, project, repository, signal, turn};
use std::fs::{self, OpenOptions};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// How many commands run one after another in each of the loops that run side by side.
const RUNS: usize = 12;

/// Longer than anything here takes that does not hang.
const LONG: Duration = Duration::from_secs(300);

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_closedform"));
    command.args(arguments).current_dir(folder).env("CLOSEDFORM_WAIT", LONG.as_secs().to_string());
    command
}

/// Makes a small crate many times, with a folder for temporary files of its own if `apart`.
fn a_loop(name: &str, apart: bool) -> Vec<Output> {
    let folder = tempfile::tempdir().unwrap();
    let worksheet = folder.path().join(format!("{name}.mac"));
    fs::write(&worksheet, "f(x) := x+1$").unwrap();
    let out = folder.path().join("out");
    let arguments = ["generate", "--input", worksheet.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let mut command = command(&repository(), &arguments);
    if apart {
        command.env("TMPDIR", folder.path());
    }
    (0..RUNS).map(|_| command.output().unwrap()).collect()
}

/// The loops all succeed, and what each command says of waiting it says once.
fn side_by_side(loops: [(&'static str, bool); 3]) {
    let threads = loops.map(|(name, apart)| thread::spawn(move || a_loop(name, apart)));
    for output in threads.into_iter().flat_map(|thread| thread.join().unwrap()) {
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        assert!(said.matches("waiting for another").count() <= 1, "{said}");
        assert!(said.matches("waiting for a program").count() <= 1, "{said}");
        assert!(said.matches("Symbolica").count() < 12, "{said}");
    }
}

#[test]
fn commands_side_by_side_take_turns() {
    let _turn = turn();
    side_by_side([("one", false), ("two", false), ("three", false)]);
}

#[test]
fn commands_that_share_no_lock_wait_for_each_other() {
    let _turn = turn();
    side_by_side([("one", true), ("two", true), ("three", false)]);
}

/// The command at work on the whole project, and its worker.
#[expect(
    clippy::zombie_processes,
    reason = "whoever asks for the command waits for it; without a worker the test fails"
)]
fn at_work(project: &Path, set: Option<(&str, &str)>) -> (Child, u32) {
    let mut command = command(project, &["generate", "--points", "5"]);
    command.stdout(Stdio::null()).stderr(Stdio::piped()).envs(set);
    let child = command.spawn().unwrap();
    let mark = format!("--parent\0{}\0", child.id());
    let start = Instant::now();
    loop {
        let processes = fs::read_dir("/proc").unwrap().flatten();
        let found = processes.filter(|process| {
            fs::read_to_string(process.path().join("cmdline")).is_ok_and(|line| line.contains(&mark))
        });
        if let Some(worker) = found.map(|process| process.file_name()).next() {
            return (child, worker.to_str().unwrap().parse().unwrap());
        }
        assert!(start.elapsed() < LONG, "no worker has started");
        thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_worker_ends_with_the_command() {
    let _turn = turn();
    for name in ["-KILL", "-INT", "-TERM"] {
        let project = project();
        let (mut child, worker) = at_work(project.path(), None);
        signal(name, child.id());
        child.wait().unwrap();
        let start = Instant::now();
        while Path::new("/proc").join(worker.to_string()).exists() {
            assert!(start.elapsed() < Duration::from_secs(20), "{name}: the worker goes on");
            thread::sleep(Duration::from_millis(10));
        }
    }
}

/// Whether a text ends with the place of a formula and the name of its kernel.
fn has_place(said: &str) -> bool {
    let Some((place, kernel)) = said.rsplit_once(": `") else { return false };
    let place = place.rsplit(' ').next().unwrap_or_default();
    let parts: Vec<&str> = place.rsplitn(3, ':').collect();
    let [column, line, file] = parts[..] else { return false };
    let is_number = |text: &str| text.parse::<u32>().is_ok();
    kernel.contains("::") && is_number(column) && is_number(line) && file.contains("maxima-ref")
}

#[test]
fn a_crash_is_told_from_a_refusal() {
    let _turn = turn();
    let project = project();
    let (child, worker) = at_work(project.path(), None);
    let mut child = child;
    let mut errors = BufReader::new(child.stderr.take().unwrap());
    errors.read_line(&mut String::new()).unwrap(); // Symbolica has begun
    signal("-ABRT", worker);
    let mut said = String::new();
    errors.read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1), "{said}");
    let said = said.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ");
    let before = said.split_once("the algebra crashed (signal: 6").map(|(before, _)| before).unwrap_or_default();
    let names = before.strip_suffix("`: ").is_some_and(has_place);
    assert!(names || before.ends_with("before the first kernel: "), "{said}");
    assert!(!said.contains("another"), "{said}");
}

#[test]
fn a_kernel_that_takes_too_long_is_named() {
    let _turn = turn();
    let project = project();
    let (child, _) = at_work(project.path(), Some(("CLOSEDFORM_LIMIT", "0")));
    let said = failure(&child.wait_with_output().unwrap(), &["generate"]);
    let names = said.split_once("`: not made in 0 s of processor time").is_some_and(|(before, _)| has_place(before));
    assert!(names && said.contains("CLOSEDFORM_LIMIT"), "{said}");
}

#[test]
fn a_second_command_says_at_once_what_it_waits_for() {
    let _turn = turn();
    let project = project();
    let path = std::env::temp_dir().join("closedform-symbolica.lock");
    let lock = OpenOptions::new().create(true).truncate(false).write(true).open(path).unwrap();
    lock.lock().unwrap();
    let said = failure(&closedform_waiting(project.path(), &["generate"], 1), &["generate"]);
    assert!(said.starts_with("waiting for another closedform command that does algebra ("), "{said}");
    assert!(said.contains("1 s at most") && said.contains("another closedform command is doing algebra"), "{said}");
    let mut command = command(project.path(), &["generate"]);
    let said = failure(&command.env("CLOSEDFORM_WAIT", "soon").output().unwrap(), &["generate"]);
    assert!(said.contains("CLOSEDFORM_WAIT is `soon`, which is no number of seconds"), "{said}");
}
