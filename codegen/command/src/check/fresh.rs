//! Freshness: by the stamps that generated files carry, or by generating them again.

use super::error::CheckError;
use crate::own_crate::{self, Draft};
use crate::worker::{self, Source};
use closedform_build::{Stale, stale};
use closedform_project::Project;
use closedform_project::family::{Family, families};
use closedform_project::folder::{self, Difference};
use miette::IntoDiagnostic;
use std::collections::BTreeSet;
use std::path::MAIN_SEPARATOR;

/// Every generated file is as it was generated, of worksheets and references as they are now, and there is one for every
/// worksheet. Returns the families of the worksheets, read once for all that is checked of them.
///
/// # Errors
///
/// When a file is stale, missing or left over, or a worksheet is wrong.
pub fn check(project: &Project) -> miette::Result<Vec<Family>> {
    let found = stale(&project.generated(), &project.worksheets).into_diagnostic()?;
    let (derived, generated): (Vec<Stale>, Vec<Stale>) =
        found.into_iter().partition(|stale| stale.path.starts_with(&project.worksheets));
    let said = |stale: Vec<Stale>| stale.iter().map(|stale| shown(project, stale)).collect::<Vec<_>>();
    if !derived.is_empty() {
        return Err(CheckError::Underived(said(derived)).into());
    }
    let families = families(&project.worksheets)?;
    let wanted = own_crate::names(families.iter().map(|family| family.name.as_str()), project.judges);
    let present: BTreeSet<String> = folder::generated(&project.generated()).into_diagnostic()?.into_iter().collect();
    let missing = wanted.difference(&present).map(|name| format!("missing: {}", in_folder(project, name)));
    let orphans = present.difference(&wanted).map(|name| format!("made by nothing: {}", in_folder(project, name)));
    let wrong: Vec<String> = said(generated).into_iter().chain(missing).chain(orphans).collect();
    if wrong.is_empty() { Ok(families) } else { Err(CheckError::Stale(wrong).into()) }
}

/// Generates everything again, of families that were read without errors, and compares every byte.
///
/// # Errors
///
/// When a kernel cannot be made or proved, or a file differs.
pub fn regenerate(project: &Project) -> miette::Result<()> {
    let generated = worker::run_checked(&Source::Folder(project.worksheets.clone()), &project.limits)?;
    let files = Draft::new(&generated)?.whole(project.judges)?;
    let differences = folder::compare(&project.generated(), &files).into_diagnostic()?;
    let wrong: Vec<String> = differences.iter().map(|difference| describe(project, difference)).collect();
    if wrong.is_empty() { Ok(()) } else { Err(CheckError::Stale(wrong).into()) }
}

/// With paths as one reads them from the root.
fn shown(project: &Project, stale: &Stale) -> String {
    stale.to_string().replace(&format!("{}{MAIN_SEPARATOR}", project.root.display()), "")
}

fn describe(project: &Project, difference: &Difference) -> String {
    match difference {
        Difference::Stale(name, diff) => format!("stale: {}\n{diff}", in_folder(project, name)),
        Difference::Missing(name) => format!("missing: {}", in_folder(project, name)),
        Difference::Orphan(name) => format!("made by nothing: {}", in_folder(project, name)),
    }
}

fn in_folder(project: &Project, name: &str) -> String {
    project.shown(&project.generated().join(name))
}
