//! Why no kernel can be made.

use super::written::WrittenError;
use crate::field::TowerError;
use crate::stable::solvers::RootError;
use closedform_project::expression::LowerError;
use thiserror::Error;

/// Why no kernel can be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum KernelError {
    /// A reference expression uses what the generator does not know.
    #[error("{0}")]
    Lower(#[source] LowerError),
    /// An expression has no canonical form.
    #[error("`{function}` {cause}")]
    Tower {
        /// The function of the worksheet.
        function: String,
        /// Why.
        cause: TowerError,
    },
    /// A domain condition has no canonical form.
    #[error("the domain condition `{condition}` {cause}")]
    Domain {
        /// The condition.
        condition: String,
        /// Why.
        cause: TowerError,
    },
    /// A polynomial root that is not shown to be unique.
    #[error("`{function}`: {cause}")]
    Root {
        /// The function of the worksheet.
        function: String,
        /// Why.
        cause: RootError,
    },
    /// A formula whose algebra has no end in sight.
    #[error("`{0}`: its exact algebra takes more work than the limit of a formula allows")]
    TooMuchWork(String),
    /// A formula that cannot be taken step by step.
    #[error("`{function}`: {cause}")]
    Written {
        /// The kernel.
        function: String,
        /// Why.
        cause: WrittenError,
    },
    /// A program whose error has no bound.
    #[error(
        "no bound for the error of `{0}` could be derived: a sum of rounded values may cancel; add the signs of its terms to the domain"
    )]
    Unbounded(String),
}

impl KernelError {
    /// Whether the formula can still be taken as it is written, in certified arithmetic. Without the signs of its
    /// coefficients a polynomial may have no positive root, or several: that only a contract can say.
    #[must_use]
    pub fn leaves_the_formula_as_written(&self) -> bool {
        !matches!(self, Self::Lower(_) | Self::Written { .. } | Self::Root { cause: RootError::Signs(_), .. })
    }
}
