//! Bounds by proof: those that a kernel states, held against what `closedform-bounds` derives from its Rust text.

use closedform_bounds::{Refusal, check};
use closedform_syntax::Kernel;
use miette::Diagnostic;
use thiserror::Error;

/// The bounds of a kernel that its text does not prove.
#[derive(Debug, Error, Diagnostic)]
#[error("{}", .0.iter().map(|refusal| format!("`{}`: {}", refusal.step, refusal.reason)).collect::<Vec<_>>().join("\n"))]
#[diagnostic(help("run `closedform generate`: it states the bounds of what it writes"))]
pub struct BoundError(pub Vec<Refusal>);

/// Proves the bounds of a kernel.
///
/// # Errors
/// When one is not derived, or is another one than stated.
pub fn bound_proof(kernel: &Kernel) -> Result<(), BoundError> {
    check(kernel).map(|_| ()).map_err(BoundError)
}
