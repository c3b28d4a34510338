//! Kernels' texts for the judge of bounds: as checked in, and doctored.

use closedform_bounds::{ResultBound, TextError, check_text};

use crate::{worksheets, workspace};
use std::fs;

/// The generated text of a family.
///
/// # Panics
///
/// It cannot be read.
pub fn text(family: &str) -> String {
    let path = workspace::root().join(format!("kernels/src/generated/{family}.rs"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The proved bounds of every checked-in kernel, by family.
pub fn all() -> Vec<(String, Result<Vec<ResultBound>, TextError>)> {
    worksheets::families("toml").into_iter().map(|family| (family.clone(), check_text(&text(&family)))).collect()
}

/// The text of one kernel with every `from` in it replaced.
///
/// # Panics
///
/// There is no such kernel, or no `from` in it.
pub fn doctored(family: &str, kernel: &str, from: &str, to: &str) -> String {
    let text = text(family);
    let text = text.split("\n#[kernel(").skip(1).find(|text| text.contains(&format!("\npub fn {kernel}(")));
    let text =
        text.and_then(|text| text.split_once("\n}\n")).unwrap_or_else(|| panic!("no kernel `{family}::{kernel}`"));
    assert!(text.0.contains(from), "no `{from}` in `{family}::{kernel}`");
    format!("#[kernel({}\n}}\n", text.0.replace(from, to))
}

/// What is said of a doctored kernel.
///
/// # Panics
///
/// Its bounds are proved.
pub fn refusal(family: &str, kernel: &str, from: &str, to: &str) -> String {
    match check_text(&doctored(family, kernel, from, to)) {
        Ok(bounds) => panic!("`{from}` as `{to}` in `{family}::{kernel}` is proved: {bounds:?}"),
        Err(refused) => refused.to_string(),
    }
}
