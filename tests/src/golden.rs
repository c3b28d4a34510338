//! Golden values: numbers that Maxima printed, with the exact inputs it computed them for.

pub use closedform_project::golden::{GoldenValue, parse};

use crate::worksheets;

/// Digits of a value that are correct.
pub const DIGITS: u32 = 40;

/// The golden values of `maxima-ref/FAMILY.tsv`.
pub fn load(family: &str) -> Vec<GoldenValue> {
    let path = worksheets::path(family, "tsv");
    closedform_project::golden::load(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
