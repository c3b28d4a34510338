//! Why a crate of one's own is not written.

use std::path::{Path, PathBuf};

use closedform_project::WriteError;
use miette::Diagnostic;
use thiserror::Error;

/// Why nothing was written, or not all.
#[derive(Debug, Error, Diagnostic)]
pub enum OwnCrateError {
    /// The folder is a file.
    #[error("{} is a file", .0.display())]
    #[diagnostic(help("name the folder that the crate is to stand in"))]
    File(PathBuf),
    /// The folder holds something that is no crate.
    #[error("{} holds something else", .0.display())]
    #[diagnostic(help("name a folder that is new or empty, or one that holds a crate"))]
    SomethingElse(PathBuf),
    /// The folder of a new project is not empty.
    #[error("{} holds something already", .0.display())]
    #[diagnostic(help("name a folder that is new or empty"))]
    NotEmpty(PathBuf),
    /// A workspace without a package.
    #[error("{} is a workspace, not a crate", .0.display())]
    #[diagnostic(help("name a folder in it"))]
    Workspace(PathBuf),
    /// A manifest that cannot be read.
    #[error("{} is no manifest: {cause}", path.display())]
    #[diagnostic(help("mend it, or name another folder"))]
    Manifest {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        cause: toml::de::Error,
    },
    /// A folder that leads elsewhere.
    #[error("{} is a link", .0.display())]
    #[diagnostic(help("generated files are written into folders only: make it a folder, or name another place"))]
    Link(PathBuf),
    /// A file of somebody else.
    #[error("{} was not generated", .0.display())]
    #[diagnostic(help("a file without the mark of this command is never touched: rename it, or rename the worksheet"))]
    Foreign(PathBuf),
    /// The kernels of a project with contracts.
    #[error("{} belongs to a project: it is generated from {}", out.display(), worksheets.display())]
    #[diagnostic(help("put the worksheet there and say `closedform generate`, or name another folder"))]
    Project {
        /// The crate.
        out: PathBuf,
        /// The folder of the project's worksheets.
        worksheets: PathBuf,
    },
    /// Two worksheets of one module.
    #[error("{} was made from another worksheet: {first_line}", path.display())]
    #[diagnostic(help("rename one of the two worksheets, so that each has a module of its own"))]
    OtherWorksheet {
        /// The module.
        path: PathBuf,
        /// What it says of itself.
        first_line: String,
    },
    /// A file cannot be read or written.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Write(#[from] WriteError),
    /// No runtime to depend on.
    #[error("there is no runtime at {}", .0.display())]
    #[diagnostic(help(
        "say where it is: `--runtime FOLDER`, `--runtime URL` of a git repository, or `--runtime version`"
    ))]
    NoRuntime(PathBuf),
}

impl OwnCrateError {
    /// A file or folder that cannot be written.
    pub fn write(path: &Path, cause: std::io::Error) -> Self {
        WriteError::new(path, cause).into()
    }
}
