//! Why there is no page of verdicts: files that cannot be read, and rows whose verdict does not stand.

use std::path::{Path, PathBuf};

use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::formula::FormulaError;
use super::problem::Problem;
use closedform_project::contract::ContractError;
use closedform_project::maxima_process::ProcessError;
use closedform_project::{
    ReadError,
    source::{self, Text},
};

/// Why there is no page.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum VerdictError {
    /// A file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The contracts that say what is shipped cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Contract(#[from] ContractError),
    /// The replay of a derivation failed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Process(#[from] ProcessError),
    /// A file says something that cannot be.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Mistakes(#[from] Mistakes),
    /// Verdicts do not stand.
    #[error("{} of the verdicts {} wrong", wrong(.0), if wrong(.0) == 1 { "is" } else { "are" })]
    #[diagnostic(help("correct the rows named below; the page of verdicts stays as it is until all are right"))]
    Wrong(#[related] Vec<Mistakes>),
    /// The order names other files than there are.
    #[error("{}: {complaint}", path.display())]
    #[diagnostic(help("name every file once, one a line, in the order of the page"))]
    Order {
        /// The list.
        path: PathBuf,
        /// What is wrong with it.
        complaint: String,
    },
}

/// All that is wrong with one file.
#[derive(Debug, Error, Diagnostic)]
#[error("{} has {}", path.display(), count(mistakes.len()))]
pub struct Mistakes {
    /// The file.
    pub path: PathBuf,
    /// Its text.
    #[source_code]
    pub text: Text,
    /// One by one.
    #[related]
    pub mistakes: Vec<Mistake>,
}

impl Mistakes {
    pub(super) fn new(path: &Path, text: &str, mistakes: Vec<Mistake>) -> Self {
        Self { path: path.to_owned(), text: source::named(path, text), mistakes }
    }
}

fn wrong(files: &[Mistakes]) -> usize {
    files.iter().map(|file| file.mistakes.len()).sum()
}

fn count(mistakes: usize) -> String {
    if mistakes == 1 { "a mistake".to_owned() } else { format!("{mistakes} mistakes") }
}

/// One mistake, with its place.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum Mistake {
    /// Not TOML, or not the keys of a file of errata.
    #[error("{message}")]
    #[diagnostic(help("book/src/errata.md shows a row with every key it may have"))]
    Toml {
        /// What the TOML reader says.
        message: String,
        /// Where.
        #[label("here")]
        span: Option<SourceSpan>,
    },
    /// Two rows of one cell.
    #[error("two rows are called `{cell}`")]
    #[diagnostic(help("give each output a name of its own"))]
    CellTwice {
        /// The cell.
        cell: String,
        /// The first row.
        #[label("first here")]
        first: SourceSpan,
        /// The second.
        #[label("again here")]
        span: SourceSpan,
    },
    /// A text that is no formula.
    #[error("{cell}: {cause}")]
    #[diagnostic(help("{}", cause.remedy()))]
    Formula {
        /// The cell.
        cell: String,
        /// What is wrong with it.
        cause: Box<FormulaError>,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },
    /// A function that no contract promises.
    #[error("{cell}: no kernel computes `{function}`")]
    #[diagnostic(help("call the `worksheet` function of a [[kernel.result]], as `closedform list` names them"))]
    NotShipped {
        /// The cell.
        cell: String,
        /// The function.
        function: String,
        /// Where.
        #[label("not shipped")]
        span: SourceSpan,
    },
    /// A call with too many or too few arguments.
    #[error("{cell}: `{function}` takes {wanted} arguments, not {found}")]
    #[diagnostic(help("give one argument for every input of the kernel, in its order"))]
    Arguments {
        /// The cell.
        cell: String,
        /// The function.
        function: String,
        /// How many are there.
        found: usize,
        /// How many it takes.
        wanted: usize,
        /// Where.
        #[label("{found} given")]
        span: SourceSpan,
    },
    /// An element of a list that there cannot be.
    #[error("{cell}: elements of a list are counted from 1")]
    #[diagnostic(help("write e.g. part = [2, 1] for the first element of the second list"))]
    Part {
        /// The cell.
        cell: String,
        /// Where.
        #[label("no element")]
        span: SourceSpan,
    },
    /// A verdict that does not stand.
    #[error("{cell}: {problem}")]
    #[diagnostic(help("{}", problem.remedy()))]
    Verdict {
        /// The cell.
        cell: String,
        /// Why not.
        problem: Box<Problem>,
        /// Where.
        #[label("this is wrong")]
        span: SourceSpan,
    },
}

impl Mistake {
    pub(super) fn toml(error: &toml::de::Error) -> Self {
        Self::Toml { message: error.message().to_owned(), span: error.span().map(Into::into) }
    }
}
