//! One run of the worker: started with the lock in its hands, listened to, limited, and judged by how it ended.

use super::{Last, Source, WorkerError};
use crate::bar::progress_bar;
use closedform_project::generated::{Begun, Generated, Word};
use closedform_project::maxima_process::ALLOW_SYSTEM_VARIABLE;
use closedform_system::limit::MAXIMA;
use closedform_system::output::warn;
use closedform_system::processor::time_of;
use closedform_system::turn::Turn;
use indicatif::ProgressBar;
use std::collections::BTreeSet;
use std::io::{self, BufRead, BufReader, IsTerminal, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// What Symbolica says where another process of the machine uses it, before it aborts.
const REFUSAL: &str = "Cannot start new unlicensed Symbolica instance";

/// How a run ended that came to an end of its own.
pub(super) enum Ending {
    /// With a result.
    Made(Generated),
    /// Symbolica did not let it begin.
    Refused,
}

/// What is known of a run so far.
#[derive(Default)]
struct Heard {
    bar: Option<ProgressBar>,
    /// What was begun last.
    begun: Option<Begun>,
    /// Everything that was begun: a kernel is made, and then proved.
    kernels: BTreeSet<String>,
    /// The processor time at which the last was begun.
    since: Duration,
    made: Option<Generated>,
    /// What Symbolica has begun to print: lines in a frame, of which the last one closes it.
    notice: Vec<String>,
    /// It has said that another process uses it.
    refused: bool,
}

/// Runs the worker once; `quiet`: what Symbolica prints was shown before.
pub(super) fn attempt(
    generator: &Path,
    source: &Source,
    turn: &Turn,
    limit: u64,
    quiet: bool,
) -> Result<Ending, WorkerError> {
    let mut child = start(generator, source, turn)?;
    let words = child.stdout.take().map(words_of);
    let errors = child.stderr.take().map(|errors| thread::spawn(move || text_of(errors)));
    let mut heard = Heard::default();
    if let Some(words) = words
        && !listen(&mut child, &words, &mut heard, limit, quiet)
    {
        _ = child.kill(); // an error means that it has ended
        child.wait()?;
        return Err(WorkerError::OutOfTime { begun: Last(heard.begun), limit });
    }
    let status = child.wait()?;
    if let Some(bar) = &heard.bar {
        bar.finish_and_clear();
    }
    let errors = errors.and_then(|errors| errors.join().ok()).unwrap_or_default();
    judge(status, heard, &errors)
}

fn judge(status: ExitStatus, heard: Heard, errors: &str) -> Result<Ending, WorkerError> {
    let abnormal = !matches!(status.code(), Some(0 | 1));
    if abnormal && (heard.refused || errors.contains(REFUSAL)) {
        return Ok(Ending::Refused);
    }
    if !errors.is_empty() {
        warn(errors.trim_end());
    }
    match (status.code(), heard.made) {
        (Some(0), Some(made)) => Ok(Ending::Made(made)),
        (Some(1), _) => Err(WorkerError::Failed),
        _ => Err(WorkerError::Crashed { begun: Last(heard.begun), status }),
    }
}

/// Its standard input is the lock file: so it holds the lock until it has ended, whatever becomes of this process.
fn start(generator: &Path, source: &Source, turn: &Turn) -> io::Result<Child> {
    let mut generator = Command::new(generator);
    generator.arg("--parent").arg(std::process::id().to_string());
    match source {
        Source::Folder(folder) => generator.arg("--folder").arg(folder),
        Source::Worksheet { worksheet, module, strict, except } => {
            if *strict {
                generator.arg("--strict");
            }
            let except = except.iter().map(|kernel| format!("--except={kernel}"));
            generator.args(except).arg("--worksheet").arg(worksheet).arg("--module").arg(module)
        }
        Source::Rederived { folder, kernels, maxima } => {
            if maxima.allow_system {
                generator.env(ALLOW_SYSTEM_VARIABLE, "1");
            }
            generator.env(MAXIMA.variable, maxima.limit.as_secs().to_string());
            generator.arg("--folder").arg(folder).arg("--kernels").arg(kernels)
        }
    };
    if let Some(width) = colourful_width() {
        generator.env("FORCE_COLOR", "1").env("COLUMNS", width.to_string());
    }
    generator.stdin(turn.shared()?).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()
}

/// The width of the terminal on which errors appear, if they may be coloured there: the worker cannot know.
fn colourful_width() -> Option<u16> {
    let plain = std::env::var_os("NO_COLOR").is_some() || std::env::var_os("TERM").is_none_or(|term| term == "dumb");
    let terminal = Some(io::stderr()).filter(|errors| errors.is_terminal() && !plain)?;
    rustix::termios::tcgetwinsize(terminal).ok().map(|size| size.ws_col)
}

fn words_of(output: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let lines = BufReader::new(output).split(b'\n').map_while(Result::ok);
        lines.map(|line| String::from_utf8_lossy(&line).into_owned()).try_for_each(|line| sender.send(line))
    });
    receiver
}

fn text_of(mut errors: impl Read) -> String {
    let mut text = Vec::new();
    // what was read until then is all there is
    _ = errors.read_to_end(&mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// Listens until the worker ends; false if it takes too long for what it has begun.
fn listen(child: &mut Child, words: &Receiver<String>, heard: &mut Heard, limit: u64, quiet: bool) -> bool {
    loop {
        match words.recv_timeout(Duration::from_millis(200)) {
            Ok(line) => match Word::read(&line) {
                Some(word) => heard.word(word, child.id()),
                None if line.trim().is_empty() => {}
                None => heard.notice(line, quiet),
            },
            Err(RecvTimeoutError::Timeout) => {
                let used = time_of(child.id()).unwrap_or_default().saturating_sub(heard.since);
                if heard.begun.is_some() && used > Duration::from_secs(limit) {
                    return false;
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                heard.show(quiet);
                return true;
            }
        }
    }
}

impl Heard {
    fn word(&mut self, word: Word, process: u32) {
        match word {
            Word::Kernels(kernels) => self.bar = Some(progress_bar(kernels as u64, "{bar:30} {pos}/{len} {msg}")),
            Word::Begun(begun) => {
                self.kernels.insert(begun.what.clone());
                if let Some(bar) = &self.bar {
                    bar.set_message(begun.what.clone());
                    bar.set_position(self.kernels.len() as u64);
                }
                self.begun = Some(begun);
                self.since = time_of(process).unwrap_or_default();
            }
            Word::Made(made) => self.made = Some(made),
        }
    }

    fn notice(&mut self, line: String, quiet: bool) {
        let is_whole = !line.starts_with(['┌', '│']);
        self.notice.push(line);
        if is_whole {
            self.show(quiet);
        }
    }

    /// Shows what Symbolica printed, in one piece above the bar; a refusal leads to another attempt instead.
    fn show(&mut self, quiet: bool) {
        let text = std::mem::take(&mut self.notice).join("\n");
        let refused = text.contains(REFUSAL);
        self.refused |= refused;
        if quiet || refused || text.is_empty() {
            return;
        }
        match &self.bar {
            Some(bar) => bar.suspend(|| warn(&text)),
            None => warn(&text),
        }
    }
}
