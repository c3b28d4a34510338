//! Text files of a family, read so that an error can point into them.

use std::path::{Path, PathBuf};

use miette::{Diagnostic, NamedSource};
use thiserror::Error;

/// A file that could not be read.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot read {}: {cause}", path.display())]
#[diagnostic(help("{remedy}"))]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    #[source]
    pub cause: std::io::Error,
    /// What makes the file readable.
    pub remedy: String,
}

/// The text of a file, or why there is none; `remedy` says what to do about it.
pub fn read(path: &Path, remedy: impl Into<String>) -> Result<String, ReadError> {
    std::fs::read_to_string(path).map_err(|cause| ReadError { path: path.to_owned(), cause, remedy: remedy.into() })
}

/// A text under its path, for errors that draw carets.
pub fn named(path: &Path, text: &str) -> NamedSource<String> {
    NamedSource::new(path.display().to_string(), text.to_owned())
}
