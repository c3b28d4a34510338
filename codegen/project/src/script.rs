//! The text of a worksheet as Maxima reads it, from a file as people keep it: plain text in several encodings, the cells of
//! wxMaxima's texts (.wxm), its documents (.wxmx).

mod decode;
mod error;
mod wxm;
mod wxmx;

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use error::ScriptError;

use crate::source::{Cell, ReadError, Text};
use crate::statements::{statements, unclosed};

/// A worksheet as Maxima reads it. Places in its text are places in the person's own file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Script {
    text: String,
    shown: Text,
}

/// The largest file that is read, in bytes.
const LARGEST: u64 = 64 << 20;

/// What every zip archive begins with.
const ARCHIVE: &[u8] = b"PK\x03\x04";

impl Script {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// When it cannot be read, is no text, or no document of wxMaxima.
    pub fn load(path: &Path) -> Result<Self, ScriptError> {
        let remedy =
            "name a worksheet: a Maxima text (.mac, .dem), what wxMaxima saves (.wxm, .wxmx), or FPCores (.fpcore)"
                .to_owned();
        let unreadable = |cause| ReadError { path: path.to_owned(), cause, remedy };
        let mut bytes = Vec::new();
        let read = File::open(path).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes));
        read.map_err(unreadable)?;
        if bytes.len() as u64 > LARGEST {
            return Err(ScriptError::TooLarge { path: path.to_owned(), most: LARGEST >> 20 });
        }
        Self::of(path, &bytes)
    }

    /// Reads the bytes of a file of this name.
    ///
    /// # Errors
    ///
    /// When they are no text, or no document of wxMaxima.
    pub fn of(path: &Path, bytes: &[u8]) -> Result<Self, ScriptError> {
        let is_document = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("wxmx"));
        if is_document || bytes.starts_with(ARCHIVE) {
            let cells = wxmx::cells(bytes).map_err(|cause| ScriptError::Document { path: path.to_owned(), cause })?;
            return Self::of_cells(path, &cells);
        }
        let shown = decode::text(bytes).ok_or_else(|| ScriptError::NoText { path: path.to_owned() })?;
        let text = wxm::code(&shown);
        let shown = Text::new(path.display().to_string(), shown, Vec::new());
        Ok(Self { text, shown })
    }

    /// The cells one after another, each with lines of its own and statements that end.
    fn of_cells(path: &Path, cells: &[String]) -> Result<Self, ScriptError> {
        let (mut text, mut starts, mut open) = (String::new(), Vec::new(), None);
        for (before, cell) in cells.iter().enumerate() {
            let start = text.len();
            starts.push(Cell { start, number: before + 1 });
            open = open.or_else(|| unclosed(cell).map(|at| start + at));
            text += &wxm::ended(cell);
            text.push('\n');
        }
        let shown = Text::new(path.display().to_string(), text.clone(), starts);
        match open {
            None => Ok(Self { text, shown }),
            Some(at) => Err(ScriptError::Unclosed { text: shown, place: (at, 1).into() }),
        }
    }

    /// What Maxima reads.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The same with blanks for the statements in which these places are.
    pub(crate) fn without(&self, places: &[usize]) -> Self {
        let mut text = self.text.clone();
        for statement in statements(&self.text) {
            if places.iter().any(|place| statement.place.contains(place)) {
                let blanks: String = text[statement.place.clone()].chars().map(blanked).collect();
                text.replace_range(statement.place, &blanks);
            }
        }
        Self { text, shown: self.shown.clone() }
    }

    /// What errors show; its places are those of [`text`](Self::text).
    #[must_use]
    pub fn shown(&self) -> Text {
        self.shown.clone()
    }

    /// Places in the text, as `path:line:column`, in a document with the number of the cell.
    pub fn places(&self, starts: impl Iterator<Item = usize>) -> Vec<String> {
        self.shown.places(starts)
    }
}

/// Blanks of the same length, so that what stands behind keeps its place.
fn blanked(letter: char) -> String {
    if letter == '\n' { "\n".to_owned() } else { " ".repeat(letter.len_utf8()) }
}

#[cfg(test)]
mod tests;
