//! What a check finds.

use miette::Diagnostic;
use thiserror::Error;

/// What is not as it should be.
#[derive(Debug, Error, Diagnostic)]
pub(super) enum CheckError {
    /// Files differ from what would be generated.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("run `closedform generate`, read the difference and commit it"))]
    Stale(Vec<String>),
    /// References are older than what they were derived from.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("run `closedform derive` and `closedform generate`, read the difference and commit it"))]
    Underived(Vec<String>),
    /// Kernels whose text does not prove what it states.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("a generated kernel is never edited: run `closedform generate`"))]
    Unproved(Vec<String>),
    /// What Maxima derives or computes now is something else.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("if the worksheet is right as it is, run `closedform derive` and `closedform generate`"))]
    Changed(Vec<String>),
}
