//! A place among the tokens.

use std::ops::Range;
use std::rc::Rc;

use crate::error::Error;
use crate::operator::{Form, Operator};
use crate::token::{HIDE, Token, TokenKind, WORDS};

use super::NESTING_LIMIT;

/// A place among the tokens, and how deep the expression around it is nested.
pub(super) struct Cursor<'a> {
    tokens: &'a [Token],
    operators: &'a [Rc<Operator>],
    position: usize,
    depth: usize,
}

impl<'a> Cursor<'a> {
    /// Before the first of `tokens`, the last of which is the end; with the operators that the text declares.
    pub fn new(tokens: &'a [Token], operators: &'a [Rc<Operator>]) -> Self {
        Self { tokens, operators, position: 0, depth: 0 }
    }

    /// The declared operator here that stands before its operands, or between or behind them.
    pub fn declared(&self, before: bool) -> Option<Rc<Operator>> {
        let TokenKind::Declared(name) = self.kind() else { return None };
        let stands_before = |form: &Form| matches!(form, Form::Prefix | Form::Match(_) | Form::Nofix);
        let fits = |operator: &&Rc<Operator>| operator.name == *name && stands_before(&operator.form) == before;
        self.operators.iter().find(fits).cloned()
    }

    /// Goes behind the declared operator here if it is called so.
    pub fn take_declared(&mut self, name: &str) -> bool {
        let found = matches!(self.kind(), TokenKind::Declared(here) if here == name);
        if found {
            self.advance();
        }
        found
    }

    /// Whether the text declares an operator of this name.
    pub fn is_declared(&self, name: &str) -> bool {
        self.operators.iter().any(|operator| operator.name == name)
    }

    fn token(&self) -> &'a Token {
        &self.tokens[self.position]
    }

    /// The token here.
    pub fn kind(&self) -> &'a TokenKind {
        &self.token().kind
    }

    /// The mark here, if it is one.
    pub fn mark(&self) -> Option<&'static str> {
        match self.kind() {
            TokenKind::Mark(mark) => Some(mark),
            _ => None,
        }
    }

    /// Where the token here stands.
    pub fn span(&self) -> Range<usize> {
        self.token().span.clone()
    }

    /// Where the token before this one ends.
    pub fn end_of_previous(&self) -> usize {
        self.position.checked_sub(1).map_or(0, |previous| self.tokens[previous].span.end)
    }

    /// The next four tokens, if there are four.
    pub fn look_ahead(&self) -> Option<[&'a TokenKind; 4]> {
        let next = self.tokens.get(self.position..self.position + 4)?;
        Some([&next[0].kind, &next[1].kind, &next[2].kind, &next[3].kind])
    }

    /// Goes behind the token here, never behind the end.
    pub fn advance(&mut self) {
        self.position = (self.position + 1).min(self.tokens.len() - 1);
    }

    /// Goes behind the token here if it is `mark`.
    pub fn take(&mut self, mark: &str) -> bool {
        let found = self.mark() == Some(mark);
        if found {
            self.advance();
        }
        found
    }

    /// Goes behind the next terminator, or to the end.
    pub fn skip_statement(&mut self) {
        self.depth = 0;
        while !self.ends_statement() {
            self.advance();
        }
        self.advance();
    }

    /// Whether a terminator or the end is here.
    pub fn ends_statement(&self) -> bool {
        matches!(self.kind(), TokenKind::End | TokenKind::Mark(";" | HIDE))
    }

    /// The error that something else than the token here was expected.
    pub fn unexpected(&self, expected: &'static str) -> Error {
        Error::UnexpectedToken { found: self.kind().to_string(), expected, span: self.span() }
    }

    /// The error that no expression begins here: a keyword, here or just before, may have been meant as a name.
    pub fn no_expression(&self) -> Error {
        let before = self.position.checked_sub(1).map(|previous| &self.tokens[previous]);
        let keyword = |token: &Token| match token.kind {
            TokenKind::Mark(word) if WORDS.contains(&word) => Some(Error::Keyword { word, span: token.span.clone() }),
            _ => None,
        };
        let found = keyword(self.token()).or_else(|| before.and_then(keyword));
        found.unwrap_or_else(|| self.unexpected("an expression"))
    }

    /// Goes one level down.
    pub fn descend(&mut self) -> Result<(), Error> {
        self.depth += 1;
        if self.depth > NESTING_LIMIT { Err(Error::TooDeep { span: self.span() }) } else { Ok(()) }
    }

    /// Comes one level up.
    pub fn ascend(&mut self) {
        self.depth -= 1;
    }
}
