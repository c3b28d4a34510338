//! What can be wrong with the file of a worksheet, before anything of it is read as Maxima.

use std::path::PathBuf;

use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::wxmx::DocumentError;
use crate::source::{ReadError, Text};

/// Why a file gives no text.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ScriptError {
    /// The file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The file is larger than any worksheet.
    #[error("{} has more than {most} MiB: it is no worksheet", path.display())]
    #[diagnostic(help(
        "name a worksheet: a Maxima text (.mac, .dem), what wxMaxima saves (.wxm, .wxmx), or FPCores (.fpcore)"
    ))]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// How many are read.
        most: u64,
    },
    /// The file is no text.
    #[error("{} is no text", path.display())]
    #[diagnostic(help(
        "name a worksheet: a Maxima text (.mac, .dem), what wxMaxima saves (.wxm, .wxmx), or FPCores (.fpcore)"
    ))]
    NoText {
        /// The file.
        path: PathBuf,
    },
    /// The document is damaged, or none of wxMaxima.
    #[error("{} cannot be read as a document of wxMaxima: {cause}", path.display())]
    #[diagnostic(help(
        "open it in wxMaxima, which may repair it, and save it again; a text in Maxima's language ends in .mac"
    ))]
    Document {
        /// The file.
        path: PathBuf,
        /// Why not.
        cause: DocumentError,
    },
    /// A cell with a comment or string that it does not close.
    #[error("a comment or string does not end in its cell")]
    #[diagnostic(help("close it with `*/` or `\"`: wxMaxima sends every cell to Maxima by itself"))]
    Unclosed {
        /// The cells.
        #[source_code]
        text: Text,
        /// Where it begins.
        #[label("begins here")]
        place: SourceSpan,
    },
}
