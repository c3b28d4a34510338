//! Text files of a family, read so that an error can point into them.

use std::path::{Path, PathBuf};

use miette::{Diagnostic, MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents};
use thiserror::Error;

/// A file that could not be read.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot read {}: {cause}", path.display())]
#[diagnostic(help("{remedy}"))]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    #[source]
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
    let place = |start: usize| {
        let (before, line) = (&text[..start], line_start(text, start));
        format!("{}:{}:{}", path.display(), before.matches('\n').count() + 1, text[line..start].chars().count() + 1)
    };
    starts.map(place).collect()
}

/// A text under its path, for errors that draw carets.
pub type Text = NamedSource<Excerpt>;

/// A text under its path, for errors that draw carets.
pub fn named(path: &Path, text: &str) -> Text {
    NamedSource::new(path.display().to_string(), Excerpt(text.to_owned()))
}

/// A text that errors show the line of, or of a long line the letters around the place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt(String);

/// The longest piece of text that is shown whole, in bytes, and how much of a longer one stands on each side of the place.
const LONGEST: usize = 600;
const AROUND: usize = 60;

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.0.read_span(span, before, after)?;
        if whole.data().len() <= LONGEST {
            return Ok(whole);
        }
        let line = self.0.read_span(span, 0, 0)?;
        let start = self.letter_at(span.offset().saturating_sub(AROUND)).max(line_start(&self.0, span.offset()));
        let end = self.letter_at(span.offset() + span.len().min(LONGEST) + AROUND);
        let piece = &self.0[start..end];
        let piece =
            &piece[..piece[span.offset() - start..].find('\n').map_or(piece.len(), |at| span.offset() - start + at)];
        let column = self.0[line_start(&self.0, span.offset())..start].chars().count();
        let place = (start, piece.len()).into();
        Ok(Box::new(MietteSpanContents::new(piece.as_bytes(), place, line.line(), column, 1)))
    }
}

impl Excerpt {
    /// The nearest place at or before this one where a letter begins.
    fn letter_at(&self, place: usize) -> usize {
        let place = place.min(self.0.len());
        (0..=place).rev().find(|place| self.0.is_char_boundary(*place)).unwrap_or(0)
    }
}

fn line_start(text: &str, place: usize) -> usize {
    text[..place].rfind('\n').map_or(0, |at| at + 1)
}

#[cfg(test)]
mod tests {
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
}
