//! S-expressions: atoms, strings and lists, with their places.

use std::ops::Range;

use closedform_maxima::NESTING_LIMIT;

use super::mistake::CoreMistake;

/// An S-expression.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) kind: NodeKind,
    pub(super) span: Range<usize>,
}

/// What it is.
#[derive(Debug)]
pub(super) enum NodeKind {
    /// A name, a number or a word like `:pre`.
    Atom(String),
    /// `"text"`, without quotes and escapes.
    Text(String),
    /// What stands in brackets.
    List(Vec<Node>),
}

impl Node {
    /// The name, number or word.
    pub(super) fn atom(&self) -> Option<&str> {
        match &self.kind {
            NodeKind::Atom(name) => Some(name),
            _ => None,
        }
    }

    /// The parts of a list.
    pub(super) fn list(&self) -> Option<&[Node]> {
        match &self.kind {
            NodeKind::List(parts) => Some(parts),
            _ => None,
        }
    }
}

/// What stands open: its bracket, where it opens, and what it holds so far.
type Open = (char, usize, Vec<Node>);

/// The S-expressions of a text, as far as it goes, and what ends it too early.
pub(super) fn nodes(text: &str) -> (Vec<Node>, Option<CoreMistake>) {
    let (mut whole, mut open, mut at): (Vec<Node>, Vec<Open>, usize) = (Vec::new(), Vec::new(), 0);
    while let Some(letter) = text[at..].chars().next() {
        let start = at;
        at += letter.len_utf8();
        let made = match letter {
            ';' => {
                at = text[at..].find('\n').map_or(text.len(), |end| at + end);
                None
            }
            '(' | '[' if open.len() == NESTING_LIMIT => {
                let remedy = "give a part a name with let";
                return (whole, Some(CoreMistake::new("nested too deep", remedy, start..at)));
            }
            '(' | '[' => {
                open.push((letter, start, Vec::new()));
                None
            }
            ')' | ']' => match open.pop().filter(|(bracket, ..)| closes(*bracket, letter)) {
                Some((_, start, parts)) => Some((NodeKind::List(parts), start)),
                None => return (whole, Some(unbalanced(letter, start..at))),
            },
            '"' => match string(&text[at..]) {
                Some((content, len)) => {
                    at += len;
                    Some((NodeKind::Text(content), start))
                }
                None => {
                    let mistake = CoreMistake::new("string without end", "close it with `\"`", start..at);
                    return (whole, Some(mistake));
                }
            },
            _ if letter.is_whitespace() => None,
            _ => {
                at = text[at..].find(ends_atom).map_or(text.len(), |end| at + end);
                Some((NodeKind::Atom(text[start..at].to_owned()), start))
            }
        };
        let node = made.map(|(kind, start)| Node { kind, span: start..at });
        open.last_mut().map_or(&mut whole, |(.., parts)| parts).extend(node);
    }
    let torn = open.pop().map(|(bracket, start, _)| unbalanced(bracket, start..start + 1));
    (whole, torn)
}

fn closes(open: char, close: char) -> bool {
    matches!((open, close), ('(', ')') | ('[', ']'))
}

fn unbalanced(bracket: char, place: Range<usize>) -> CoreMistake {
    CoreMistake::new(format!("`{bracket}` without its counterpart"), "add it, or remove this one", place)
}

fn ends_atom(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, '(' | ')' | '[' | ']' | '"' | ';')
}

/// The content of a string, and its length with the closing quote.
fn string(text: &str) -> Option<(String, usize)> {
    let (mut content, mut letters) = (String::new(), text.char_indices());
    while let Some((at, letter)) = letters.next() {
        match letter {
            '"' => return Some((content, at + 1)),
            '\\' => content.push(letters.next()?.1),
            _ => content.push(letter),
        }
    }
    None
}
