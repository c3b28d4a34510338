//! `closedform generate`: references to kernels, proved and measured; or a worksheet of one's own to a crate of its own.

use super::{output, readme};
use crate::catalogue::Catalogue;
use crate::pipeline::Made;
use crate::worker::{self, Source};
use crate::{crate_text, folder, ledger};
use clap::Args as ClapArgs;
use comfy_table::Table;
use miette::{IntoDiagnostic, WrapErr, bail};
use std::path::{Path, PathBuf};

/// Make the kernels from the reference expressions
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// A worksheet of definitions `f(x,y) := ..` to make a crate of, instead of this project's families
    #[arg(long, value_name = "FILE.mac", requires = "out")]
    input: Option<PathBuf>,
    /// The folder of that crate
    #[arg(long, value_name = "DIR", requires = "input")]
    out: Option<PathBuf>,
    /// How many points of each kernel's domain to measure for the table; README.md and the ledger are written with the default only
    #[arg(long, default_value_t = ledger::POINTS)]
    points: u32,
}

/// Generates.
///
/// # Errors
///
/// When a family is wrong, a kernel cannot be made or proved, or files cannot be written.
pub fn run(args: &Args, root: &Path) -> miette::Result<()> {
    match (&args.input, &args.out) {
        (Some(input), Some(out)) => own_crate(args, input, out, root),
        _ => project(args, root),
    }
}

/// Where this project's worksheets are.
#[must_use]
pub fn worksheets(root: &Path) -> PathBuf {
    root.join("maxima-ref")
}

/// Where this project's kernels are.
#[must_use]
pub fn kernels(root: &Path) -> PathBuf {
    root.join("kernels/src/generated")
}

fn project(args: &Args, root: &Path) -> miette::Result<()> {
    let generated = worker::run(&Source::Folder(worksheets(root)))?;
    let target = kernels(root);
    let mut changed = write(&target, &generated.files)?;
    let catalogue = Catalogue::load(&target)?;
    let rows = ledger::rows(root, &catalogue, args.points)?;
    if args.points == ledger::POINTS {
        changed += usize::from(readme::update(root, &catalogue, &rows)?);
        changed += usize::from(ledger::update(root, &rows)?);
    }
    report(&generated.kernels, &catalogue, &rows)?;
    output::note(&format!(
        "{} kernels, all proved equal to their reference expressions, all bounds proved; {changed} files changed",
        generated.kernels.len()
    ));
    Ok(())
}

fn own_crate(args: &Args, input: &Path, out: &Path, root: &Path) -> miette::Result<()> {
    let occupied = out.exists() && !out.join(crate_text::MARKER).exists() && !is_empty(out)?;
    if occupied {
        bail!(
            help = "name a folder that is new or empty, or one that this command has made before",
            "{} holds something else",
            out.display()
        );
    }
    let generated = worker::run(&Source::Worksheet(input.to_owned()))?;
    let crate_files = crate_text::files(input, root, &generated)?;
    for (below, files) in &crate_files {
        write(&out.join(below), files)?;
    }
    let catalogue = Catalogue::load(&out.join("src"))?;
    report(&generated.kernels, &catalogue, &ledger::rows(out, &catalogue, args.points)?)?;
    let count = generated.kernels.len();
    output::note(&format!("{count} kernels in {}: `cargo test` there runs their judges", out.display()));
    Ok(())
}

fn is_empty(folder: &Path) -> miette::Result<bool> {
    Ok(std::fs::read_dir(folder).into_diagnostic()?.next().is_none())
}

fn write(target: &Path, files: &std::collections::BTreeMap<String, String>) -> miette::Result<usize> {
    folder::replace(target, files).into_diagnostic().wrap_err_with(|| format!("cannot write {}", target.display()))
}

fn report(made: &[Made], catalogue: &Catalogue, rows: &[ledger::Row]) -> miette::Result<()> {
    let mut table: Table = output::table(["kernel", "rules", "+ * / sqrt wide", "worst ulp", "bound", "proof"]);
    for entry in catalogue.entries() {
        let Some(kernel) = made.iter().find(|kernel| kernel.kernel == entry.full_name()) else { continue };
        table.add_row([
            kernel.kernel.clone(),
            kernel.rules.join(" "),
            kernel.operations.map(|count| count.to_string()).join(" "),
            format!("{:.2}", ledger::worst_of(rows, &entry.full_name())),
            format!("{}", kernel.bound),
            "exact".to_owned(),
        ]);
    }
    output::print(&format!("{table}\n"))?;
    hold(rows)
}

/// Every measured error is within its bound.
fn hold(rows: &[ledger::Row]) -> miette::Result<()> {
    let wrong: Vec<&ledger::Row> = rows.iter().filter(|row| row.worst > row.bound).collect();
    let [first, ..] = wrong.as_slice() else { return Ok(()) };
    bail!(
        help =
            "a bound that does not hold is a mistake of the generator or of the domain; `closedform verify` shows more",
        "{} {} its bound: `{}` of `{}` is off by {} ulp at {}",
        wrong.len(),
        if wrong.len() == 1 { "result exceeds" } else { "results exceed" },
        first.result,
        first.kernel,
        first.worst_ulp,
        first.worst_inputs
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;
    use crate::drawn::{drawn, has};

    #[test]
    fn an_error_beyond_its_bound_is_refused() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = ledger::rows(folder.path(), &catalogue, 50).unwrap();
        let error = hold(&rows).unwrap_err();
        has(&drawn(error.as_ref()), &["1 result exceeds its bound", "`slope` of `line::slope`", "closedform verify"]);
        let right: Vec<ledger::Row> = rows.into_iter().filter(|row| row.kernel != "line::slope").collect();
        assert!(hold(&right).is_ok());
    }
}
