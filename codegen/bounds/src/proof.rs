//! Bounds by proof: those that a kernel states, held against what `closedform-bounds` derives from its Rust text.

use crate::{Refusal, check};
use closedform_syntax::{Kernel, certified};
use thiserror::Error;

/// The bounds of a kernel that its text does not prove.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum BoundError {
    /// They are not derived, or others than stated.
    #[error("{}", .0.iter().map(|refusal| format!("`{}`: {}", refusal.step, refusal.reason)).collect::<Vec<_>>().join("\n"))]
    Refused(Vec<Refusal>),
    /// They carry no certificate, or that of another text.
    #[error(transparent)]
    Uncertified(#[from] syn::Error),
}

/// Proves the bounds of a kernel, whether or not they are certified.
///
/// # Errors
/// When one is not derived, or is another one than stated.
pub fn bound_proof(kernel: &Kernel) -> Result<(), BoundError> {
    check(kernel).map(|_| ()).map_err(BoundError::Refused)
}

/// Proves the bounds of a kernel, which carry their certificate.
///
/// # Errors
/// As [`bound_proof`], and when the certificate is not theirs.
pub fn certified_bound_proof(kernel: &Kernel) -> Result<(), BoundError> {
    bound_proof(kernel)?;
    Ok(certified(kernel)?)
}
