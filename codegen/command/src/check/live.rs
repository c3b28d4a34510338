//! Maxima's own word: references and golden values are what it derives and computes today.

use super::error::CheckError;
use crate::worker::{self, Source};
use closedform_project::Project;
use closedform_project::derive::{Compared, Options, compare};
use closedform_project::family::family_names;
use closedform_project::golden::GoldenValue;

/// Runs all worksheets and compares; says what was found.
///
/// # Errors
///
/// When Maxima derives or computes something else.
pub fn check(project: &Project, options: &Options) -> miette::Result<String> {
    let (mut changed, mut said) = (Vec::new(), String::new());
    for name in family_names(&project.worksheets)? {
        let compared = compare(&project.worksheets, &name, options)?;
        said += &other_version(&name, &compared);
        changed.extend(compared.changed.iter().map(|(function, kernel)| {
            format!("{name}.ref: Maxima derives another `{function}`, of the kernel `{kernel}`")
        }));
        for disagreement in compared.disagreements {
            let now = disagreement.now.unwrap_or_else(|failure| failure.to_string());
            changed.push(golden(&name, &disagreement.golden, &now));
        }
    }
    if !changed.is_empty() {
        return Err(CheckError::Changed(changed).into());
    }
    Ok(said + "live: every reference is what Maxima derives, and every golden value what it computes\n")
}

/// Proves the kernels as checked in, of families that were read without errors, equal to what Maxima derives now; needs
/// Symbolica.
///
/// # Errors
///
/// When one is not proved.
pub fn prove(project: &Project, options: &Options) -> miette::Result<()> {
    let (folder, kernels) = (project.worksheets.clone(), project.generated());
    worker::run_checked(&Source::Rederived { folder, kernels, maxima: options.maxima.clone() }, &project.limits)?;
    Ok(())
}

fn other_version(name: &str, compared: &Compared) -> String {
    let Some((recorded, running)) = &compared.other_version else { return String::new() };
    format!(
        "{name}: derived by Maxima {recorded}, but this is {running} and writes it in another way: values compared\n"
    )
}

fn golden(name: &str, golden: &GoldenValue, now: &str) -> String {
    let inputs = golden.inputs.iter().map(|(input, value)| format!("{input}={value:e}")).collect::<Vec<_>>().join(" ");
    format!("{name}.tsv, {} at {inputs}: {} is written, Maxima computes {now}", golden.worksheet, golden.value)
}
