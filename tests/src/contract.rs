//! What contracts promise: kernels and the worksheet names of their results.

use crate::worksheets;

/// A kernel as its contract names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contract {
    /// `family::name`.
    pub name: String,
    /// The worksheet names of its results, in order.
    pub worksheets: Vec<String>,
}

/// The contracts of `maxima-ref/FAMILY.toml`.
pub fn load(family: &str) -> Vec<Contract> {
    let path = worksheets::path(family, "toml");
    let contract =
        closedform_project::contract::load(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let of_kernel = |kernel: closedform_project::contract::KernelContract| Contract {
        name: format!("{family}::{}", kernel.name),
        worksheets: kernel.results.into_iter().map(|result| result.worksheet).collect(),
    };
    contract.kernels.into_iter().map(of_kernel).collect()
}
