//! A worksheet cut into its statements, as Maxima's batch reader cuts it.

use std::ops::Range;

/// One statement, with its terminator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// Bytes of the worksheet, from the first letter to the `;` or `$`.
    pub place: Range<usize>,
    /// Whether a `;` or `$` ends it; only the last statement can lack one.
    pub ended: bool,
}

/// The statements of a worksheet in order; comments and the space between statements belong to none.
pub fn statements(text: &str) -> Vec<Statement> {
    let mut found = Vec::new();
    let mut start = None;
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let token = token_len(rest);
        let blank = rest.starts_with("/*") || rest.starts_with(char::is_whitespace);
        if !blank {
            let first = *start.get_or_insert(at);
            if rest.starts_with([';', '$']) {
                found.push(Statement { place: first..at + token, ended: true });
                start = None;
            }
        }
        at += token;
    }
    found.extend(start.map(|first| Statement { place: first..text.trim_end().len().max(first), ended: false }));
    found
}

/// Where a comment or string begins that is never closed.
pub fn unclosed(text: &str) -> Option<usize> {
    let mut at = 0;
    while at < text.len() {
        at += match enclosed_len(&text[at..]) {
            Some(None) => return Some(at),
            Some(Some(len)) => len,
            None => token_len(&text[at..]),
        };
    }
    None
}

/// Length of what must be kept together at the start of a text: a comment, a string, an escaped letter, a letter.
fn token_len(text: &str) -> usize {
    if let Some(len) = enclosed_len(text) {
        return len.unwrap_or(text.len());
    }
    let mut chars = text.chars();
    match chars.next() {
        Some('\\') => 1 + chars.next().map_or(0, char::len_utf8),
        first => first.map_or(0, char::len_utf8),
    }
}

/// Length of the comment or string that a text begins with, or no length if it is never closed.
fn enclosed_len(text: &str) -> Option<Option<usize>> {
    if text.starts_with("/*") {
        return Some(comment_len(text));
    }
    text.starts_with('"').then(|| string_len(text))
}

/// Comments nest.
fn comment_len(text: &str) -> Option<usize> {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        let rest = &text.as_bytes()[at..];
        let (deeper, step) = match (rest.starts_with(b"/*"), rest.starts_with(b"*/")) {
            (true, _) => (1, 2),
            (_, true) => (-1, 2),
            _ => (0, 1),
        };
        depth += deeper;
        at += step;
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

fn string_len(text: &str) -> Option<usize> {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            '"' if !escaped => return Some(at + 1),
            _ => escaped = c == '\\' && !escaped,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(worksheet: &str) -> Vec<&str> {
        statements(worksheet).into_iter().map(|statement| &worksheet[statement.place]).collect()
    }

    #[test]
    fn statements_end_where_maxima_ends_them() {
        let worksheet = "/* a; /* nested $ */ ; */ x: 1$\n f(x) := \"a;\\\"$\"; y\\$z; /*;*/ last";
        assert_eq!(texts(worksheet), ["x: 1$", "f(x) := \"a;\\\"$\";", "y\\$z;", "last"]);
    }

    #[test]
    fn what_never_ends_is_told_apart() {
        assert!(!statements("x: \"never closed $").last().is_some_and(|last| last.ended));
        assert!(!statements("x: 1$ y: é").last().is_some_and(|last| last.ended));
        assert!(statements("/* é never closed").is_empty());
        assert!(statements("").is_empty());
        for (text, open) in [("x: \"a", Some(3)), ("/* \" */ /* b", Some(8)), ("\"/*\" x\\\" /**/", None), ("", None)] {
            assert_eq!(unclosed(text), open, "{text}");
        }
    }
}
