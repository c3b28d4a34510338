//! Why kernels cannot be bound.

use closedform_project::WriteError;
use miette::Diagnostic;
use std::path::PathBuf;
use thiserror::Error;

/// Why kernels cannot be bound.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum BindError {
    /// No crate holds the kernels.
    #[error("no crate at {}: {cause}", folder.display())]
    #[diagnostic(help(
        "`closedform new` makes a project with a crate, and `closedform generate --input` a crate alone"
    ))]
    NoCrate {
        /// Where it was looked for.
        folder: PathBuf,
        /// Why there is none.
        cause: String,
    },
    /// There is nothing to bind.
    #[error("no kernel in {} is `pub`", folder.display())]
    #[diagnostic(help("write `pub fn` and `pub mod`, so that other crates can call it"))]
    NothingPublic {
        /// The crate.
        folder: PathBuf,
    },
    /// Two things have one name in the other language.
    #[error("`{first}` and `{second}` would both be called `{name}`")]
    #[diagnostic(help("give one of them another name"))]
    Clash {
        /// The name.
        name: String,
        /// One of them.
        first: String,
        /// The other.
        second: String,
    },
    /// Files of somebody else are in the way.
    #[error("{} is there, and its first line does not say that `closedform bind` wrote it", .0.display())]
    #[diagnostic(help("name another folder with --out, or move the file away"))]
    Foreign(PathBuf),
    /// The files cannot be written.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Write(#[from] WriteError),
}
