//! `closedform check`: the generated kernels are what the references say, and with `--maxima` what Maxima says today.

use super::generate::{kernels, worksheets};
use super::verify::worst_of_all;
use super::{readme, verdicts};
use crate::catalogue::Catalogue;
use crate::folder::{self, Difference};
use crate::worker::{self, Source};
use crate::worksheet::derive::{Options, compare_golden};
use crate::worksheet::family::family_names;
use clap::Args as ClapArgs;
use miette::{Diagnostic, IntoDiagnostic};
use std::path::Path;
use thiserror::Error;

/// Check that everything generated is fresh and proved
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// Run the worksheets in Maxima, and hold kernels, golden values and verdicts against what it derives
    #[arg(long)]
    maxima: bool,
}

/// What is not as it should be.
#[derive(Debug, Error, Diagnostic)]
enum CheckError {
    /// Files differ from what would be generated.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("run `closedform generate`, read the difference and commit it"))]
    Stale(Vec<String>),
    /// Golden values that Maxima computes differently.
    #[error("{}", .0.join("\n"))]
    #[diagnostic(help("run `closedform derive` if the worksheet is right as it is"))]
    Golden(Vec<String>),
}

/// Checks.
///
/// # Errors
///
/// When something is stale, unproved, or not what Maxima derives, or a verdict is wrong.
pub fn run(args: &Args, root: &Path) -> miette::Result<()> {
    if args.maxima {
        verdicts::check_live(&worksheets(root))?;
    } else {
        verdicts::check_list(&worksheets(root))?;
    }
    fresh(root)?;
    println!("fresh: {} holds what the references generate, all kernels proved", kernels(root).display());
    if args.maxima {
        live(root)?;
        println!("live: every kernel equals what Maxima derives, and every golden value is what Maxima computes");
    }
    Ok(())
}

fn fresh(root: &Path) -> miette::Result<()> {
    let generated = worker::run(&Source::Folder(worksheets(root)))?;
    let differences = folder::compare(&kernels(root), &generated.files).into_diagnostic()?;
    let mut stale: Vec<String> = differences.iter().map(|difference| describe(root, difference)).collect();
    if stale.is_empty() && root.join("README.md").exists() {
        let catalogue = Catalogue::load(&kernels(root))?;
        let worst = worst_of_all(&catalogue, readme::POINTS)?;
        let table = readme::expected(root, &catalogue, &worst);
        stale.extend(
            table
                .filter(|(expected, present)| expected != present)
                .map(|_| "stale: the table of kernels in README.md".to_owned()),
        );
    }
    if stale.is_empty() { Ok(()) } else { Err(CheckError::Stale(stale).into()) }
}

fn describe(root: &Path, difference: &Difference) -> String {
    let path = |name: &str| kernels(root).join(name).display().to_string();
    match difference {
        Difference::Stale(name, diff) => format!("stale: {}\n{diff}", path(name)),
        Difference::Missing(name) => format!("missing: {}", path(name)),
        Difference::Orphan(name) => format!("orphan, made by nothing: {}", path(name)),
    }
}

fn live(root: &Path) -> miette::Result<()> {
    let folder = worksheets(root);
    worker::run(&Source::Rederived { folder: folder.clone(), kernels: kernels(root) })?;
    let mut wrong = Vec::new();
    for name in family_names(&folder)? {
        for disagreement in compare_golden(&folder, &name, &Options::default())? {
            let golden = &disagreement.golden;
            let now = disagreement.now.unwrap_or_else(|failure| failure.to_string());
            wrong.push(format!("{}.tsv, {}: golden {} but Maxima says {now}", name, golden.worksheet, golden.value));
        }
    }
    if wrong.is_empty() { Ok(()) } else { Err(CheckError::Golden(wrong).into()) }
}
