//! Mutants: kernels with one mistake each, and the judges that must tell them from the kernel.

mod attack;
mod equivalent;
mod error;
mod exam;
mod judge;
mod kind;
mod known;
mod mistake;
mod place;
mod points;
mod proof;
mod same;
#[cfg(test)]
mod tests;
mod zeros;

pub use attack::Attack;
pub use equivalent::{Equivalents, Unneeded};
pub use error::MutateError;
pub use exam::{Effort, Lists, Outcome, Verdict, examine};
pub use kind::{Mutant, mutants};
pub use known::Known;
pub use mistake::{Mistake, Nth};
pub use place::Change;
