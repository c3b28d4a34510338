//! Maxima's own word: references and golden values are what it derives and computes today.

use super::error::CheckError;
use crate::worker::{self, Source};
use closedform_build::worksheet;
use closedform_project::Project;
use closedform_project::derive::{Compared, Disagreement, Options, compare};
use closedform_project::family::family_names;
use closedform_project::golden::{self, GoldenValue};
use std::path::Path;

/// How many golden values of one function are shown.
const SHOWN: usize = 3;

/// Runs all worksheets and compares; says what was found.
///
/// # Errors
///
/// When Maxima derives or computes something else.
pub fn check(project: &Project, options: &Options) -> miette::Result<String> {
    let (mut changed, mut said) = (Vec::new(), String::new());
    for name in family_names(&project.worksheets)? {
        let file = |ending: &str| project.worksheets.join(format!("{name}.{ending}"));
        if !worksheet(&project.worksheets, &name).exists() {
            let contract = project.shown(&file("toml"));
            changed.push(format!(
                "{contract} is the contract of a worksheet that is not there: put it back, or delete what was made of it too"
            ));
            continue;
        }
        let compared = compare(&project.worksheets, &name, options)?;
        said += &other_version(&name, &compared);
        changed.extend(compared.changed.iter().map(|(function, kernel)| {
            let references = project.shown(&file("ref"));
            format!("{references}: Maxima derives another `{function}`, of the kernel `{kernel}`")
        }));
        changed.extend(values(&file("tsv"), &project.shown(&file("tsv")), &compared.disagreements));
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

/// The first golden values of every function that Maxima computes otherwise, with their places, and how many more there are.
fn values(path: &Path, shown: &str, disagreements: &[Disagreement]) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let mut functions: Vec<&str> = disagreements.iter().map(|found| found.golden.worksheet.as_str()).collect();
    functions.dedup();
    let mut said = Vec::new();
    for function in functions {
        let of_it: Vec<&Disagreement> =
            disagreements.iter().filter(|found| found.golden.worksheet == function).collect();
        said.extend(
            of_it.iter().take(SHOWN).map(|found| format!("{}: {}", place(&text, shown, &found.golden), value(found))),
        );
        let more = of_it.len().saturating_sub(SHOWN);
        said.extend((more > 0).then(|| format!("{shown}: and {more} more of `{function}`")));
    }
    said
}

/// The file, with the line of a value.
fn place(text: &str, shown: &str, value: &GoldenValue) -> String {
    let printed = golden::print(std::slice::from_ref(value));
    let line = text.lines().position(|line| line == printed.trim_end());
    line.map_or_else(|| shown.to_owned(), |line| format!("{shown}:{}", line + 1))
}

fn value(Disagreement { golden, now }: &Disagreement) -> String {
    let inputs = golden.inputs.iter().map(|(input, value)| format!("{input}={value:e}")).collect::<Vec<_>>().join(" ");
    let now = now.as_ref().map_or_else(ToString::to_string, Clone::clone);
    format!("{} at {inputs}: {} is written, Maxima computes {now}", golden.worksheet, golden.value)
}
