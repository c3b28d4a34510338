//! The child process: its output until it ends, asks, prints without end, or its time is up.

use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};

use rustix::process::{Pid, Signal, kill_process_group};

use super::error::{LostMaxima, Used};
use super::watch::{GLANCE, Watch};
use super::{Marks, Maxima};

/// More than any derivation prints.
const OUTPUT_LIMIT: usize = 8 << 20;

/// How a run ended.
pub(super) enum Ending {
    /// Maxima left.
    Exited(ExitStatus),
    /// Maxima asked something, and nobody can answer.
    Asked,
    /// The time was up.
    OutOfTime(Used),
    /// The output had no end.
    TooMuchOutput,
}

/// What a run printed, and how it ended.
pub(super) struct Run {
    pub(super) lines: Vec<String>,
    pub(super) ending: Ending,
}

/// Runs Maxima in a process group of its own, which does not survive this call.
pub(super) fn run(
    maxima: &Maxima,
    arguments: &[OsString],
    home: &Path,
    marks: &Marks,
    statements: usize,
) -> Result<Run, LostMaxima> {
    let mut child = start(maxima, arguments, home)?;
    let watch = Watch::new(maxima, &child, statements);
    let lines = child.stdout.take().map(lines_of);
    let (lines, early) = lines.map_or((Vec::new(), None), |lines| collect(&lines, &watch, marks));
    let ending = match early {
        Some(ending) => stop(&mut child, ending),
        None => wait(&mut child, &watch),
    };
    Ok(Run { lines, ending: ending.map_err(LostMaxima::Wait)? })
}

fn start(maxima: &Maxima, arguments: &[OsString], home: &Path) -> Result<Child, LostMaxima> {
    let mut command = Command::new(&maxima.program);
    command.args(arguments).current_dir(home).process_group(0);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    command.spawn().map_err(|cause| match cause.kind() {
        std::io::ErrorKind::NotFound if home.is_dir() => LostMaxima::Missing,
        _ => LostMaxima::Start(cause),
    })
}

fn lines_of(output: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, receiver) = mpsc::sync_channel(1024);
    std::thread::spawn(move || {
        let mut output = BufReader::new(output.take(OUTPUT_LIMIT as u64));
        let mut line = Vec::new();
        while output.read_until(b'\n', &mut line).is_ok_and(|read| read > 0) {
            let text = String::from_utf8_lossy(&line).trim_end_matches(['\n', '\r']).to_owned();
            line.clear();
            if sender.send(text).is_err() {
                break;
            }
        }
    });
    receiver
}

/// The lines until the output ends or the run must be stopped. A question is followed by the line that ends it.
fn collect(lines: &Receiver<String>, watch: &Watch, marks: &Marks) -> (Vec<String>, Option<Ending>) {
    let mut collected: Vec<String> = Vec::new();
    let mut bytes = 0;
    loop {
        match lines.recv_timeout(GLANCE) {
            Ok(line) => {
                if line.contains(&marks.statement) {
                    watch.statement();
                }
                bytes += line.len() + 1;
                let asked = line.contains(&marks.question);
                collected.push(line);
                if asked {
                    return (collected, Some(Ending::Asked));
                }
            }
            Err(RecvTimeoutError::Timeout) => {
                if let Some(used) = watch.exhausted() {
                    return (collected, Some(Ending::OutOfTime(used)));
                }
            }
            Err(RecvTimeoutError::Disconnected) if bytes >= OUTPUT_LIMIT => {
                return (collected, Some(Ending::TooMuchOutput));
            }
            Err(RecvTimeoutError::Disconnected) => return (collected, None),
        }
    }
}

/// Waits for a process whose output has ended.
fn wait(child: &mut Child, watch: &Watch) -> std::io::Result<Ending> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Ending::Exited(status));
        }
        if let Some(used) = watch.exhausted() {
            return stop(child, Ending::OutOfTime(used));
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
}

/// Ends the whole group: `maxima` is a script that starts a Lisp.
fn stop(child: &mut Child, ending: Ending) -> std::io::Result<Ending> {
    // an error means that the group is gone already
    _ = kill_process_group(Pid::from_child(child), Signal::KILL);
    child.wait()?;
    Ok(ending)
}
