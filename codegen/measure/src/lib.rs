//! How accurate kernels are: a project's kernels, their errors in ulp, the search for their worst inputs, the ledger.

pub mod accuracy;
pub mod catalogue;
pub mod kept;
pub mod ledger;
pub mod search;
