//! What can be wrong with a worksheet.

use std::path::{Path, PathBuf};

use closedform_maxima::Expr;
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::reference::ReferenceMistake;
use crate::domain::ConditionError;
use crate::fpcore::CoreMistake;
use crate::source::{self, Text};
use crate::worksheet::Refusal;

/// Why a worksheet is not a list of definitions that kernels can be made of.
#[derive(Debug, Error, Diagnostic)]
#[error("{} cannot be read as a list of definitions: {count}", path.display())]
pub struct WorksheetError {
    /// The worksheet.
    pub path: std::path::PathBuf,
    /// How much is wrong.
    count: String,
    of_file: bool,
    /// Its text.
    #[source_code]
    pub text: Text,
    /// What is wrong, the first of it.
    #[related]
    pub mistakes: Vec<WorksheetMistake>,
}

/// One mistake in a worksheet, with its place.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
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
    /// A name whose formula cannot be known.
    #[error("{what}")]
    #[diagnostic(help("{remedy}"))]
    Refused {
        /// The name.
        name: String,
        /// What is wrong.
        what: String,
        /// What to do about it.
        remedy: String,
        /// Where it shows.
        #[label("here")]
        span: SourceSpan,
        /// Where it comes from, if that is elsewhere.
        #[label("because of this")]
        cause: Option<SourceSpan>,
    },
    /// Nothing at all.
    #[error("the worksheet has no formula")]
    #[diagnostic(help("write one, such as f(x,y):=sqrt(x^2+y^2)$ or d: sqrt(x^2+y^2)$"))]
    Nothing,
}

impl WorksheetError {
    /// Whether the file as a whole is wrong, so that nothing of it is taken: its text cannot be read, or a contract stands
    /// beside cores.
    pub fn is_of_file(&self) -> bool {
        self.of_file
    }

    pub(super) fn new(path: &Path, text: Text, mistakes: Vec<WorksheetMistake>) -> Self {
        let count = source::count(mistakes.len());
        let of_file = |mistake: &WorksheetMistake| {
            matches!(mistake, WorksheetMistake::Text(_) | WorksheetMistake::Contract { .. })
        };
        let of_file = mistakes.iter().any(of_file);
        let mistakes = mistakes.into_iter().take(source::SHOWN).collect();
        Self { path: path.to_owned(), count, of_file, text, mistakes }
    }
}

impl WorksheetMistake {
    /// Why a name has no formula.
    pub(super) fn refused(name: &str, because: &Refusal) -> Self {
        let Refusal { what, remedy, span, cause } = because.clone();
        let what = if what.contains(&format!("`{name}`")) { what } else { format!("`{name}` has no formula: {what}") };
        Self::Refused { name: name.to_owned(), what, remedy, span: span.into(), cause: cause.map(Into::into) }
    }

    /// A condition of a formula that cannot be decided exactly.
    pub(super) fn condition(name: &str, condition: &Expr, error: &ConditionError) -> Self {
        let what = format!("`{name}` is a formula under a condition that cannot be decided exactly: {error}");
        let (remedy, span) = (error.remedy().to_owned(), condition.span.clone().into());
        Self::Refused { name: name.to_owned(), what, remedy, span, cause: None }
    }

    /// Where it is, if it has a place.
    pub(super) fn span(&self) -> Option<SourceSpan> {
        match self {
            Self::Text(error) => Some(error.span().into()),
            Self::Body(mistake) => mistake.span(),
            Self::Core(mistake) => Some(mistake.span),
            Self::Nothing | Self::Contract { .. } => None,
            Self::Refused { span, .. } => Some(*span),
        }
    }
}
