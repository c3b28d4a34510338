//! Why the mutants of a kernel cannot be judged.

use std::path::PathBuf;

use miette::Diagnostic;
use thiserror::Error;

use closedform_measure::accuracy::ReferenceError;
use closedform_measure::catalogue::{CatalogueError, DomainError};
use closedform_project::ReadError;
use closedform_project::kept::KeptError;
use closedform_project::sample::EmptyDomain;

/// Why the mutants of a kernel cannot be judged.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum MutateError {
    /// The kernels cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Catalogue(#[from] CatalogueError),
    /// A file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The worst inputs cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Kept(#[from] KeptError),
    /// The domain is not one of a contract.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Domain(#[from] DomainError),
    /// The domain has no points.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Empty(#[from] EmptyDomain),
    /// There is nothing to compare with.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Reference(#[from] ReferenceError),
    /// The kernel is guilty itself.
    #[error("`{kernel}`, not mutated, fails at {inputs}: {what}")]
    #[diagnostic(help("run `closedform verify {kernel}`; a kernel must pass the judges before its mutants can fail"))]
    Guilty {
        /// The kernel.
        kernel: String,
        /// Names and values.
        inputs: String,
        /// What is wrong.
        what: String,
    },
    /// The file of known points is not one.
    #[error("{} is no list of points: {cause}", path.display())]
    #[diagnostic(help("an entry is [[point]] with kernel, inputs = [..] and why"))]
    Known {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        cause: Box<toml::de::Error>,
    },
    /// The list of equivalent mutants is not one.
    #[error("{} is no list of equivalent mutants: {cause}", path.display())]
    #[diagnostic(help(
        "an entry is [[equivalent]] with kernel, step, mistakes = [\"..\"] and reason, as `closedform mutants` names them"
    ))]
    Equivalents {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        cause: Box<toml::de::Error>,
    },
}
