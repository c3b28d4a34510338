//! What can be wrong with a Maxima text.

use std::ops::Range;

use miette::Diagnostic;
use thiserror::Error;

use crate::parse::{HEIGHT_LIMIT, NESTING_LIMIT};
use crate::token::WORDS;

/// How many digits a number may have: more than any result keeps, few enough to be read at once.
pub const DIGIT_LIMIT: usize = 10_000;

/// One thing wrong with a text, where, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[non_exhaustive]
pub enum Error {
    /// A character that Maxima text has no use for, often from a scan.
    #[error("unknown character `{character}`")]
    #[diagnostic(help("{}", advice(*character)))]
    UnknownCharacter {
        /// The character.
        character: char,
        /// Where it stands.
        #[label("not Maxima")]
        span: Range<usize>,
    },
    /// A comment that is never closed.
    #[error("comment without end")]
    #[diagnostic(help("close it with `*/`; comments nest, so every `/*` needs one"))]
    UnterminatedComment {
        /// Where it begins.
        #[label("begins here")]
        span: Range<usize>,
    },
    /// A string that is never closed.
    #[error("string without end")]
    #[diagnostic(help("close it with `\"`; a quote inside a string is written `\\\"`"))]
    UnterminatedString {
        /// Where it begins.
        #[label("begins here")]
        span: Range<usize>,
    },
    /// A number without digits after its point or exponent letter.
    #[error("malformed number")]
    #[diagnostic(help("write numbers like `12`, `1.5`, `1.5e-3` or `1.5b-3`; a product needs its `*`: `2*x`"))]
    MalformedNumber {
        /// Where it stands.
        #[label("digits are missing here")]
        span: Range<usize>,
    },
    /// A number that takes longer to read than anybody waits for.
    #[error("number of more than {DIGIT_LIMIT} digits")]
    #[diagnostic(help("round it: no result keeps more than some seventeen digits"))]
    LongNumber {
        /// Where it stands.
        #[label("too many digits")]
        span: Range<usize>,
    },
    /// A token where another kind of token must stand.
    #[error("expected {expected}, found {found}")]
    #[diagnostic(help("{}", remedy(found)))]
    UnexpectedToken {
        /// What stands there.
        found: String,
        /// What could stand there.
        expected: &'static str,
        /// Where.
        #[label("expected {expected}")]
        span: Range<usize>,
    },
    /// A reserved word where a name or an expression must stand, or beside which one is missing.
    #[error("`{word}` is a keyword of Maxima, not a name, and an expression is missing beside it")]
    #[diagnostic(help(
        "if it is meant as a name, choose another one, such as `{word}_1`: Maxima reserves {}. If the keyword is meant, \
         write what belongs before and after it",
        reserved()
    ))]
    Keyword {
        /// The word.
        word: &'static str,
        /// Where it stands.
        #[label("a keyword")]
        span: Range<usize>,
    },
    /// A bracket that is not closed, or closed by one of another kind.
    #[error("`{bracket}` without its `{closing}`")]
    #[diagnostic(help("add `{closing}`, or remove `{bracket}`"))]
    UnclosedBracket {
        /// The opening bracket.
        bracket: &'static str,
        /// What closes it.
        closing: &'static str,
        /// Where it opens.
        #[label("opened here")]
        open: Range<usize>,
        /// Where it should be closed at the latest.
        #[label("should be closed before this")]
        span: Range<usize>,
    },
    /// A statement that does not end.
    #[error("statement without end")]
    #[diagnostic(help("end it with `;` or `$`"))]
    MissingTerminator {
        /// Where the statement is.
        #[label("this statement")]
        span: Range<usize>,
    },
    /// An equation or condition where a quantity must stand, or the other way round.
    #[error("`{operator}` needs {needs} as its operand")]
    #[diagnostic(help("put the operand into parentheses if it is meant, as Maxima demands"))]
    OperandMode {
        /// The operator.
        operator: &'static str,
        /// What it needs.
        needs: &'static str,
        /// Where the operand stands.
        #[label("not {needs}")]
        span: Range<usize>,
    },
    /// A loop word given twice, or one that does not go with another.
    #[error("`{word}` does not fit into this loop")]
    #[diagnostic(help("give every word once; `in` goes with `for`, `while` and `unless` only"))]
    LoopWord {
        /// The word.
        word: &'static str,
        /// Where it stands.
        #[label("given twice, or contradicts `in`")]
        span: Range<usize>,
    },
    /// More brackets and operators inside each other than this parser follows.
    #[error("nested deeper than {NESTING_LIMIT} levels")]
    #[diagnostic(help("give a part of the expression a name: `part: ..$`"))]
    TooDeep {
        /// Where the limit is reached.
        #[label("level {NESTING_LIMIT} is here")]
        span: Range<usize>,
    },
    /// More operators in a row than this parser follows.
    #[error("more than {HEIGHT_LIMIT} operators in a row")]
    #[diagnostic(help("give a part of the expression a name, or put parentheses around parts of the sum"))]
    TooLong {
        /// Where the limit is reached.
        #[label("operator {HEIGHT_LIMIT} is here")]
        span: Range<usize>,
    },
    /// A statement that defines no function, where only definitions may stand.
    #[error("not a definition")]
    #[diagnostic(help("write `f(x,y):=body` or `define(f(x,y),body)`; parameters are names"))]
    NotADefinition {
        /// Where the statement is.
        #[label("this statement")]
        span: Range<usize>,
    },
    /// A function that is defined twice.
    #[error("`{name}` is defined twice")]
    #[diagnostic(help("remove or rename one of the two"))]
    DefinedTwice {
        /// The function.
        name: String,
        /// Where it is defined first.
        #[label("first here")]
        first: Range<usize>,
        /// Where it is defined again.
        #[label("and again here")]
        span: Range<usize>,
    },
}

impl Error {
    /// Where the mistake is; of several places the one that names it best.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::UnclosedBracket { open, .. } => open.clone(),
            Self::UnknownCharacter { span, .. }
            | Self::UnterminatedComment { span }
            | Self::UnterminatedString { span }
            | Self::MalformedNumber { span }
            | Self::LongNumber { span }
            | Self::UnexpectedToken { span, .. }
            | Self::Keyword { span, .. }
            | Self::MissingTerminator { span }
            | Self::OperandMode { span, .. }
            | Self::LoopWord { span, .. }
            | Self::TooDeep { span }
            | Self::TooLong { span }
            | Self::NotADefinition { span }
            | Self::DefinedTwice { span, .. } => span.clone(),
        }
    }
}

/// Everything wrong with a text, in its order; at least one error.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[error("not Maxima text: {} {}", errors.len(), if errors.len() == 1 { "error" } else { "errors" })]
pub struct Errors {
    /// The errors.
    #[related]
    pub errors: Vec<Error>,
}

impl From<Error> for Errors {
    fn from(error: Error) -> Self {
        Self { errors: vec![error] }
    }
}

/// What to write instead of a character that scans and word processors put in.
fn advice(character: char) -> &'static str {
    match character {
        '·' | '×' | '∙' | '⋅' => "write `*`",
        '÷' | '⁄' | '∕' => "write `/`",
        '−' | '–' | '—' | '‐' | '‑' => "write `-`",
        '²' => "write `^2`",
        '³' => "write `^3`",
        '√' => "write `sqrt(..)`",
        '≤' => "write `<=`",
        '≥' => "write `>=`",
        '≠' => "write `#`",
        '∞' => "write `inf`",
        '“' | '”' | '„' => "write `\"`",
        '‘' | '’' => "write `'`",
        '\\' => "a backslash quotes the character after it, but the text ends here",
        _ => "remove it, or write `\\` before it if it is part of a name",
    }
}

fn reserved() -> String {
    WORDS.map(|word| format!("`{word}`")).join(", ")
}

fn remedy(found: &str) -> &'static str {
    match found {
        "a number" | "a string" => "a product needs its `*`, the noncommutative product blanks around its `.`",
        "`)`" | "`]`" | "`}`" => "remove it, or open it before",
        "nothing" => "write it between the brackets",
        "the end of the text" => "finish the expression",
        found if found.starts_with("the name") => "a product needs its `*`",
        "`=`" | "`>`" => "an equation is written `a=b`, `a#b` if it must not hold, a comparison `>=` or `<=`",
        _ => "add what is missing before it, or remove it",
    }
}
