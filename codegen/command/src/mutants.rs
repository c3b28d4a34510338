//! `closedform mutants [KERNEL]`: kernels with one mistake each, which the judges must tell from the kernel.

mod report;

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;

use miette::Diagnostic;
use thiserror::Error;

use crate::bar::progress_bar;
use closedform_measure::catalogue::Catalogue;
use closedform_mutants::{Effort, Equivalents, Lists, MutateError, Outcome, Unneeded, examine};
use closedform_project::Project;
use closedform_system::output;
use report::Row;

/// Make one mistake at a time in every kernel, and see that the judges find each
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// `family::name`, the name alone, or the worksheet's name of a result; all kernels if left off
    kernel: Option<String>,
    /// How many points of each kernel's domain all others are made from
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
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
#[error("{}", summary(*survivors, *unneeded, unjudged.len()))]
#[diagnostic(help(
    "a survivor is a hole in the points, a part that the kernel does not need, or the same function; \
     the last kind goes into {list} with its reason"
))]
struct MutantsError {
    /// The list of equivalent mutants, as one reads its path from the root.
    list: String,
    survivors: usize,
    unneeded: usize,
    #[related]
    unjudged: Vec<MutateError>,
}

/// Judges the mutants of one kernel or all.
///
/// # Errors
///
/// When there is no such kernel, kernels cannot be read or judged, a mutant survives, or a listed one does not.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let catalogue = Catalogue::open(project)?;
    let names: Vec<String> =
        catalogue.select(args.kernel.as_deref())?.into_iter().map(|entry| entry.full_name()).collect();
    let lists = Lists::load(&project.records)?;
    let (mut outcomes, mut unjudged) = (Vec::new(), Vec::new());
    for judged in judged(args, project, &names, &lists)? {
        match judged {
            Ok(outcome) => outcomes.push(outcome),
            Err(cause) => unjudged.push(cause),
        }
    }
    let rows: Vec<Row> = outcomes.iter().map(|outcome| Row::new(outcome, &lists.equivalents)).collect();
    let unneeded = lists.equivalents.unneeded(&outcomes, args.kernel.is_none());
    if args.json {
        output::print_json(&rows)?
    } else {
        output::print(&report::text(&rows, &unneeded))?
    }
    conclude(project.shown(&Equivalents::path(&project.records)), &rows, &unneeded, unjudged)
}

fn conclude(list: String, rows: &[Row], unneeded: &[Unneeded], unjudged: Vec<MutateError>) -> miette::Result<()> {
    let survivors = rows.iter().map(Row::survivors).sum();
    if survivors == 0 && unneeded.is_empty() && unjudged.is_empty() {
        return Ok(());
    }
    Err(MutantsError { list, survivors, unneeded: unneeded.len(), unjudged }.into())
}

type Judged = Vec<(usize, Result<Outcome, MutateError>)>;

/// The outcome of every kernel, in order, from all processors.
fn judged(
    args: &Args,
    project: &Project,
    names: &[String],
    lists: &Lists,
) -> Result<Vec<Result<Outcome, MutateError>>, MutateError> {
    let bar = progress_bar(names.len() as u64, "{bar:30} {pos}/{len} {msg}");
    let queue = Mutex::new(names.iter().enumerate());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    // Trees do not cross threads: each reads the sources itself.
    let work = || -> Result<Judged, MutateError> {
        let catalogue = Catalogue::open(project)?;
        let mut judged = Vec::new();
        while let Some((position, name)) = next() {
            bar.set_message(name.clone());
            judged.push((position, judge(args, &catalogue, name, lists)));
            bar.inc(1);
        }
        Ok(judged)
    };
    let mut all = Vec::new();
    for judged in on_all_processors(work) {
        all.extend(judged?);
    }
    bar.finish_and_clear();
    all.sort_by_key(|(position, _)| *position);
    Ok(all.into_iter().map(|(_, outcome)| outcome).collect())
}

fn judge(args: &Args, catalogue: &Catalogue, name: &str, lists: &Lists) -> Result<Outcome, MutateError> {
    let effort = Effort { points: args.points as usize, ..Effort::USUAL };
    examine(catalogue.find(name)?, lists, effort, args.seed)
}

fn on_all_processors<R: Send>(work: impl Fn() -> R + Sync) -> Vec<R> {
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        let running: Vec<_> = (0..processors).map(|_| scope.spawn(&work)).collect();
        let joined = running.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.collect()
    })
}

fn summary(survivors: usize, unneeded: usize, unjudged: usize) -> String {
    let count = |count: usize, one: &str, more: &str| match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{count} {more}")),
    };
    let parts = [
        count(survivors, "mutant survives", "mutants survive"),
        count(unneeded, "entry of the list is not needed", "entries of the list are not needed"),
        count(unjudged, "kernel was not judged", "kernels were not judged"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}
