//! What can be wrong with a core.

use std::ops::Range;

use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

/// One mistake in a text of cores, with its place.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[error("{what}")]
#[diagnostic(help("{remedy}"))]
pub struct CoreMistake {
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub remedy: String,
    /// Where.
    #[label("here")]
    pub span: SourceSpan,
}

impl CoreMistake {
    pub(crate) fn new(what: impl Into<String>, remedy: impl Into<String>, span: Range<usize>) -> Self {
        Self { what: what.into(), remedy: remedy.into(), span: span.into() }
    }
}
