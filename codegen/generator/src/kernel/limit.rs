//! The limit of the work that may be spent on one formula.

use super::error::KernelError;
use crate::algebra::{TooMuchWork, limited};
use closedform_project::contract::KernelContract;

/// What one formula may take, in the units of [`limited`]: some 25 times what the hardest of the shipped ones takes.
const WORK: u64 = 50_000_000;

/// Does what takes no more than one formula may.
///
/// # Errors
/// Where it takes more, or fails.
pub fn within_limit<T, E: From<KernelError>>(
    kernel: &KernelContract,
    task: impl FnOnce() -> Result<T, E>,
) -> Result<T, E> {
    limited(WORK, task).unwrap_or_else(|TooMuchWork| Err(KernelError::TooMuchWork(kernel.name.clone()).into()))
}
