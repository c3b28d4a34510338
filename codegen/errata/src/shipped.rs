//! What is shipped: the functions that contracts promise, with their kernels.

use std::collections::BTreeMap;
use std::path::Path;

use super::error::VerdictError;
use super::sheet::Shipment;
use closedform_project::contract;
use closedform_project::family::{Paths, family_names};

/// Worksheet functions with the number of their inputs and the kernel that computes them.
#[derive(Debug, Clone, Default)]
pub struct Shipped(BTreeMap<String, (usize, Shipment)>);

impl Shipped {
    /// The functions of all contracts in a folder.
    pub(super) fn load(folder: &Path) -> Result<Self, VerdictError> {
        let mut shipped = BTreeMap::new();
        for family in family_names(folder)? {
            let contract = contract::load(&Paths::new(folder, &family).contract)?;
            for (kernel, result) in contract.results() {
                let shipment = Shipment { family: family.clone(), kernel: kernel.name.clone() };
                shipped.insert(result.worksheet.clone(), (kernel.inputs.len(), shipment));
            }
        }
        Ok(Self(shipped))
    }

    /// The number of inputs and the kernel of a function.
    pub(super) fn get(&self, function: &str) -> Option<&(usize, Shipment)> {
        self.0.get(function)
    }
}
