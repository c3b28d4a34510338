//! `closedform verify [KERNEL]`: kernels against their references, at points chosen where it hurts.

mod report;

use std::path::Path;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use miette::Diagnostic;
use thiserror::Error;

use super::output;
use crate::catalogue::{Catalogue, DomainError, Entry};
use crate::measure::{Measurement, Reference, ReferenceError, ValueError, measure};
use crate::worksheet::sample::{EmptyDomain, sample};
use report::{Replay, Row};

/// Measure kernels against their references in MPFR, and hold them to their bounds
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// `family::name`, the name alone, or the worksheet's name of a result; all kernels if left off
    kernel: Option<String>,
    /// How many points of each kernel's domain to measure
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
    points: u32,
    /// Where the random numbers start: the same points for the same seed
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

/// What was found wrong.
#[derive(Debug, Error, Diagnostic)]
#[error("{}", summary(*exceeded, unmeasured.len()))]
#[diagnostic(help("a bound that does not hold is a mistake of the generator or of the contract's domain"))]
struct VerifyError {
    exceeded: usize,
    #[related]
    unmeasured: Vec<Unmeasured>,
}

/// A kernel that was not measured.
#[derive(Debug, Error, Diagnostic)]
#[error("`{kernel}` was not measured")]
struct Unmeasured {
    kernel: String,
    #[source]
    #[diagnostic_source]
    cause: Cause,
}

/// Why a kernel was not measured.
#[derive(Debug, Error, Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
enum Cause {
    Domain(#[from] DomainError),
    Empty(#[from] EmptyDomain),
    Reference(#[from] ReferenceError),
    Value(#[from] ValueError),
    Uncovered(#[from] Uncovered),
}

/// No point was measured.
#[derive(Debug, Error, Diagnostic)]
#[error("the bound covers none of {points} points: steps over- or underflow")]
#[diagnostic(help("correct the `typical` magnitudes of the inputs in the contract"))]
struct Uncovered {
    points: usize,
}

/// Verifies one kernel or all.
///
/// # Errors
///
/// When there is no such kernel, kernels cannot be read or measured, or a bound does not hold.
pub fn run(args: &Args, root: &Path) -> miette::Result<()> {
    let catalogue = Catalogue::open(root)?;
    let entries = catalogue.select(args.kernel.as_deref())?;
    let bar = progress_bar(entries.len() as u64 * u64::from(args.points));
    let replay = Replay { root, seed: args.seed };
    let (mut rows, mut unmeasured) = (Vec::new(), Vec::new());
    for entry in &entries {
        bar.set_message(entry.full_name());
        match measured(entry, args, &bar) {
            Ok(measurement) => rows.extend(report::rows(entry, &measurement, &replay)),
            Err(cause) => unmeasured.push(Unmeasured { kernel: entry.full_name(), cause }),
        }
    }
    bar.finish_and_clear();
    if args.json {
        output::print_json(&rows)?
    } else {
        output::print(&report::text(&rows, args.seed))?
    }
    conclude(&rows, unmeasured)
}

fn measured(entry: &Entry, args: &Args, bar: &ProgressBar) -> Result<Measurement, Cause> {
    let points = sample(&entry.domain()?, &entry.inputs().iter().collect::<Vec<_>>(), args.points as usize, args.seed)?;
    let measurement = measure(&entry.kernel, &Reference::of(&entry.kernel)?, &points, || bar.inc(1))?;
    if measurement.covered == 0 {
        return Err(Uncovered { points: points.len() }.into());
    }
    Ok(measurement)
}

/// The worst error in ulp of all results of a kernel at some points of its domain.
///
/// # Errors
///
/// When the kernel cannot be measured.
fn worst_of(entry: &Entry, points: u32) -> miette::Result<f64> {
    let points = sample(&entry.domain()?, &entry.inputs().iter().collect::<Vec<_>>(), points as usize, 1)?;
    let measurement = measure(&entry.kernel, &Reference::of(&entry.kernel)?, &points, || ())?;
    Ok(measurement.worst.iter().flatten().map(|worst| worst.ulp).fold(0.0, f64::max))
}

/// The worst error in ulp of each kernel, in order.
///
/// # Errors
///
/// When a kernel cannot be measured.
pub fn worst_of_all(catalogue: &Catalogue, points: u32) -> miette::Result<Vec<f64>> {
    catalogue.entries().iter().map(|entry| worst_of(entry, points)).collect()
}

fn conclude(rows: &[Row], unmeasured: Vec<Unmeasured>) -> miette::Result<()> {
    let exceeded: Vec<&Row> = rows.iter().filter(|row| row.exceeds()).collect();
    for row in &exceeded {
        eprint_lossy(&row.failure());
    }
    if exceeded.is_empty() && unmeasured.is_empty() {
        return Ok(());
    }
    Err(VerifyError { exceeded: exceeded.len(), unmeasured }.into())
}

/// Writes to standard error, if anybody reads it.
fn eprint_lossy(text: &str) {
    use std::io::Write as _;
    let _ = writeln!(std::io::stderr(), "{text}");
}

fn summary(exceeded: usize, unmeasured: usize) -> String {
    let results = if exceeded == 1 { "result exceeds its bound" } else { "results exceed their bounds" };
    let kernels = if unmeasured == 1 { "kernel was not measured" } else { "kernels were not measured" };
    let parts = [(exceeded, results), (unmeasured, kernels)];
    let parts = parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
    parts.collect::<Vec<_>>().join(", ")
}

/// A bar on standard error; hidden where that is no terminal.
fn progress_bar(points: u64) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{bar:30} {percent:>3}% {msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::with_draw_target(Some(points), ProgressDrawTarget::stderr()).with_style(style)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;

    fn verified(kernel: &str) -> Vec<Row> {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find(kernel).unwrap();
        let args = Args { kernel: None, points: 300, seed: 7, json: false };
        let measurement = measured(entry, &args, &ProgressBar::hidden()).unwrap();
        report::rows(entry, &measurement, &Replay { root: Path::new("."), seed: 7 })
    }

    #[test]
    fn a_bound_that_holds_is_no_error() {
        for kernel in ["line::root", "plane::slope"] {
            let rows = verified(kernel);
            assert!(rows.iter().all(|row| !row.exceeds()), "{rows:?}");
            assert!(conclude(&rows, Vec::new()).is_ok());
        }
    }

    #[test]
    fn a_bound_that_does_not_hold_is_an_error_that_can_be_replayed() {
        let rows = verified("line::slope");
        assert!(rows[0].exceeds());
        let text = rows[0].failure();
        for part in ["expected", "actual", "bound 0.5", "seed 7", "closedform eval line::slope x=0x1", " --digits 40"] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
        let error = conclude(&rows, Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "1 result exceeds its bound");
    }

    #[test]
    fn what_cannot_be_measured_says_why() {
        let folder = tempfile::tempdir().unwrap();
        let source = "#[kernel]\npub fn f(x: f64) -> f64 { require!(x > 0.0 && x < 1.0); x }";
        std::fs::write(folder.path().join("hand.rs"), source).unwrap();
        let args = Args { kernel: None, points: 10, seed: 1, json: true };
        let error = run(&args, folder.path()).unwrap_err();
        assert_eq!(error.to_string(), "1 kernel was not measured");
    }
}
