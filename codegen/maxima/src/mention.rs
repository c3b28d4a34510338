//! Names that a text calls, quotes or hands to something that calls: read from its tokens, whether it parses or not.

use std::ops::Range;

use crate::lex::lex;
use crate::token::{Token, TokenKind};

/// A name where it may be called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mention {
    /// The name; `?name` of a Lisp function, `:lisp` of a line in Lisp.
    pub name: String,
    /// The only argument of the call, if that is a name or a string.
    pub argument: Option<String>,
    /// Where it stands; of a name inside a string where the string stands.
    pub span: Range<usize>,
}

/// Functions that call what their first argument names.
const CALLING: [&str; 12] = [
    "apply",
    "map",
    "maplist",
    "fullmap",
    "matrixmap",
    "outermap",
    "scanmap",
    "funmake",
    "lreduce",
    "rreduce",
    "xreduce",
    "tree_reduce",
];

/// All such names, those in strings included, which may be evaluated.
#[must_use]
pub fn mentions(text: &str) -> Vec<Mention> {
    let tokens = lex(text).tokens;
    let mut found = Vec::new();
    for at in 0..tokens.len() {
        let span = tokens[at].span.clone();
        match &tokens[at].kind {
            TokenKind::Symbol(name) if name == "lisp" && at > 0 && is_command(&tokens[at - 1], &span) => {
                found.push(Mention { name: ":lisp".to_owned(), argument: None, span });
            }
            TokenKind::Symbol(name) if is_called(&tokens, at) || is_handed_on(&tokens, at) || name.starts_with('?') => {
                found.push(Mention { name: name.clone(), argument: only_argument(&tokens, at), span });
            }
            // an operator calls the function of its name
            TokenKind::Declared(name) => {
                found.push(Mention { name: name.clone(), argument: only_argument(&tokens, at), span });
            }
            TokenKind::String(inner) if is_handed_on(&tokens, at) => {
                found.push(Mention { name: inner.clone(), argument: None, span });
            }
            TokenKind::String(inner) => {
                let called = calls_in(inner);
                found.extend(called.into_iter().map(|mention| Mention { span: span.clone(), ..mention }));
            }
            _ => {}
        }
    }
    found
}

/// The names that a string calls; words with a question mark are no Lisp there.
fn calls_in(text: &str) -> Vec<Mention> {
    let called = |mention: &Mention| {
        let behind = text.get(mention.span.end..).unwrap_or_default().trim_start();
        !mention.name.starts_with('?') || behind.starts_with('(')
    };
    mentions(text).into_iter().filter(called).collect()
}

fn mark_at(tokens: &[Token], at: usize) -> Option<&'static str> {
    match tokens.get(at)?.kind {
        TokenKind::Mark(mark) => Some(mark),
        _ => None,
    }
}

fn is_called(tokens: &[Token], at: usize) -> bool {
    mark_at(tokens, at + 1) == Some("(")
}

/// Whether a quote stands before it, or the parenthesis of a function that calls it.
fn is_handed_on(tokens: &[Token], at: usize) -> bool {
    let quotes = at.checked_sub(1).and_then(|before| mark_at(tokens, before));
    let calling = at.checked_sub(2).map(|before| &tokens[before].kind);
    matches!(quotes, Some("'" | "''"))
        || quotes == Some("(") && matches!(calling, Some(TokenKind::Symbol(name)) if CALLING.contains(&name.as_str()))
}

/// Whether the token before is a colon that touches the name here.
fn is_command(before: &Token, span: &Range<usize>) -> bool {
    before.kind == TokenKind::Mark(":") && before.span.end == span.start
}

fn only_argument(tokens: &[Token], at: usize) -> Option<String> {
    let closed = mark_at(tokens, at + 1) == Some("(") && mark_at(tokens, at + 3) == Some(")");
    match &tokens.get(at + 2)?.kind {
        TokenKind::Symbol(name) | TokenKind::String(name) if closed => Some(name.clone()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<String> {
        mentions(text).into_iter().map(|mention| mention.name).collect()
    }

    #[test]
    fn what_may_be_called_is_found() {
        assert_eq!(names("system(\"ls\")$"), ["system"]);
        assert_eq!(names("sys\\tem (x)$ /* system(y) */"), ["system"]);
        assert_eq!(names("apply('system, [x])$"), ["apply", "system"]);
        assert_eq!(names("apply(system, [x])$ map(\"system\", l)$"), ["apply", "system", "map", "system"]);
        assert_eq!(names("eval_string(\"system(1)\")$"), ["eval_string", "system"]);
        assert_eq!(names("eval_string(\"eval_string(\\\"system(1)\\\")\")$"), ["eval_string", "eval_string", "system"]);
        assert_eq!(names("?run\\-program(x)$ a: ?quit$"), ["?run-program", "?quit"]);
        assert_eq!(names("x:1$\n:lisp (quit)\n"), [":lisp"]);
        assert_eq!(names("prefix(\"system\")$ x: system \"ls\"$"), ["prefix", "system"]);
        assert_eq!(names("a ~~ system(b && c)$ {{{"), ["system"], "a text that does not parse");
    }

    #[test]
    fn variables_and_words_are_none() {
        assert_eq!(names("system: [a,b]$ stress: load/area$ print(\"the system has a load?yes\")$"), ["print"]);
    }

    #[test]
    fn the_argument_is_told() {
        let argument = |text: &str| mentions(text).remove(0).argument;
        assert_eq!(argument("load(facexp)$").as_deref(), Some("facexp"));
        assert_eq!(argument("load(\"../x.lisp\")$").as_deref(), Some("../x.lisp"));
        assert_eq!(argument("load(concat(a,b))$"), None);
    }
}
