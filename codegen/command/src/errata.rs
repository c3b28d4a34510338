//! The page of errata: made by `derive`, compared by `check`.

use closedform_errata::{Errata, PAGE, VerdictError, has_errata, listed};
use closedform_project::folder::diff;
use closedform_project::maxima_process::Maxima;
use closedform_project::{WriteError, replaceable, write_all};
use closedform_system::output;
use miette::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The page is not what the errata say.
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
    /// The page of a folder of worksheets, if it has errata and one of these families is among them.
    ///
    /// # Errors
    ///
    /// When a verdict is wrong, or a derivation cannot be replayed.
    pub fn of(folder: &Path, families: &[String], maxima: &Maxima) -> Result<Option<Self>, VerdictError> {
        if !families.iter().any(|family| has_errata(folder, family)) {
            return Ok(None);
        }
        let judged = |errata: Errata| {
            let text = errata.judge(maxima)?;
            Ok(Self { text, outputs: errata.stated().len(), path: errata.page })
        };
        Errata::load(folder)?.map(judged).transpose()
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
        format!("{PAGE}: the verdicts on {} printed outputs\n", self.outputs)
    }
}

/// Demands that the page lists the rows of the errata with their stated verdicts; Maxima is not asked.
///
/// # Errors
///
/// When it does not, or the errata cannot be read.
pub fn check_list(folder: &Path) -> miette::Result<()> {
    let Some(errata) = Errata::load(folder)? else { return Ok(()) };
    let page = present(&errata)?;
    let (stated, listed) = (lines(errata.stated()), lines(listed(&page)));
    if stated == listed { Ok(()) } else { Err(stale(&errata, &listed, &stated).into()) }
}

/// Computes all verdicts again, demands that the page says what they are, and says so.
///
/// # Errors
///
/// When a verdict is wrong, or the page is stale.
pub fn check_live(folder: &Path, maxima: &Maxima) -> miette::Result<()> {
    let Some(errata) = Errata::load(folder)? else { return Ok(()) };
    let text = errata.judge(maxima)?;
    let page = present(&errata)?;
    if page != text {
        return Err(stale(&errata, &page, &text).into());
    }
    let outputs = errata.stated().len();
    Ok(output::print(&format!("live: the verdict on each of {outputs} printed outputs is what Maxima finds\n"))?)
}

fn present(errata: &Errata) -> Result<String, StalePage> {
    let missing = |cause| StalePage(format!("missing: {}: {cause}", errata.page.display()));
    fs::read_to_string(&errata.page).map_err(missing)
}

fn stale(errata: &Errata, old: &str, new: &str) -> StalePage {
    StalePage(format!("stale: {}\n{}", errata.page.display(), diff(PAGE, old, new)))
}

fn lines(rows: Vec<(String, String)>) -> String {
    rows.into_iter().map(|(cell, verdict)| format!("{cell}: {verdict}\n")).collect()
}
