//! `closedform check`: the generated kernels are what the references say, and with `--maxima` what Maxima says today.

use super::generate::{kernels, worksheets};
use super::{kernel_table, verdicts};
use crate::worker::{self, Source};
use clap::Args as ClapArgs;
use closedform_bounds::certified_bound_proof;
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_measure::ledger;
use closedform_project::derive::{Options, compare_golden};
use closedform_project::family::family_names;
use closedform_project::folder::{self, Difference};
use closedform_system::output;
use miette::{Diagnostic, IntoDiagnostic};
use std::path::Path;
use thiserror::Error;

/// Check that everything generated is fresh and proved
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// Run the worksheets in Maxima, and hold kernels, golden values and verdicts against what it derives
    #[arg(long)]
    maxima: bool,
    /// Let worksheets start programs, touch files and run Lisp, with your rights
    #[arg(long, requires = "maxima")]
    allow_system: bool,
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
        verdicts::check_live(&worksheets(root), &options(args).maxima)?;
    } else {
        verdicts::check_list(&worksheets(root))?;
    }
    fresh(root)?;
    let folder = kernels(root);
    output::print(&format!(
        "fresh: {} holds what the references generate, all kernels and their bounds proved\n",
        folder.display()
    ))?;
    if args.maxima {
        live(root, &options(args))?;
        let live = "live: every kernel equals what Maxima derives, and every golden value is what Maxima computes\n";
        output::print(live)?;
    }
    Ok(())
}

fn fresh(root: &Path) -> miette::Result<()> {
    let generated = worker::run(&Source::Folder(worksheets(root)))?;
    let differences = folder::compare(&kernels(root), &generated.files).into_diagnostic()?;
    let differences = differences.iter().map(|difference| describe(root, difference));
    let mut stale: Vec<String> = unbounded(root).into_iter().chain(differences).collect();
    if stale.is_empty() && (root.join(kernel_table::PAGE).exists() || root.join("tests").is_dir()) {
        let catalogue = Catalogue::load(&kernels(root))?;
        let rows = ledger::rows(root, &catalogue, ledger::POINTS)?;
        let table = kernel_table::expected(root, &catalogue, &rows).filter(|(expected, present)| expected != present);
        stale.extend(table.map(|_| format!("stale: the table of kernels in {}", kernel_table::PAGE)));
        let ledger_text = ledger::expected(root, &rows)?.filter(|(expected, present)| expected != present);
        stale.extend(ledger_text.map(|_| format!("stale: {}", ledger::path(root).display())));
    }
    if stale.is_empty() { Ok(()) } else { Err(CheckError::Stale(stale).into()) }
}

/// The kernels as checked in whose text does not prove the bounds that it states.
fn unbounded(root: &Path) -> Vec<String> {
    let Ok(catalogue) = Catalogue::load(&kernels(root)) else { return Vec::new() };
    let proof = |entry: &Entry| Some((entry.full_name(), certified_bound_proof(&entry.kernel).err()?));
    let refused = catalogue.entries().iter().filter_map(proof);
    refused.map(|(name, cause)| format!("bound of `{name}`, re-derived from its Rust text: {cause}")).collect()
}

fn describe(root: &Path, difference: &Difference) -> String {
    let path = |name: &str| kernels(root).join(name).display().to_string();
    match difference {
        Difference::Stale(name, diff) => format!("stale: {}\n{diff}", path(name)),
        Difference::Missing(name) => format!("missing: {}", path(name)),
        Difference::Orphan(name) => format!("orphan, made by nothing: {}", path(name)),
    }
}

/// How worksheets are run again.
fn options(args: &Args) -> Options {
    let mut options = Options::default();
    options.maxima.allow_system |= args.allow_system;
    options
}

fn live(root: &Path, options: &Options) -> miette::Result<()> {
    let folder = worksheets(root);
    let allow_system = options.maxima.allow_system;
    worker::run(&Source::Rederived { folder: folder.clone(), kernels: kernels(root), allow_system })?;
    let mut wrong = Vec::new();
    for name in family_names(&folder)? {
        for disagreement in compare_golden(&folder, &name, options)? {
            let golden = &disagreement.golden;
            let now = disagreement.now.unwrap_or_else(|failure| failure.to_string());
            wrong.push(format!("{}.tsv, {}: golden {} but Maxima says {now}", name, golden.worksheet, golden.value));
        }
    }
    if wrong.is_empty() { Ok(()) } else { Err(CheckError::Golden(wrong).into()) }
}
