//! The exam: every mutant of a kernel before its judge.

use std::path::Path;

use closedform_syntax::Kernel;

use super::attack::{Attack, attack};
use super::equivalent::Equivalents;
use super::error::MutateError;
use super::judge::Judge;
use super::kind::{Mutant, mutants};
use super::known::Known;
use super::place::Change;
use super::points::Maker;
use super::proof;
use super::same::same_function;
use closedform_measure::catalogue::Entry;
use closedform_measure::kept::KeptInputs;

/// How hard mutants are judged.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Points of the domain from which all others are made.
    pub points: usize,
    /// What mutants are put through that all points let pass.
    pub attack: Attack,
    /// And those that are listed as the same function.
    pub doubt: Attack,
}

impl Effort {
    /// Seconds for most kernels, minutes for those of many branches.
    pub const USUAL: Effort = Effort {
        points: 100,
        attack: Attack { edges: 1000, double_zeros: 20_000, climbs: 8, steps: 2000 },
        doubt: Attack { edges: 40, double_zeros: 200, climbs: 1, steps: 100 },
    };
}

/// What a project's people know of its mutants.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    /// The mutants that are the same function.
    pub equivalents: Equivalents,
    /// Points at which to look.
    pub known: Known,
    /// The worst inputs that searches found.
    pub kept: KeptInputs,
}

impl Lists {
    /// The lists among the records of a project.
    ///
    /// # Errors
    ///
    /// When one of them cannot be read.
    pub fn load(records: &Path) -> Result<Self, MutateError> {
        let (equivalents, known) = (Equivalents::load(records)?, Known::load(records)?);
        Ok(Self { equivalents, known, kept: KeptInputs::load(records)? })
    }
}

/// What became of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A point tells it from the kernel, or its text does not prove its bounds.
    Killed,
    /// It is the same function, proved.
    Same,
    /// Nothing does.
    Survived,
}

/// What became of the mutants of one kernel.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The kernel.
    pub kernel: String,
    /// All mutants.
    pub mutants: Vec<(Change, Verdict)>,
}

impl Outcome {
    /// What nothing told from the kernel.
    pub fn survivors(&self) -> impl Iterator<Item = &Change> {
        self.mutants.iter().filter(|(_, verdict)| *verdict == Verdict::Survived).map(|(change, _)| change)
    }

    /// The family of the kernel: the stem of its file.
    pub fn family(&self) -> &str {
        self.kernel.split("::").next().unwrap_or_default()
    }
}

/// Judges every mutant of a kernel.
///
/// # Errors
///
/// When the kernel has no domain or reference, or is wrong itself.
pub fn examine(entry: &Entry, lists: &Lists, effort: Effort, seed: u64) -> Result<Outcome, MutateError> {
    let mut maker = Maker::new(entry, &entry.domain()?, effort.points, seed)?;
    let name = entry.full_name();
    let mut points = maker.points();
    points.list.extend(lists.known.of(&name, entry.kernel.inputs.len()).cloned());
    points.list.extend(lists.kept.points(entry).concat());
    let mut judge = Judge::new(entry, &points)?;
    let equivalents = &lists.equivalents;
    let mut verdict = |kernel: &Kernel, mutant: &Mutant, by_proof: bool| -> Result<Verdict, MutateError> {
        let listed = equivalents.reason(&name, &mutant.change).is_some();
        let with = if listed { effort.doubt } else { effort.attack };
        Ok(if judge.kills(&mutant.kernel)? || by_proof && proof::refuses(&entry.kernel, kernel, &mutant.kernel) {
            Verdict::Killed
        } else if same_function(kernel, &mutant.kernel) {
            Verdict::Same
        } else if attack(&mut judge, &mut maker, &mutant.kernel, with)? {
            Verdict::Killed
        } else {
            Verdict::Survived
        })
    };
    let mut mutants_judged = Vec::new();
    let mut kernel = entry.kernel.clone();
    // Branches that are never taken are left out one by one, lest all that is in them survives.
    for mistake in equivalents.unreached(&name) {
        let Some(mut left) = mutants(&kernel).into_iter().find(|mutant| mutant.change.mistake == mistake) else {
            continue;
        };
        left.change.unreached = true;
        mutants_judged.push((left.change.clone(), verdict(&kernel, &left, false)?));
        kernel = left.kernel;
    }
    for mutant in mutants(&kernel) {
        let verdict = verdict(&kernel, &mutant, true)?;
        mutants_judged.push((mutant.change, verdict));
    }
    Ok(Outcome { kernel: name, mutants: mutants_judged })
}
