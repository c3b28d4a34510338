//! `closedform verify [KERNEL]`: kernels against their references, at points chosen where it hurts.

mod report;
mod search;

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use miette::{Diagnostic, bail};
use thiserror::Error;

use closedform_measure::accuracy::{Measurement, Reference, ReferenceError, ValueError, measure};
use closedform_measure::catalogue::{Catalogue, DomainError, Entry};
use closedform_measure::kept::KeptInputs;
use closedform_measure::search::{Budget, SearchError, parse_duration};
use closedform_project::Project;
use closedform_project::sample::{EmptyDomain, sample};
use closedform_system::output;
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
    /// Climb towards the worst inputs for so long in all, such as 60s or 10min, instead of measuring points
    #[arg(long, alias = "hunt", value_name = "TIME", value_parser = parse_duration, conflicts_with_all = ["steps", "points"])]
    search: Option<Duration>,
    /// Climb so many steps for each result: the same search for the same seed
    #[arg(long, value_name = "N", conflicts_with = "points")]
    steps: Option<u64>,
    /// Keep the worst inputs found among the records of the project, where every judge replays them
    #[arg(long)]
    keep: bool,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

/// What was found wrong.
#[derive(Debug, Error, Diagnostic)]
#[error("{}", summary(*exceeded, unmeasured.len()))]
#[diagnostic(help("a bound that does not hold is a mistake of the generator or of the domain"))]
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
    Search(#[from] SearchError),
}

/// No point was measured.
#[derive(Debug, Error, Diagnostic)]
#[error("the bound covers none of {points} points: results over- or underflow")]
#[diagnostic(help("correct the `typical` magnitudes of the inputs, in a contract NAME.toml or in `#[input(..)]`"))]
struct Uncovered {
    points: usize,
}

/// Verifies one kernel or all.
///
/// # Errors
///
/// When there is no such kernel, kernels cannot be read or measured, or a bound does not hold.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let entries = catalogue.select(args.kernel.as_deref())?;
    let (rows, unmeasured) = match plan(args)? {
        Some(plan) => {
            let bar = progress_bar(entries.len() as u64);
            let found = search::searched(&catalogue, &entries, plan, project, &bar)?;
            bar.finish_and_clear();
            found
        }
        None => sampled(&entries, args, project)?,
    };
    if args.json {
        output::print_json(&rows)?
    } else {
        output::print(&report::text(&rows, args.seed))?
    }
    conclude(&rows, unmeasured)
}

/// How to search, if that is asked for.
fn plan(args: &Args) -> miette::Result<Option<search::Plan>> {
    let budget = args.search.map(Budget::Time).or(args.steps.map(Budget::Steps));
    if args.keep && budget.is_none() {
        bail!(
            help = "add --search 60s, or --steps 0 to measure again what is kept",
            "nothing to keep without a search"
        );
    }
    Ok(budget.map(|budget| search::Plan { budget, seed: args.seed, keep: args.keep }))
}

/// Measures kernels at the points kept of them and at samples of their domains.
fn sampled(entries: &[&Entry], args: &Args, project: &Project) -> miette::Result<(Vec<Row>, Vec<Unmeasured>)> {
    let kept = KeptInputs::load(&project.records)?;
    let bar = progress_bar(entries.len() as u64 * u64::from(args.points));
    let replay = Replay { root: &project.root, seed: args.seed };
    let (mut rows, mut unmeasured) = (Vec::new(), Vec::new());
    for entry in entries {
        bar.set_message(entry.full_name());
        match measured(entry, &kept, args, &bar) {
            Ok(measurement) => rows.extend(report::rows(entry, &measurement, &replay)),
            Err(cause) => unmeasured.push(Unmeasured { kernel: entry.full_name(), cause }),
        }
    }
    bar.finish_and_clear();
    Ok((rows, unmeasured))
}

fn measured(entry: &Entry, kept: &KeptInputs, args: &Args, bar: &ProgressBar) -> Result<Measurement, Cause> {
    let domain = entry.domain()?;
    let mut points = kept.points(entry).concat();
    points.retain(|point| domain.holds(point));
    points.extend(sample(&domain, &entry.inputs().iter().collect::<Vec<_>>(), args.points as usize, args.seed)?);
    let measurement = measure(&entry.kernel, &Reference::of(&entry.kernel)?, &points, || bar.inc(1))?;
    if measurement.covered == 0 {
        return Err(Uncovered { points: points.len() }.into());
    }
    Ok(measurement)
}

fn conclude(rows: &[Row], unmeasured: Vec<Unmeasured>) -> miette::Result<()> {
    let exceeded: Vec<&Row> = rows.iter().filter(|row| row.exceeds()).collect();
    for row in &exceeded {
        output::note(&row.failure());
    }
    if exceeded.is_empty() && unmeasured.is_empty() {
        return Ok(());
    }
    Err(VerifyError { exceeded: exceeded.len(), unmeasured }.into())
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
    use closedform_measure::catalogue::fixture;

    fn arguments(points: u32, seed: u64) -> Args {
        Args { kernel: None, points, seed, search: None, steps: None, keep: false, json: true }
    }

    fn verified(kernel: &str) -> Vec<Row> {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find(kernel).unwrap();
        let args = arguments(300, 7);
        let measurement = measured(entry, &KeptInputs::default(), &args, &ProgressBar::hidden()).unwrap();
        report::rows(entry, &measurement, &Replay { root: std::path::Path::new("."), seed: 7 })
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
    fn what_a_search_finds_is_kept_and_replayed() {
        let (folder, catalogue) = fixture::catalogue();
        let searched = |keep| Args { steps: Some(500), keep, ..arguments(1, 1) };
        let project = Project::at(folder.path()).unwrap();
        let error = run(&searched(true), &project).unwrap_err();
        assert_eq!(error.to_string(), "1 result exceeds its bound");
        let kept = KeptInputs::load(&project.records).unwrap();
        let entry = catalogue.find("line::slope").unwrap();
        let measurement = measured(entry, &kept, &arguments(1, 1), &ProgressBar::hidden()).unwrap();
        assert!(measurement.worst[0].as_ref().is_some_and(|worst| worst.ulp > 1e3), "{measurement:?}");
        let again = search::searched(
            &catalogue,
            &[entry],
            plan(&searched(false)).unwrap().unwrap(),
            &project,
            &ProgressBar::hidden(),
        );
        let (rows, _) = again.unwrap();
        assert!(rows[0].exceeds());
        assert_eq!(KeptInputs::load(&project.records).unwrap(), kept);
    }

    #[test]
    fn keeping_needs_a_search() {
        assert!(plan(&Args { keep: true, ..arguments(1, 1) }).is_err());
        assert!(plan(&arguments(1, 1)).unwrap().is_none());
    }

    #[test]
    fn what_cannot_be_measured_says_why() {
        let folder = tempfile::tempdir().unwrap();
        let source = "#[kernel]\npub fn f(x: f64) -> f64 { require!(x > 0.0 && x < 1.0); x }";
        std::fs::write(folder.path().join("hand.rs"), source).unwrap();
        let args = arguments(10, 1);
        let error = run(&args, &Project::at(folder.path()).unwrap()).unwrap_err();
        assert_eq!(error.to_string(), "1 kernel was not measured");
    }
}
