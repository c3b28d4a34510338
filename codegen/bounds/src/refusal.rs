//! Why a bound is not proved.

use crate::sign::Sign;
use std::fmt;

/// A bound that is not proved.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The kernel.
    pub kernel: String,
    /// The step or the result where the derivation ends.
    pub step: String,
    /// Why.
    pub reason: Reason,
}

/// What is not proved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// A sum of rounded terms that may have opposite signs.
    MayCancel {
        /// The sum.
        sum: String,
        /// What is known of its terms.
        signs: String,
    },
    /// A compensated expression with an operand that is not exact.
    Rounded {
        /// The compensated expression.
        expression: String,
        /// The operand.
        operand: String,
    },
    /// A comparison that decides about the domain, and that rounding may turn.
    Undecided(String),
    /// A comparison that decides between different values, and that rounding may turn.
    Turned(String),
    /// A value that is computed where it may not be defined.
    Undefined {
        /// What it is.
        kind: Undefined,
        /// The divisor, the radicand, or the root of a polynomial.
        value: String,
        /// The condition that would make it so, if one on inputs does.
        condition: Option<String>,
    },
    /// A function whose error is not proved.
    Elementary(String),
    /// An integer of a number that is rounded, perhaps over a step.
    Stepped(String),
    /// A `residual!` that corrects no root.
    Residual(String),
    /// A root's correction that is none, or not shown to be right.
    Correction {
        /// The correction.
        correction: String,
        /// What is wrong.
        cause: &'static str,
    },
    /// The stated bound is smaller than what is proved.
    Understated {
        /// As stated.
        stated: f64,
        /// As derived.
        derived: f64,
    },
    /// The stated bound is larger than what is proved.
    Overstated {
        /// As stated.
        stated: f64,
        /// As derived.
        derived: f64,
    },
    /// No bound is stated.
    Unstated {
        /// As derived.
        derived: f64,
    },
}

/// What is not defined everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Undefined {
    /// A quotient, whose divisor may be zero.
    Quotient,
    /// A function of what may be negative, which has values from zero on.
    Root,
    /// A `positive_root`, whose coefficients may change their sign never or twice.
    PolynomialRoot,
}

impl Undefined {
    /// How what it depends on compares with zero where it is defined.
    pub(crate) fn comparison(self) -> &'static str {
        match self {
            Self::Quotient => "!=",
            Self::Root | Self::PolynomialRoot => ">=",
        }
    }

    fn cause(self) -> &'static str {
        match self {
            Self::Quotient => "is divided by, and may be zero",
            Self::Root => "stands under a root, and may be negative",
            Self::PolynomialRoot => {
                "may have no root, or several: its coefficients are not shown to be negative below some power and \
                 positive above it"
            }
        }
    }
}

impl Reason {
    /// The expression that it is about, as its message quotes it.
    pub(crate) fn quoted(&self) -> Option<&str> {
        match self {
            Self::MayCancel { sum: text, .. }
            | Self::Rounded { expression: text, .. }
            | Self::Undefined { value: text, .. }
            | Self::Correction { correction: text, .. }
            | Self::Undecided(text)
            | Self::Elementary(text)
            | Self::Stepped(text)
            | Self::Residual(text) => Some(text),
            _ => None,
        }
    }

    pub(crate) fn may_cancel(sum: String, left: Sign, right: Sign) -> Self {
        Self::MayCancel { sum, signs: format!("the left one is {left}, the right one {right}") }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "kernel `{}`, `{}`: {}", self.kernel, self.step, self.reason)
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MayCancel { sum, signs } => write!(
                f,
                "`{sum}` may cancel: its terms are rounded and not shown to have one sign ({signs}); write it as \
                 `compensated!`, or require the sign that it needs"
            ),
            Self::Rounded { expression, operand } => write!(
                f,
                "`{expression}` takes `{operand}` for exact, which is rounded; write it out in inputs and literals"
            ),
            Self::Undecided(comparison) => write!(
                f,
                "rounding may turn `{comparison}`: compare exact numbers, or write `compensated!(..)` and compare it with 0"
            ),
            Self::Turned(comparison) => write!(
                f,
                "rounding may turn `{comparison}`, by which an `if` decides between two values that are not shown to be \
                 the same function: compare exact numbers, or write `compensated!(..)` and compare it with 0"
            ),
            Self::Undefined { kind, value, condition: Some(condition) } => {
                write!(f, "`{value}` {}: say `require!({condition})`", kind.cause())
            }
            Self::Undefined { kind, value, condition: None } => {
                write!(f, "`{value}` {}: say by `require!(..)` what of the inputs keeps it from that", kind.cause())
            }
            Self::Elementary(call) => write!(
                f,
                "the error of `{call}` in `f64` is not proved: leave the bound out and say `precision = \"certified\"`, so that \
                 every call bounds its own error"
            ),
            Self::Stepped(call) => write!(
                f,
                "rounding may carry the argument of `{call}` over a step, where its value jumps: write it of exact numbers, or \
                 leave the bound out and say `precision = \"certified\"`"
            ),
            Self::Residual(residual) => write!(
                f,
                "`{residual}` has no bound of its own: use it to correct a `positive_root`, or write `compensated!`"
            ),
            Self::Correction { correction, cause } => {
                write!(f, "`{correction}` is no proved correction of a root: {cause}")
            }
            Self::Understated { stated, derived } => {
                write!(f, "the bound is stated as {stated} ulp, and {derived} ulp is what can be proved")
            }
            Self::Overstated { stated, derived } => {
                write!(f, "the bound is stated as {stated} ulp, and it can be proved to be {derived} ulp: state that")
            }
            Self::Unstated { derived } => write!(f, "no bound is stated; it can be proved to be {derived} ulp"),
        }
    }
}

impl std::error::Error for Refusal {}

/// Why the bounds of a source file are not proved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TextError {
    /// It holds what is no kernel language, or no Rust.
    Unreadable(String),
    /// These bounds are refused.
    Refused(Vec<Refusal>),
}

impl fmt::Display for TextError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(cause) => f.write_str(cause),
            Self::Refused(refusals) => {
                let refusals: Vec<String> = refusals.iter().map(ToString::to_string).collect();
                f.write_str(&refusals.join("\n"))
            }
        }
    }
}

impl std::error::Error for TextError {}
