//! What Maxima printed, read: messages of the driver, or which statement failed and how.

use std::ops::Range;

use super::super::script::Script;
use super::Marks;
use super::child::{Ending, Run};
use super::error::{LostMaxima, ProcessError, Used};
use super::question;

/// The driver's last message.
pub(super) const END: &str = "end";

/// Lines that show that Maxima gave up a statement.
const FAILURES: [&str; 3] = ["-- an error.", "incorrect syntax", "Maxima encountered a Lisp error"];

/// One message of the driver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// What the driver said.
    pub text: String,
    /// What else was printed since the message before.
    pub noise: Vec<String>,
}

/// Why there are no messages, before it is known where.
pub(super) struct Failure {
    kind: Kind,
    /// Position of the statement in the batch file.
    statement: Option<usize>,
}

enum Kind {
    Asked(String),
    Failed(String),
    OutOfTime(Used),
    TooMuchOutput,
    Quit,
    Died(std::process::ExitStatus, String),
}

/// The messages of the driver, if it came to its end.
pub(super) fn read(run: &Run, marks: &Marks) -> Result<Vec<Message>, Failure> {
    let messages = messages(&run.lines, marks);
    match messages.split_last() {
        Some((last, messages)) if last.text == END => Ok(messages.to_vec()),
        _ => Err(failure(run, marks)),
    }
}

fn messages(lines: &[String], marks: &Marks) -> Vec<Message> {
    let mut messages = Vec::new();
    let mut noise = Vec::new();
    for line in lines {
        match line.strip_prefix(&marks.message) {
            Some(text) => messages.push(Message { text: text.to_owned(), noise: std::mem::take(&mut noise) }),
            None if line.trim().is_empty() => (),
            None => noise.push(line.clone()),
        }
    }
    if let Some(first) = messages.first_mut() {
        first.noise.clear(); // the worksheet's own output
    }
    messages
}

fn failure(run: &Run, marks: &Marks) -> Failure {
    let segments = segments(&run.lines, marks);
    let last = segments.len().checked_sub(1);
    let kind = match &run.ending {
        Ending::Asked => Kind::Asked(question(&run.lines, marks)),
        Ending::OutOfTime(used) => Kind::OutOfTime(*used),
        Ending::TooMuchOutput => Kind::TooMuchOutput,
        Ending::Exited(status) => return ended(&segments, *status, marks),
    };
    Failure { kind, statement: last.and_then(statement_of) }
}

/// The failure of a run in which Maxima left before the driver's end.
fn ended(segments: &[&[String]], status: std::process::ExitStatus, marks: &Marks) -> Failure {
    let failed = segments.iter().rposition(|lines| failure_line(lines).is_some());
    if let Some(segment) = failed {
        let lines = segments[segment];
        // Maxima reads a statement before it announces it
        let unread = failure_line(lines).is_some_and(|at| lines[at].contains("incorrect syntax"));
        let statement = statement_of(segment + usize::from(unread));
        return Failure { kind: Kind::Failed(message(lines, marks)), statement };
    }
    let last = segments.len().checked_sub(1);
    let printed = segments.last().map(|lines| lines.join("\n")).unwrap_or_default();
    let kind = if status.success() { Kind::Quit } else { Kind::Died(status, printed) };
    Failure { kind, statement: last.and_then(statement_of) }
}

/// The output of each statement, in order; the first segment is Maxima's own greeting.
fn segments<'a>(lines: &'a [String], marks: &Marks) -> Vec<&'a [String]> {
    let starts = lines.iter().enumerate().filter(|(_, line)| line.contains(&marks.statement)).map(|(at, _)| at);
    let mut bounds: Vec<usize> = std::iter::once(0).chain(starts).collect();
    bounds.push(lines.len());
    bounds.windows(2).map(|pair| &lines[pair[0]..pair[1]]).collect()
}

/// After the greeting comes the call of `batch` itself, then the first statement of the file.
fn statement_of(segment: usize) -> Option<usize> {
    segment.checked_sub(2)
}

fn failure_line(lines: &[String]) -> Option<usize> {
    lines.iter().position(|line| FAILURES.iter().any(|failure| line.contains(failure)))
}

/// What Maxima says of a failure, without the statement that it repeats first, or what the driver said.
fn message(lines: &[String], marks: &Marks) -> String {
    let said = lines.iter().rposition(|line| line.starts_with(&marks.message));
    let lines = &lines[said.map_or(0, |at| at + 1)..];
    let at = failure_line(lines).unwrap_or(0);
    let told_before = lines.get(at).is_some_and(|line| line.contains(FAILURES[0]));
    let told = if told_before { &lines[..at] } else { &lines[at..] };
    let echo = told.iter().position(|line| line.starts_with("(%i"));
    let after_echo = echo.map_or(told, |echo| {
        let more = told[echo + 1..].iter().take_while(|line| line.starts_with(' ')).count();
        &told[echo + 1 + more..]
    });
    let words = after_echo.iter().map(|line| line.trim()).filter(|line| !line.is_empty() && !line.starts_with("(%o"));
    words.take_while(|line| !line.starts_with("Automatically continuing")).collect::<Vec<_>>().join(" ")
}

fn question(lines: &[String], marks: &Marks) -> String {
    let last = lines.last().map(String::as_str).unwrap_or_default();
    last.split_once(&marks.question).map_or("", |(_, question)| question).trim().to_owned()
}

impl Failure {
    /// The failure with its place in the worksheet.
    pub(super) fn at(self, script: &Script, places: &[Range<usize>]) -> ProcessError {
        let text = script.shown();
        let place = self.statement.and_then(|statement| places.get(statement)).map(|place| place.clone().into());
        match self.kind {
            Kind::Asked(question) => {
                let start = place.map(|place: miette::SourceSpan| place.offset());
                let start = start.and_then(|start| text.places([start].into_iter()).pop());
                let remedy = question::remedy(&question, start.as_deref());
                ProcessError::Asked { remedy, question, text, place }
            }
            Kind::Failed(message) => ProcessError::Failed { message, text, place },
            Kind::OutOfTime(used) => ProcessError::OutOfTime { used, text, place },
            Kind::TooMuchOutput => ProcessError::TooMuchOutput { text, place },
            Kind::Quit => ProcessError::Quit { text, place },
            Kind::Died(status, printed) => {
                ProcessError::Lost { program: "maxima".to_owned(), cause: LostMaxima::Died { status, printed } }
            }
        }
    }
}
