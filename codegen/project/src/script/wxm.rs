//! The code in a text that wxMaxima saved: marks in comments tell input cells from text, headings, images and answers.
//!
//! Everything else becomes blanks, so that every letter of code stays at its place. wxMaxima itself reads these marks line
//! by line and does not care what a cell of text would mean as a comment.

use std::borrow::Cow;

use crate::statements::{Statement, statements, unclosed};

/// What every mark begins with.
const MARK: &str = "[wxMaxima: ";

/// The last line, which keeps Maxima from the end of a file after a comment.
const LAST: &str = "\"Created with wxMaxima";

/// Where a line stands.
enum Place {
    /// Outside of cells: whatever people wrote there is code.
    Between,
    /// In an input cell that begins there.
    Input(usize),
    /// In a cell of another kind.
    Other(String),
}

/// The code of a text, of the same length; a text without marks is code.
pub(super) fn code(text: &str) -> String {
    if !text.contains(MARK) {
        return text.to_owned();
    }
    let (mut code, mut place, mut at) = (String::with_capacity(text.len()), Place::Between, 0);
    for line in text.split_inclusive('\n') {
        let mark = mark(line);
        match (&place, mark) {
            // an input cell begins whatever stands open: a file that was cut or joined is read on
            (_, Some((kind, Some("start")))) if kind == "input" => {
                place = Place::Input(at + line.len());
                blank(line, &mut code);
            }
            (Place::Input(start), Some((kind, Some("end")))) if kind == "input" => {
                let cell = &text[*start..at];
                place = Place::Between;
                end(cell, line, &mut code);
            }
            (Place::Input(_), _) => code.push_str(line),
            (Place::Other(open), Some((kind, Some("end")))) if *open == kind => {
                place = Place::Between;
                blank(line, &mut code);
            }
            (Place::Between, Some((kind, Some("start")))) if kind != "fold" => {
                place = Place::Other(kind);
                blank(line, &mut code);
            }
            (Place::Between, None) if !line.trim_start().starts_with(LAST) => code.push_str(line),
            _ => blank(line, &mut code),
        }
        at += line.len();
    }
    code
}

/// What the last mark of a line says: a kind of cell, and whether it starts or ends there.
fn mark(line: &str) -> Option<(String, Option<&str>)> {
    let trimmed = line.trim_start().trim_start_matches("/* ");
    let said = trimmed.starts_with(MARK).then(|| trimmed.rsplit(MARK).next())??;
    let mut words: Vec<&str> = said.split(']').next()?.split_whitespace().collect();
    let turn = words.pop_if(|word| ["start", "end"].contains(word));
    Some((words.join(" "), turn))
}

fn blank(line: &str, code: &mut String) {
    for letter in line.chars() {
        match letter {
            '\n' | '\r' => code.push(letter),
            _ => (0..letter.len_utf8()).for_each(|_| code.push(' ')),
        }
    }
}

/// A line that ends a cell, with what its last statement lacks.
fn end(cell: &str, line: &str, code: &mut String) {
    match (lacks_end(cell), line.chars().next()) {
        (true, Some(first)) if first.is_ascii() && first != '\n' => {
            code.push(';');
            blank(&line[1..], code);
        }
        _ => blank(line, code),
    }
}

/// A cell whose last statement ends, as wxMaxima sends it.
pub(super) fn ended(cell: &str) -> Cow<'_, str> {
    if lacks_end(cell) { Cow::Owned(format!("{cell};")) } else { Cow::Borrowed(cell) }
}

fn lacks_end(cell: &str) -> bool {
    let lacks = |last: &Statement| !last.ended && !cell[last.place.clone()].lines().last().is_some_and(is_command);
    unclosed(cell).is_none() && statements(cell).last().is_some_and(lacks)
}

/// Whether a line ends by itself: one for Lisp, or a question.
fn is_command(line: &str) -> bool {
    let line = line.trim_start();
    [":lisp ", ":lisp(", "? ", "?? "].iter().any(|mark| line.starts_with(mark))
}
