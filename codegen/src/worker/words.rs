//! What the worker tells the command on standard output, a line a word, between the lines that Symbolica prints there.

use crate::pipeline::Generated;
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

/// Begins a line of ours.
const MARK: &str = "\u{1}closedform ";

/// One line.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Word {
    /// So many kernels will be made.
    Kernels(usize),
    /// This is begun now.
    Making(String),
    /// All is done.
    Made(Generated),
}

/// Sends a word.
pub(super) fn send(word: &Word) -> io::Result<()> {
    let text = serde_json::to_string(word).map_err(io::Error::from)?;
    let mut output = io::stdout().lock();
    // whatever stands before it may lack its end
    writeln!(output, "\n{MARK}{text}")?;
    output.flush()
}

/// The word in a line, if it is one of ours.
pub(super) fn read(line: &str) -> Option<Word> {
    serde_json::from_str(line.strip_prefix(MARK)?).ok()
}
