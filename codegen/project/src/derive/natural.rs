//! Kernels whose formulas need more of their inputs than their contracts say, as `generate` finds it too.

use closedform_maxima::Definition;

use super::super::contract::KernelContract;
use super::super::domain::{Stated, exact};
use super::super::family::completed;

/// A kernel, and the conditions that its formula needs besides its contract's.
pub type Added = (String, Vec<String>);

/// A kernel whose formula has no values at some points of its contract's domain.
pub(super) struct Retry {
    /// Its position in the contract.
    pub(super) index: usize,
    /// With the domain that its formula needs.
    pub(super) kernel: KernelContract,
    /// The conditions that some of those points do not meet.
    added: Vec<String>,
}

impl Retry {
    /// The kernel, to be asked again, if its formula needs anything that some of these points lack.
    pub(super) fn new(
        index: usize,
        kernel: &KernelContract,
        points: &[Vec<f64>],
        references: &[&Definition],
    ) -> Option<Self> {
        let kernel = completed(kernel, references.iter().copied());
        let fails =
            |stated: &&Stated| points.iter().filter_map(|p| exact(p)).any(|point| !stated.condition.holds(&point));
        let needed = kernel.domain.stated().iter().filter(|stated| stated.natural);
        let added: Vec<String> = needed.filter(fails).map(|stated| stated.text.clone()).collect();
        (!added.is_empty()).then_some(Self { index, kernel, added })
    }

    /// What is told of it.
    pub(super) fn added(self) -> Added {
        (self.kernel.name, self.added)
    }
}
