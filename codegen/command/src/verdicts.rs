//! The page of verdicts on the scans: made by `derive`, compared by `check`.

use closedform_errata::{PAGE, Scans, VerdictError, has_scan, listed};
use closedform_project::folder::diff;
use closedform_project::maxima_process::Maxima;
use closedform_project::{WriteError, replaceable, write_all};
use closedform_system::output;
use miette::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The page is not what the scans say.
#[derive(Debug, Error, Diagnostic)]
#[error("{0}")]
#[diagnostic(help("run `closedform derive`, read the difference and commit it"))]
pub struct StalePage(String);

/// A page, not yet written.
#[derive(Debug)]
pub struct Page {
    path: PathBuf,
    text: String,
    outputs: usize,
}

impl Page {
    /// The page of a folder of worksheets, if it has scans and one of these families is among them.
    ///
    /// # Errors
    ///
    /// When a verdict is wrong, or a scan cannot be replayed.
    pub fn of(folder: &Path, families: &[String], maxima: &Maxima) -> Result<Option<Self>, VerdictError> {
        if !families.iter().any(|family| has_scan(folder, family)) {
            return Ok(None);
        }
        let judged = |scans: Scans| {
            let text = scans.judge(maxima)?;
            Ok(Self { text, outputs: scans.stated().len(), path: scans.page })
        };
        Scans::load(folder)?.map(judged).transpose()
    }

    /// Writes it, in one step.
    ///
    /// # Errors
    ///
    /// When the file cannot be written.
    pub fn write(&self) -> Result<(), WriteError> {
        replaceable([&*self.path])?;
        write_all(&[(&*self.path, &*self.text)])
    }

    /// One line about it.
    #[must_use]
    pub fn summary(&self) -> String {
        format!("{PAGE}: the verdict on {} printed outputs\n", self.outputs)
    }
}

/// Demands that the page lists the rows of the scans with their stated verdicts; Maxima is not asked.
///
/// # Errors
///
/// When it does not, or the scans cannot be read.
pub fn check_list(folder: &Path) -> miette::Result<()> {
    let Some(scans) = Scans::load(folder)? else { return Ok(()) };
    let page = present(&scans)?;
    let (stated, listed) = (lines(scans.stated()), lines(listed(&page)));
    if stated == listed { Ok(()) } else { Err(stale(&scans, &listed, &stated).into()) }
}

/// Computes all verdicts again, demands that the page says what they are, and says so.
///
/// # Errors
///
/// When a verdict is wrong, or the page is stale.
pub fn check_live(folder: &Path, maxima: &Maxima) -> miette::Result<()> {
    let Some(scans) = Scans::load(folder)? else { return Ok(()) };
    let text = scans.judge(maxima)?;
    let page = present(&scans)?;
    if page != text {
        return Err(stale(&scans, &page, &text).into());
    }
    let outputs = scans.stated().len();
    Ok(output::print(&format!("live: the verdict on each of {outputs} printed outputs is what Maxima finds\n"))?)
}

fn present(scans: &Scans) -> Result<String, StalePage> {
    let missing = |cause| StalePage(format!("missing: {}: {cause}", scans.page.display()));
    fs::read_to_string(&scans.page).map_err(missing)
}

fn stale(scans: &Scans, old: &str, new: &str) -> StalePage {
    StalePage(format!("stale: {}\n{}", scans.page.display(), diff(PAGE, old, new)))
}

fn lines(rows: Vec<(String, String)>) -> String {
    rows.into_iter().map(|(cell, verdict)| format!("{cell}: {verdict}\n")).collect()
}
