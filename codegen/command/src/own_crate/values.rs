//! The values that judge kernels of one's own: formulas in MPFR at points of their domains, computed once.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use super::text;
use closedform_measure::accuracy::{REFERENCE_BITS, Reference, covers};
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_project::sample::sample;

/// How many points each kernel's judge has.
const POINTS: usize = 200;

/// The values of the modules in a folder that have none yet, by file name: sums of two doubles, in hexadecimal bits.
pub(super) fn missing(catalogue: &Catalogue, folder: &Path) -> miette::Result<BTreeMap<String, String>> {
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    for entry in catalogue.entries() {
        if !folder.join(format!("{}.tsv", entry.family)).exists() {
            values_of(entry, files.entry(&entry.family).or_default())?;
        }
    }
    let module = |family: &str| std::fs::read_to_string(folder.join(format!("{family}.rs"))).unwrap_or_default();
    let files = files.into_iter();
    Ok(files.map(|(family, values)| (format!("{family}.tsv"), text::values(&module(family), &values))).collect())
}

fn values_of(entry: &Entry, text: &mut String) -> miette::Result<()> {
    let inputs = entry.inputs();
    let points = sample(&entry.domain()?, &inputs.iter().collect::<Vec<_>>(), POINTS, 1)?;
    let reference = Reference::of(&entry.kernel)?;
    let before = text.len();
    for point in points.iter().filter(|point| covers(&entry.kernel, point)) {
        // where the formula has no value although its domain says nothing of that, there is nothing to judge by
        let Ok(values) = reference.values(point, REFERENCE_BITS) else { continue };
        for (result, value) in values.iter().enumerate() {
            let high = value.to_f64();
            let low = rug::Float::with_val(REFERENCE_BITS, value - high).to_f64();
            let numbers = point.iter().chain([&high, &low]).map(|number| format!("{:016x}", number.to_bits()));
            let _ = writeln!(text, "{}\t{result}\t{}", entry.full_name(), numbers.collect::<Vec<_>>().join("\t"));
        }
    }
    if text.len() == before {
        miette::bail!(
            help = "say by a contract beside the worksheet where the formula is meant to hold",
            "the formula of `{}` has a value at none of {POINTS} points of its domain: nothing could judge its kernel",
            entry.full_name()
        );
    }
    Ok(())
}
