//! `closedform verify --search`: kernels searched for their worst inputs, which may be kept.

use std::time::{Duration, Instant};

use indicatif::ProgressBar;

use super::report::{Replay, Row};
use super::{Cause, Unmeasured};
use closedform_measure::accuracy::Reference;
use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_measure::kept::KeptInputs;
use closedform_measure::search::{Budget, Found, Target, search};
use closedform_project::Project;

/// What the searches of all kernels may spend.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Together, if it is time; otherwise each.
    pub budget: Budget,
    /// Where the random numbers start.
    pub seed: u64,
    /// Whether to keep what is found.
    pub keep: bool,
}

/// Searches kernels, in order; what was found, and what could not be searched.
///
/// # Errors
///
/// When kept inputs cannot be read or written.
pub fn searched(
    catalogue: &Catalogue,
    entries: &[&Entry],
    plan: Plan,
    project: &Project,
    bar: &ProgressBar,
) -> miette::Result<(Vec<Row>, Vec<Unmeasured>)> {
    let mut kept = KeptInputs::load(&project.records)?;
    let (mut rows, mut unmeasured) = (Vec::new(), Vec::new());
    let begin = Instant::now();
    for (turn, entry) in entries.iter().enumerate() {
        bar.set_message(entry.full_name());
        match search_one(entry, &kept, share(plan.budget, begin, &entries[turn..]), plan.seed) {
            Ok((rows_of_entry, found)) => {
                let replay = Replay { root: &project.root, seed: plan.seed };
                rows.extend(Row::searched(entry, &rows_of_entry, &found, &replay));
                kept.replace(entry, &found.worst);
            }
            Err(cause) => unmeasured.push(Unmeasured { kernel: entry.full_name(), cause }),
        }
        bar.inc(1);
    }
    if plan.keep {
        kept.write(&project.records, catalogue)?;
    }
    Ok((rows, unmeasured))
}

/// The part of what is left that the first of these kernels may spend: as much for each result.
fn share(budget: Budget, begin: Instant, left: &[&Entry]) -> Budget {
    let results = |entry: &Entry| entry.kernel.meta.results.len() as u32;
    match budget {
        Budget::Steps(_) => budget,
        Budget::Time(time) => {
            let all: u32 = left.iter().map(|entry| results(entry)).sum();
            let rest: Duration = time.saturating_sub(begin.elapsed());
            Budget::Time(rest * left.first().map_or(0, |entry| results(entry)) / all.max(1))
        }
    }
}

/// The worst errors at the kept inputs before the search, and what the search found.
fn search_one(entry: &Entry, kept: &KeptInputs, budget: Budget, seed: u64) -> Result<(Vec<Option<f64>>, Found), Cause> {
    let target = Target {
        kernel: &entry.kernel,
        reference: Reference::of(&entry.kernel)?,
        domain: entry.domain()?,
        inputs: entry.inputs(),
    };
    let known = kept.points(entry);
    let found = search(&target, &known, budget, seed)?;
    let before = found.worst.iter().zip(&known).map(|(worst, known)| {
        // worst first
        worst.iter().find(|worst| known.contains(&worst.inputs)).map(|worst| worst.ulp)
    });
    Ok((before.collect(), found))
}
