//! The words and marks that Maxima text is made of.

use std::fmt;
use std::ops::Range;

use num_bigint::BigInt;

/// A word or mark and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Range<usize>,
}

/// What a token is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum TokenKind {
    /// `12` or `12.`
    Integer(BigInt),
    /// `1.5`, as written.
    Float(String),
    /// `1b3`, as written.
    BigFloat(String),
    /// `"text"`, without quotes and escapes.
    String(String),
    /// A name, without escapes.
    Symbol(String),
    /// An operator, a bracket or a reserved word.
    Mark(&'static str),
    /// An operator that the text declares, by its name.
    Declared(String),
    /// Nothing more comes.
    End,
}

impl fmt::Display for TokenKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integer(_) | Self::Float(_) | Self::BigFloat(_) => write!(f, "a number"),
            Self::String(_) => write!(f, "a string"),
            Self::Symbol(name) => write!(f, "the name `{name}`"),
            Self::Mark(mark) => write!(f, "`{mark}`"),
            Self::Declared(name) => write!(f, "the operator `{name}`"),
            Self::End => write!(f, "the end of the text"),
        }
    }
}

/// The reserved words.
pub(crate) const WORDS: [&str; 15] = [
    "if", "then", "else", "elseif", "for", "from", "step", "next", "thru", "while", "unless", "do", "and", "or", "not",
];

/// The marks, longer ones before those they begin with.
pub(crate) const MARKS: [&str; 31] = [
    "::=", "::", ":=", ":", "''", "'", "!!", "!", "**", "*", "^^", "^", "<=", "<", ">=", ">", "+", "-", "/", ".", "=",
    "#", "@", ",", "(", ")", "[", "]", "{", "}", ";",
];

/// The terminator that keeps Maxima quiet.
pub(crate) const HIDE: &str = "$";
