//! What can go wrong while a family is derived.

use std::path::PathBuf;

use miette::Diagnostic;
use thiserror::Error;

use super::super::contract::ContractError;
use super::super::family::ReferenceError;
use super::super::files::WriteError;
use super::super::golden::GoldenError;
use super::super::hexfloat;
use super::super::maxima_process::ProcessError;
use super::super::sample::EmptyDomain;
use super::super::source::ReadError;

/// Why nothing was derived.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum DeriveError {
    /// A file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// The contract is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Contract(#[from] ContractError),
    /// Maxima did not finish the worksheet.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Process(#[from] ProcessError),
    /// What Maxima printed is no reference expression.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Reference(#[from] ReferenceError),
    /// The golden values to compare with cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Golden(#[from] GoldenError),
    /// The results cannot be written.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Write(#[from] WriteError),
    /// Nothing is left that could be a formula.
    #[error("{} leaves no formula{}", path.display(), passed.iter().map(|line| format!("\n{line}")).collect::<String>())]
    #[diagnostic(help("give what it computes a name: `name: formula$`, or `f(x):=formula$`"))]
    Nothing {
        /// The worksheet.
        path: PathBuf,
        /// What was passed over.
        passed: Vec<String>,
    },
    /// The worksheet lacks a function.
    #[error("{} defines no function `{worksheet}`, which the kernel `{kernel}` needs", path.display())]
    #[diagnostic(help(
        "add define({worksheet}({inputs}), ..)$ to the worksheet, or correct `worksheet` in the contract"
    ))]
    Undefined {
        /// The function.
        worksheet: String,
        /// The kernel.
        kernel: String,
        /// Its inputs.
        inputs: String,
        /// The worksheet.
        path: PathBuf,
    },
    /// A function with other parameters than promised.
    #[error("{} defines {found}, but the contract promises {promised}", path.display())]
    #[diagnostic(help("give worksheet and contract the same inputs in the same order"))]
    Parameters {
        /// As the worksheet has it.
        found: String,
        /// As the contract has it.
        promised: String,
        /// The worksheet.
        path: PathBuf,
    },
    /// A function that fails.
    #[error("{function} cannot be applied to its own symbols: {message}")]
    #[diagnostic(help("let the worksheet define the closed form itself, e.g. with define(..) instead of :="))]
    Application {
        /// The function.
        function: String,
        /// What Maxima printed.
        message: String,
    },
    /// A function that prints.
    #[error("{function} printed something where only its value was expected: {printed}")]
    #[diagnostic(help("let the worksheet define the closed form itself, without print(..)"))]
    Printed {
        /// The function.
        function: String,
        /// What it printed.
        printed: String,
    },
    /// No points.
    #[error("the kernel `{kernel}` has no golden values: {cause}")]
    #[diagnostic(help("correct the conditions, or the `typical` magnitudes of their inputs"))]
    EmptyDomain {
        /// The kernel.
        kernel: String,
        /// Why.
        cause: EmptyDomain,
    },
    /// A formula that is wrong at a point of its domain.
    #[error("the kernel `{kernel}` at {point}: {failure}")]
    #[diagnostic(help("{}", failure.remedy()))]
    Point {
        /// The kernel.
        kernel: String,
        /// What is wrong.
        failure: PointFailure,
        /// The inputs.
        point: String,
    },
    /// A formula that has hardly any values.
    #[error("the kernel `{kernel}` has values at {found} points instead of {wanted}; at {point}: {failure}")]
    #[diagnostic(help("{}", failure.remedy()))]
    TooFewPoints {
        /// The kernel.
        kernel: String,
        /// Points with values.
        found: usize,
        /// Points wanted.
        wanted: usize,
        /// What is wrong at the first point without.
        failure: PointFailure,
        /// That point.
        point: String,
    },
    /// Golden values of another contract.
    #[error("the golden values of `{worksheet}` do not fit the contract")]
    #[diagnostic(help("run `closedform derive` after changing a contract"))]
    StaleGolden {
        /// The function.
        worksheet: String,
    },
}

impl DeriveError {
    /// Whether a point has no value because the formula needs more of its inputs than the contract says.
    pub(super) fn may_be_natural(&self) -> bool {
        match self {
            Self::Point { failure, .. } | Self::TooFewPoints { failure, .. } => {
                !matches!(failure, PointFailure::Symbols(_))
            }
            _ => false,
        }
    }
}

/// Why an expression has no value at a point.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PointFailure {
    /// Division by zero, or no root.
    #[error("the expression has no value")]
    NoValue,
    /// Its digits change with every precision.
    #[error("the digits never settle")]
    Unstable,
    /// The square root of a negative number.
    #[error("the value is not real")]
    Complex,
    /// It is no number.
    #[error("the value is not a number: {0}")]
    Symbols(String),
}

impl PointFailure {
    /// Whether the worksheet or contract must be wrong; otherwise the point may just be singular.
    pub fn is_fatal(&self) -> bool {
        matches!(self, Self::Complex | Self::Symbols(_))
    }

    fn remedy(&self) -> &'static str {
        match self {
            Self::NoValue | Self::Unstable => "exclude by `domain` where the formula is singular",
            Self::Complex => "exclude by `domain` where the formula has no real value, or correct the worksheet",
            Self::Symbols(_) => "let the worksheet eliminate what is not an input",
        }
    }
}

/// The inputs as people and programs read them.
pub(super) fn spell(inputs: &[(String, f64)]) -> String {
    let spelt: Vec<String> =
        inputs.iter().map(|(name, value)| format!("{name}={value:e} ({})", hexfloat::print(*value))).collect();
    spelt.join(", ")
}
