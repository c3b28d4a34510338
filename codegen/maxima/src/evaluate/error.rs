//! Why an expression has no value.

use std::ops::Range;

use miette::Diagnostic;
use thiserror::Error;

/// Why an expression has no value, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[non_exhaustive]
pub enum EvalError {
    /// A name that no input gives a value to.
    #[error("`{name}` has no value")]
    #[diagnostic(help("give it as an input"))]
    UnknownVariable {
        /// The name.
        name: String,
        /// Where it stands.
        #[label("no value")]
        span: Range<usize>,
    },
    /// A function that this evaluator does not know.
    #[error("unknown function `{name}`")]
    #[diagnostic(help("let Maxima expand it, e.g. `define(f(x),ev(body,eval))`"))]
    UnknownFunction {
        /// The function.
        name: String,
        /// Where it is called.
        #[label("unknown")]
        span: Range<usize>,
    },
    /// A function called with too many or too few arguments.
    #[error("`{name}` takes {expected}, not {found}")]
    #[diagnostic(help("correct the call"))]
    ArgumentCount {
        /// The function.
        name: String,
        /// What it takes.
        expected: &'static str,
        /// How many arguments stand there.
        found: usize,
        /// Where it is called.
        #[label("{found} given")]
        span: Range<usize>,
    },
    /// An expression that is no number: a list, an equation, an assignment.
    #[error("{what} has no numeric value")]
    #[diagnostic(help("evaluate a part of it"))]
    NotNumeric {
        /// What it is.
        what: &'static str,
        /// Where it stands.
        #[label("not a number")]
        span: Range<usize>,
    },
    /// An expression that is no condition, where one must stand.
    #[error("not a condition")]
    #[diagnostic(help("write a comparison, or several joined by `and`, `or`, `not`"))]
    NotACondition {
        /// Where it stands.
        #[label("not a condition")]
        span: Range<usize>,
    },
    /// A division by zero.
    #[error("division by zero")]
    #[diagnostic(help("keep the inputs inside the domain"))]
    DivisionByZero {
        /// The divisor.
        #[label("is zero")]
        span: Range<usize>,
    },
    /// A value that is not real, like the root of a negative number.
    #[error("not a real number")]
    #[diagnostic(help("keep the inputs inside the domain"))]
    NotReal {
        /// What is not real.
        #[label("not real here")]
        span: Range<usize>,
    },
    /// A value beyond all numbers that MPFR can hold.
    #[error("not a finite number")]
    #[diagnostic(help("keep the inputs inside the domain"))]
    NotFinite {
        /// What is not finite.
        #[label("too large here")]
        span: Range<usize>,
    },
    /// An `if` without `else` whose conditions are all false.
    #[error("no branch applies")]
    #[diagnostic(help("add an `else`"))]
    NoBranch {
        /// The `if`.
        #[label("all conditions are false")]
        span: Range<usize>,
    },
    /// A polynomial without positive root.
    #[error("no positive root")]
    #[diagnostic(help("its coefficients must change sign exactly once"))]
    NoPositiveRoot {
        /// The polynomial.
        #[label("of one sign for all positive values")]
        span: Range<usize>,
    },
    /// A value whose digits still change at the highest precision.
    #[error("digits do not settle at {precision} bits")]
    #[diagnostic(help("rewrite the expression so that it loses fewer digits, or ask for fewer bits"))]
    Unsettled {
        /// The highest precision.
        precision: u32,
        /// The expression.
        #[label("does not settle")]
        span: Range<usize>,
    },
}

impl EvalError {
    /// Whether a higher precision may help, because the value may have been rounded across a border.
    pub(super) fn may_be_rounding(&self) -> bool {
        matches!(self, Self::DivisionByZero { .. } | Self::NotReal { .. } | Self::NoPositiveRoot { .. })
    }
}
