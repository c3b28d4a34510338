//! Text files of a family, read so that an error can point into them.

mod text;

use std::path::{Path, PathBuf};

use miette::Diagnostic;
use thiserror::Error;

pub use text::{Cell, Text};

/// A file that could not be read.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot read {}: {cause}", path.display())]
#[diagnostic(help("{remedy}"))]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    pub cause: std::io::Error,
    /// What makes the file readable.
    pub remedy: String,
}

/// The text of a file, or why there is none; `remedy` says what to do about it.
pub fn read(path: &Path, remedy: impl Into<String>) -> Result<String, ReadError> {
    std::fs::read_to_string(path).map_err(|cause| ReadError { path: path.to_owned(), cause, remedy: remedy.into() })
}

/// The bytes of a file, or why there are none.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, ReadError> {
    let remedy = "get the right to read it".to_owned();
    std::fs::read(path).map_err(|cause| ReadError { path: path.to_owned(), cause, remedy })
}

/// How many mistakes are worth showing at once.
pub const SHOWN: usize = 100;

/// How many mistakes there are, and whether all of them are shown.
pub fn count(mistakes: usize) -> String {
    match mistakes {
        1 => "1 mistake".to_owned(),
        2..=SHOWN => format!("{mistakes} mistakes"),
        _ => format!("{mistakes} mistakes, of which the first {SHOWN} are shown"),
    }
}

/// Places in a text, as `path:line:column`.
pub fn places(path: &Path, text: &str, starts: impl Iterator<Item = usize>) -> Vec<String> {
    named(path, text).places(starts)
}

/// A text under its path, for errors that draw carets.
pub fn named(path: &Path, text: &str) -> Text {
    Text::new(path.display().to_string(), text.to_owned(), Vec::new())
}

#[cfg(test)]
mod tests {
    use miette::SourceSpan;

    use super::*;
    use crate::drawn::{drawn, has};

    #[derive(Debug, Error, Diagnostic)]
    #[error("wrong")]
    struct Wrong {
        #[source_code]
        text: Text,
        #[label("here")]
        span: SourceSpan,
    }

    fn report(text: &str, span: std::ops::Range<usize>) -> String {
        drawn(&Wrong { text: named(Path::new("a.mac"), text), span: span.into() })
    }

    #[test]
    fn places_are_lines_and_columns() {
        let text = "f(x):=x$\n \u{e4}g(x):=x$";
        assert_eq!(places(Path::new("a.mac"), text, [0, 12].into_iter()), ["a.mac:1:1", "a.mac:2:3"]);
    }

    #[test]
    fn a_short_text_is_shown_with_its_lines() {
        has(&report("one\ntwo\nthree", 4..7), &["a.mac:2:1", "one", "two", "three"]);
    }

    #[test]
    fn a_long_line_is_cut_around_the_place() {
        let long = format!("f(x):=x$\ng(x):={}+oops+{}$\nh(x):=x$\n", "x+\u{e4}+".repeat(20_000), "x+".repeat(50_000));
        let place = long.find("oops").unwrap();
        let said = report(&long, place..place + 4);
        has(&said, &["x+\u{e4}+", "+oops+x+", "a.mac:2:", "here"]);
        assert!(said.len() < 1_000, "{said}");
        // however long the place is itself
        let said = report(&long, 9..long.len() - 12);
        assert!(said.len() < 4_000 && said.contains("g(x):=x+"), "{said}");
        for end in [0, long.len()] {
            assert!(report(&long, end..end).len() < 4_000);
        }
    }

    #[test]
    fn cells_have_lines_of_their_own() {
        let cells = vec![Cell { start: 0, number: 1 }, Cell { start: 16, number: 3 }];
        let text = Text::new("a.wxmx".to_owned(), "f(x):=x$\ng: 1;\n\nh: oops;\n".to_owned(), cells);
        let report = |place: std::ops::Range<usize>| drawn(&Wrong { text: text.clone(), span: place.into() });
        has(&report(19..23), &["a.wxmx, input cell 3:1:4", "h: oops"]);
        assert!(!report(19..23).contains("g: 1"), "{}", report(19..23));
        has(&report(9..10), &["a.wxmx, input cell 1:2:1", "f(x):=x", "g: 1"]);
        has(&report(25..25), &["a.wxmx, input cell 3"]);
        assert_eq!(text.places([9, 19].into_iter()), ["a.wxmx, input cell 1:2:1", "a.wxmx, input cell 3:1:4"]);
    }
}
