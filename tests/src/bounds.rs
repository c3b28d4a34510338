//! Kernels' texts for the judge of bounds: as checked in, and doctored.

use std::fs;

use closedform_bounds::{ResultBound, TextError, check_text};

use crate::workspace;

/// The generated text of a family.
///
/// # Panics
///
/// It cannot be read.
pub fn generated(family: &str) -> String {
    let path = workspace::root().join(format!("kernels/src/generated/{family}.rs"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The kernels of a text by their names, each with its text.
pub fn kernels(text: &str) -> Vec<(&str, String)> {
    { text.split("\n#[kernel(").skip(1) }.filter_map(begun).collect()
}

/// The kernel that begins a text after the start of its attribute.
fn begun(text: &str) -> Option<(&str, String)> {
    let (text, _) = text.split_once("\n}\n")?;
    let (_, signature) = text.split_once("\npub fn ")?;
    let (name, _) = signature.split_once('(')?;
    Some((name, format!("#[kernel({text}\n}}\n")))
}

/// The text of one kernel.
///
/// # Panics
///
/// There is no such kernel.
fn kernel(text: &str, name: &str) -> String {
    let found = kernels(text).into_iter().find(|(other, _)| *other == name);
    found.unwrap_or_else(|| panic!("no kernel `{name}`")).1
}

/// What the generated text of the kernel `family::name` proves, of each result.
///
/// # Errors
///
/// What it does not prove.
///
/// # Panics
///
/// There is no such kernel.
pub fn proved(name: &str) -> Result<Vec<ResultBound>, TextError> {
    let (family, own) = name.split_once("::").unwrap_or_else(|| panic!("`{name}` has no family"));
    check_text(&kernel(&generated(family), own))
}

/// What is said of a kernel with every `from` in its text replaced.
///
/// # Panics
///
/// There is no such kernel, or no `from` in it, or its bounds are proved.
pub fn refusal(text: &str, name: &str, from: &str, to: &str) -> String {
    let kernel = kernel(text, name);
    assert!(kernel.contains(from), "no `{from}` in `{name}`");
    match check_text(&kernel.replace(from, to)) {
        Ok(bounds) => panic!("`{from}` as `{to}` in `{name}` is proved: {bounds:?}"),
        Err(refused) => refused.to_string(),
    }
}
