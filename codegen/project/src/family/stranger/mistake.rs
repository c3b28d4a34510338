//! What can be wrong with a worksheet.

use std::path::{Path, PathBuf};

use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::reference::ReferenceMistake;
use crate::fpcore::CoreMistake;
use crate::source::{self, Text};

/// The most nodes that calls may put into the formulas of a worksheet.
pub(super) const SIZE_LIMIT: usize = 100_000;

/// Why a worksheet is not a list of definitions that kernels can be made of.
#[derive(Debug, Error, Diagnostic)]
#[error("{} cannot be read as a list of definitions: {count}", path.display())]
pub struct WorksheetError {
    /// The worksheet.
    pub path: std::path::PathBuf,
    /// How much is wrong.
    count: String,
    /// Its text.
    #[source_code]
    pub text: Text,
    /// What is wrong, the first of it.
    #[related]
    pub mistakes: Vec<WorksheetMistake>,
}

/// One mistake in a worksheet, with its place.
#[derive(Debug, Error, Diagnostic)]
pub enum WorksheetMistake {
    /// The text is not Maxima.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Text(#[from] closedform_maxima::Error),
    /// A definition that no kernel can be made of.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Body(#[from] ReferenceMistake),
    /// A core that no kernel can be made of.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Core(#[from] CoreMistake),
    /// A contract beside cores.
    #[error("there is a contract beside the cores, which state their domains themselves")]
    #[diagnostic(help("write `:pre` and `:name` into the cores, and remove or rename {}", contract.display()))]
    Contract {
        /// The contract.
        contract: PathBuf,
    },
    /// Statements that compute.
    #[error("{}", computing(*statements))]
    #[diagnostic(help(
        "a worksheet that computes needs Maxima: write a contract NAME.toml beside it, run `closedform derive --folder DIR \
         NAME`, and then this command again; book/src/contract.md shows a contract"
    ))]
    Computes {
        /// How many.
        statements: usize,
        /// Where the first one is.
        #[label("only Maxima can run this")]
        span: SourceSpan,
    },
    /// Nothing at all.
    #[error("the worksheet defines no function")]
    #[diagnostic(help("define one, e.g. f(x,y):=sqrt(x^2+y^2)$"))]
    Nothing,
    /// A function without parameters.
    #[error("`{name}` has no parameters")]
    #[diagnostic(help("a kernel needs an input; a constant needs no kernel"))]
    Constant {
        /// The function.
        name: String,
        /// Where.
        #[label("a constant")]
        span: SourceSpan,
    },
    /// A parameter that occurs twice.
    #[error("`{name}` has the parameter `{parameter}` twice")]
    #[diagnostic(help("give each parameter a name of its own"))]
    Parameter {
        /// The function.
        name: String,
        /// The parameter.
        parameter: String,
        /// Where.
        #[label("this definition")]
        span: SourceSpan,
    },
    /// Definitions that need each other.
    #[error("these definitions call each other without end: {}", cycle.join(" -> "))]
    #[diagnostic(help("kernels are closed forms; write the function without recursion"))]
    Recursion {
        /// The functions, the first again at the end.
        cycle: Vec<String>,
        /// Where.
        #[label("calls itself in the end")]
        span: SourceSpan,
    },
    /// A call with another number of arguments than the definition has parameters.
    #[error("`{name}` takes {expected} arguments, but is called with {found}")]
    #[diagnostic(help("correct the call or the definition"))]
    Arguments {
        /// The function called.
        name: String,
        /// Number of parameters.
        expected: usize,
        /// Number of arguments.
        found: usize,
        /// Where.
        #[label("called here")]
        span: SourceSpan,
    },
    /// A formula without measure.
    #[error("the formulas grow to more than {} terms when all definitions are put in", SIZE_LIMIT)]
    #[diagnostic(help("make the functions that it calls smaller"))]
    TooLarge {
        /// The function called.
        name: String,
        /// Where.
        #[label("putting in `{name}` is too much")]
        span: SourceSpan,
    },
}

impl WorksheetError {
    pub(super) fn new(path: &Path, text: Text, mistakes: Vec<WorksheetMistake>) -> Self {
        let count = source::count(mistakes.len());
        let mistakes = mistakes.into_iter().take(source::SHOWN).collect();
        Self { path: path.to_owned(), count, text, mistakes }
    }
}

impl WorksheetMistake {
    /// Where it is, if it has a place.
    pub(super) fn span(&self) -> Option<SourceSpan> {
        match self {
            Self::Text(error) => Some(error.span().into()),
            Self::Body(mistake) => mistake.span(),
            Self::Core(mistake) => Some(mistake.span),
            Self::Nothing | Self::Contract { .. } => None,
            Self::Computes { span, .. }
            | Self::Constant { span, .. }
            | Self::Parameter { span, .. }
            | Self::Recursion { span, .. }
            | Self::Arguments { span, .. }
            | Self::TooLarge { span, .. } => Some(*span),
        }
    }
}

fn computing(statements: usize) -> String {
    match statements {
        1 => "this statement defines no function".to_owned(),
        _ => format!("{statements} statements define no function; the first of them"),
    }
}
