//! A text that errors point into: of a long line they show what stands around the place, of a document with cells the
//! lines of the cell.

use std::borrow::Cow;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

/// A text under its name, for errors that draw carets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Text {
    name: String,
    text: String,
    cells: Vec<Cell>,
}

/// A part of a text that counts its own lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// Where it begins; it ends where the next one begins.
    pub start: usize,
    /// The how-manieth it is in its document, from 1.
    pub number: usize,
}

/// The longest piece of text that is shown whole, in bytes, and how much of a longer one stands on each side of the place.
const LONGEST: usize = 600;
const AROUND: usize = 60;

impl Text {
    /// A text of these cells, which are in its order; one without cells is one piece.
    #[must_use]
    pub fn new(name: String, text: String, cells: Vec<Cell>) -> Self {
        Self { name, text, cells }
    }

    /// Places in the text, as `name:line:column`.
    pub fn places(&self, starts: impl Iterator<Item = usize>) -> Vec<String> {
        let place = |start: usize| {
            let part = self.part_of(start);
            let (at, text) = (letter_at(part.text, start - part.start), part.text);
            let (line, column) = (text[..at].matches('\n').count(), text[line_start(text, at)..at].chars().count());
            format!("{}:{}:{}", part.name, line + 1, column + 1)
        };
        starts.map(place).collect()
    }

    fn part_of(&self, place: usize) -> Part<'_> {
        let after = self.cells.partition_point(|cell| cell.start <= place);
        let Some(cell) = after.checked_sub(1).and_then(|at| self.cells.get(at)) else {
            return Part { name: Cow::Borrowed(&self.name), text: &self.text, start: 0 };
        };
        let end = self.cells.get(after).map_or(self.text.len(), |next| next.start);
        let name = Cow::Owned(format!("{}, input cell {}", self.name, cell.number));
        Part { name, text: &self.text[cell.start..end], start: cell.start }
    }
}

impl SourceCode for Text {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let part = self.part_of(span.offset());
        let within = SourceSpan::from((span.offset() - part.start, span.len()));
        let shown = part.excerpt(&within, before, after)?;
        let place = SourceSpan::from((part.start + shown.span().offset(), shown.span().len()));
        let (line, column, lines) = (shown.line(), shown.column(), shown.line_count());
        Ok(Box::new(MietteSpanContents::new_named(part.name.into_owned(), shown.data(), place, line, column, lines)))
    }
}

/// What counts its lines together.
struct Part<'a> {
    name: Cow<'a, str>,
    text: &'a str,
    /// Where it begins in the whole.
    start: usize,
}

impl<'a> Part<'a> {
    /// The lines of a place, or of a long line the letters around it.
    fn excerpt(
        &self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let text = self.text;
        let whole = text.read_span(span, before, after)?;
        if whole.data().len() <= LONGEST {
            return Ok(whole);
        }
        let line = text.read_span(span, 0, 0)?;
        let place = letter_at(text, span.offset());
        let start = letter_at(text, place.saturating_sub(AROUND)).max(line_start(text, place));
        let end = letter_at(text, place + span.len().min(LONGEST) + AROUND);
        let piece = &text[start..end];
        let piece = &piece[..piece[place - start..].find('\n').map_or(piece.len(), |at| place - start + at)];
        let column = text[line_start(text, place)..start].chars().count();
        let place = (start, piece.len()).into();
        Ok(Box::new(MietteSpanContents::new(piece.as_bytes(), place, line.line(), column, 1)))
    }
}

/// The nearest place at or before this one where a letter begins.
fn letter_at(text: &str, place: usize) -> usize {
    let place = place.min(text.len());
    (0..=place).rev().find(|place| text.is_char_boundary(*place)).unwrap_or(0)
}

fn line_start(text: &str, place: usize) -> usize {
    text[..place].rfind('\n').map_or(0, |at| at + 1)
}
