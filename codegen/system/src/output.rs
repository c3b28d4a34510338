//! Standard output: text and JSON, where a reader that has seen enough is no error; and notes on standard error, unless the
//! command is quiet.

use std::io::{self, ErrorKind, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use miette::Diagnostic;
use serde::Serialize;
use thiserror::Error;

/// Whether nothing is said but errors and what was asked for.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Standard output takes nothing more.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot write to standard output: {cause}; make room where it goes, or send it elsewhere")]
pub struct OutputError {
    /// What the system says. Not a source of the error: it is told once, in one line.
    cause: String,
}

impl From<io::Error> for OutputError {
    fn from(error: io::Error) -> Self {
        Self { cause: error.to_string() }
    }
}

/// From now on nothing is said but errors and what was asked for.
pub fn be_quiet() {
    QUIET.store(true, Ordering::Relaxed);
}

/// Whether nothing is said but errors and what was asked for.
#[must_use]
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Writes what a command has done, unless it is quiet.
///
/// # Errors
///
/// When it cannot be written.
pub fn tell(text: &str) -> Result<(), OutputError> {
    if is_quiet() { Ok(()) } else { print(text) }
}

/// Writes the text.
///
/// # Errors
///
/// When it cannot be written.
pub fn print(text: &str) -> Result<(), OutputError> {
    let mut output = io::stdout().lock();
    unless_closed(output.write_all(text.as_bytes()).and_then(|()| output.flush()))
}

/// Writes the value as JSON.
///
/// # Errors
///
/// When it cannot be written.
pub fn print_json(value: &impl Serialize) -> Result<(), OutputError> {
    let text = serde_json::to_string_pretty(value).map_err(io::Error::from)?;
    print(&format!("{text}\n"))
}

/// Writes a line to standard error, unless the command is quiet.
pub fn note(text: &str) {
    if !is_quiet() {
        warn(text);
    }
}

/// Writes a line to standard error, if anybody reads it: where that is closed or full, nothing is left to complain to.
pub fn warn(text: &str) {
    _ = writeln!(io::stderr().lock(), "{text}");
}

/// What writing came to; that nobody reads on is no error.
///
/// # Errors
///
/// When it failed otherwise.
pub fn unless_closed(written: io::Result<()>) -> Result<(), OutputError> {
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}
