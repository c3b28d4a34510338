//! Why a kernel is not found.

use std::path::PathBuf;

use miette::Diagnostic;
use thiserror::Error;

use closedform_project::ReadError;

/// Why a kernel is not found.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum CatalogueError {
    /// A file or folder cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// A source is not what the generator writes.
    #[error("{} is not kernel language: {}", path.display(), messages(cause))]
    #[diagnostic(help("`closedform generate` makes a generated file anew; correct one that is written by hand"))]
    NotKernels {
        /// The file.
        path: PathBuf,
        /// Everything that is wrong.
        cause: syn::Error,
    },
    /// Nothing was generated yet.
    #[error("no kernels below {}", root.display())]
    #[diagnostic(help(
        "run `closedform generate` in a project, or name one with --root; `closedform new NAME` makes one, and `closedform generate \
         --input NAME.mac --out DIR` a crate of a worksheet alone"
    ))]
    NoKernels {
        /// Where they were looked for.
        root: PathBuf,
    },
    /// No kernel of this name.
    #[error("no kernel is called `{name}`")]
    #[diagnostic(help("{}", did_you_mean(nearest)))]
    Unknown {
        /// The name.
        name: String,
        /// The names nearest to it.
        nearest: Vec<String>,
    },
    /// A name that several kernels have.
    #[error("`{name}` is the name of several kernels")]
    #[diagnostic(help("say which: {}", candidates.join(", ")))]
    Ambiguous {
        /// The name.
        name: String,
        /// The kernels.
        candidates: Vec<String>,
    },
}

fn messages(cause: &syn::Error) -> String {
    let messages: Vec<String> = cause.into_iter().map(|error| error.to_string()).collect();
    messages.join("; ")
}

/// What to say of a name that is none, by those nearest to it.
#[must_use]
pub fn did_you_mean(nearest: &[String]) -> String {
    let meant = if nearest.is_empty() { String::new() } else { format!("did you mean {}? ", nearest.join(", ")) };
    format!("{meant}`closedform list` names all kernels")
}
