//! How deep and how long a source is, found on its tokens before anything recurses into it.
//!
//! The parser below us, and every walk over a tree, needs stack for each level of what it reads. The tokens are
//! counted without recursion, and rather too high than too low: no tree is higher than its count.

use closedform_arith::limits::{MAX_HEIGHT, MAX_NESTING};
use proc_macro2::token_stream::IntoIter;
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::{Error, Result};

use crate::error;

/// Keywords after which an expression, a type or a block goes on one level deeper.
const DEEPER: [&str; 18] = [
    "async", "break", "const", "dyn", "else", "fn", "for", "if", "impl", "let", "loop", "match", "move", "mut",
    "return", "unsafe", "while", "yield",
];

/// Operators of two signs.
const PAIRS: [[char; 2]; 10] = [
    ['&', '&'],
    ['|', '|'],
    ['=', '='],
    ['!', '='],
    ['<', '='],
    ['>', '='],
    ['-', '>'],
    ['=', '>'],
    [':', ':'],
    ['.', '.'],
];

/// Holds tokens against the limits.
///
/// # Errors
///
/// At the first place that is too deep, or at the beginning of what is too high.
pub fn check(tokens: TokenStream) -> Result<()> {
    let mut around: Vec<Level> = Vec::new();
    let mut level = Level::new(tokens, 0);
    loop {
        match level.tokens.next() {
            Some(TokenTree::Group(group)) => {
                let inner = level.open(&group)?;
                around.push(std::mem::replace(&mut level, inner));
            }
            Some(TokenTree::Punct(sign)) => level.sign(&sign)?,
            Some(TokenTree::Ident(word)) => level.word(&word)?,
            Some(TokenTree::Literal(literal)) => level.operand(literal.span())?,
            None => {
                level.end_run()?;
                let Some(outer) = around.pop() else { return Ok(()) };
                let height = std::mem::replace(&mut level, outer).highest;
                level.close(height);
            }
        }
    }
}

/// What stands before a token.
#[derive(Clone, Copy, PartialEq)]
enum Before {
    /// Nothing, or what asks for an operand.
    Open,
    /// An operator's sign, which another one may follow that belongs to it.
    Joint(char),
    /// An operand.
    Operand,
    /// A block, after which a statement may end.
    Block,
}

/// The tokens between two brackets, which are runs between separators: `,`, `;`, ends of blocks.
struct Level {
    tokens: IntoIter,
    /// What is around this level.
    outside: usize,
    before: Before,
    /// The brackets that were opened last.
    opened: Delimiter,
    /// Where the run began.
    start: Option<Span>,
    /// Signs and words of the run that nest what follows them.
    nested: usize,
    /// Operators between the terms of the run.
    terms: usize,
    /// Operators inside the last term.
    factors: usize,
    /// The highest brackets in the last term.
    inner: usize,
    /// The highest term of the run.
    term: usize,
    /// The highest run.
    highest: usize,
}

impl Level {
    fn new(tokens: TokenStream, outside: usize) -> Self {
        Level {
            tokens: tokens.into_iter(),
            outside,
            before: Before::Open,
            opened: Delimiter::None,
            start: None,
            nested: 0,
            terms: 0,
            factors: 0,
            inner: 0,
            term: 0,
            highest: 0,
        }
    }

    fn open(&mut self, group: &Group) -> Result<Level> {
        if self.before == Before::Operand {
            self.factors += 1;
        }
        let place = group.span_open();
        self.start.get_or_insert(place);
        self.opened = group.delimiter();
        let outside = self.outside + self.nested + 1;
        if outside > MAX_NESTING {
            return Err(Error::new(place, error::NESTING));
        }
        Ok(Level::new(group.stream(), outside))
    }

    fn close(&mut self, height: usize) {
        self.inner = self.inner.max(height + 1);
        self.before = if self.opened == Delimiter::Brace { Before::Block } else { Before::Operand };
    }

    fn word(&mut self, word: &Ident) -> Result<()> {
        let goes_on = word == "else" || word == "as";
        if self.before == Before::Block && !goes_on {
            self.end_run()?;
        }
        if word == "as" {
            self.factors += 1;
        }
        if DEEPER.iter().any(|keyword| word == keyword) {
            self.deeper(word.span())?;
            self.before = Before::Open;
            return Ok(());
        }
        self.operand(word.span())
    }

    fn operand(&mut self, place: Span) -> Result<()> {
        self.start.get_or_insert(place);
        self.before = Before::Operand;
        Ok(())
    }

    fn deeper(&mut self, place: Span) -> Result<()> {
        self.start.get_or_insert(place);
        self.nested += 1;
        if self.outside + self.nested > MAX_NESTING {
            return Err(Error::new(place, error::NESTING));
        }
        Ok(())
    }

    fn sign(&mut self, sign: &Punct) -> Result<()> {
        let (char, place) = (sign.as_char(), sign.span());
        match (self.before, char) {
            (_, ',' | ';' | '#') => return self.end_run(),
            (Before::Joint(first), second) if PAIRS.contains(&[first, second]) => {
                self.before = Before::Open;
                return if char == '>' { self.deeper(place) } else { Ok(()) };
            }
            (Before::Open | Before::Joint(_), _) => {
                self.before = Before::Open;
                return self.deeper(place);
            }
            // Generic arguments and assignments nest to the right.
            (_, '<' | '=') => self.deeper(place)?,
            (_, '*' | '/' | '%' | '.' | '?' | ':') => self.factors += 1,
            (_, _) => self.end_term(),
        }
        self.start.get_or_insert(place);
        self.before = match (char, sign.spacing()) {
            ('?', _) => Before::Operand,
            (_, Spacing::Joint) => Before::Joint(char),
            (_, Spacing::Alone) => Before::Open,
        };
        Ok(())
    }

    fn end_term(&mut self) {
        self.term = self.term.max(self.factors + self.inner);
        (self.factors, self.inner) = (0, 0);
        self.terms += 1;
    }

    fn end_run(&mut self) -> Result<()> {
        let height = self.nested + self.terms + self.term.max(self.factors + self.inner);
        let place = self.start.take().unwrap_or_else(Span::call_site);
        self.highest = self.highest.max(height);
        (self.nested, self.terms, self.factors, self.inner, self.term) = (0, 0, 0, 0, 0);
        self.before = Before::Open;
        if height > MAX_HEIGHT { Err(Error::new(place, error::HEIGHT)) } else { Ok(()) }
    }
}
