//! Why a text is no condition, and where in it.

use std::ops::Range;

use thiserror::Error;

/// Why a text is no condition.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ConditionError {
    /// Not Maxima.
    #[error("the domain condition cannot be read: {message}")]
    Syntax {
        /// What the parser says.
        message: String,
        /// Where, if it knows.
        span: Option<Range<usize>>,
    },
    /// No truth value.
    #[error("the domain condition is not a comparison")]
    NotComparison {
        /// Where.
        span: Range<usize>,
    },
    /// Something that the kernel does not take.
    #[error("the domain condition names `{name}`, which is not an input of this kernel")]
    UnknownVariable {
        /// The name.
        name: String,
        /// Where.
        span: Range<usize>,
    },
    /// Something that cannot be decided exactly.
    #[error("a side of the domain condition is not a rational function")]
    NotRational {
        /// Where.
        span: Range<usize>,
    },
    /// Something that has no value at any inputs.
    #[error("a side of the domain condition has no value anywhere: {what}")]
    NoValue {
        /// What has none.
        what: String,
        /// Where.
        span: Range<usize>,
    },
}

impl ConditionError {
    /// Where in the condition.
    pub fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::Syntax { span, .. } => span.clone(),
            Self::NotComparison { span }
            | Self::UnknownVariable { span, .. }
            | Self::NotRational { span }
            | Self::NoValue { span, .. } => Some(span.clone()),
        }
    }

    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "write a Maxima comparison such as a2Max > 0",
            Self::NotComparison { .. } => "compare with < <= > >= = #, and join comparisons with and, or, not",
            Self::UnknownVariable { .. } => "add it to the kernel's `inputs`, or correct its name",
            Self::NotRational { .. } => "use only + - * /, abs, numbers and small integer powers; square away roots",
            Self::NoValue { .. } => "correct it, or leave this comparison out: it holds at no inputs",
        }
    }

    /// What a caret says.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "here",
            Self::NotComparison { .. } => "neither true nor false",
            Self::UnknownVariable { .. } => "not an input of this kernel",
            Self::NotRational { .. } => "not rational",
            Self::NoValue { .. } => "no value",
        }
    }
}
