//! Reports: what became of mutants, as a table, as JSON, and survivors as differences of source.

use std::fmt::Write as _;

use serde::Serialize;

use closedform_mutants::{Change, Equivalents, Outcome, Unneeded, Verdict};

/// What became of the mutants of one kernel.
#[derive(Debug, Serialize)]
pub struct Row {
    kernel: String,
    mutants: usize,
    killed: usize,
    /// Proved to be the same function.
    same: usize,
    /// The same function for a reason that the list gives.
    listed: Vec<Listed>,
    survivors: Vec<Survivor>,
}

#[derive(Debug, Serialize)]
struct Listed {
    step: String,
    mistake: String,
    was: String,
    is: String,
    reason: String,
}

#[derive(Debug, Serialize)]
struct Survivor {
    place: String,
    step: String,
    mistake: String,
    was: String,
    is: String,
}

impl Row {
    /// The row of a kernel.
    pub fn new(outcome: &Outcome, equivalents: &Equivalents) -> Self {
        let count = |wanted: Verdict| outcome.mutants.iter().filter(|(_, verdict)| *verdict == wanted).count();
        let reason = |change: &Change| equivalents.reason(&outcome.kernel, change);
        let listed = outcome.survivors().filter_map(|change| Some((change, reason(change)?)));
        let listed = listed.map(|(Change { mistake, was, is, .. }, reason)| Listed {
            step: mistake.step.clone(),
            mistake: mistake.kind.to_string(),
            was: was.clone(),
            is: is.clone(),
            reason: reason.to_owned(),
        });
        let survivors = outcome.survivors().filter(|change| reason(change).is_none());
        Row {
            kernel: outcome.kernel.clone(),
            mutants: outcome.mutants.len(),
            killed: count(Verdict::Killed),
            same: count(Verdict::Same),
            listed: listed.collect(),
            survivors: survivors.map(|change| Survivor::new(outcome, change)).collect(),
        }
    }

    /// How many mutants survived that nothing excuses.
    pub fn survivors(&self) -> usize {
        self.survivors.len()
    }

    fn counts(&self) -> [usize; 5] {
        [self.mutants, self.killed, self.same, self.listed.len(), self.survivors.len()]
    }
}

impl Survivor {
    fn new(outcome: &Outcome, change: &Change) -> Self {
        let place = format!("{} at line {} of {}.rs", outcome.kernel, change.line, outcome.family());
        let (step, mistake) = (change.mistake.step.clone(), change.mistake.kind.to_string());
        Survivor { place, step, mistake, was: change.was.clone(), is: change.is.clone() }
    }
}

/// The table of all rows, and what is wrong.
pub fn text(rows: &[Row], unneeded: &[Unneeded]) -> String {
    let mut table = crate::columns::table(["kernel", "mutants", "killed", "same function", "listed", "survivors"]);
    let cells = |name: &str, counts: [usize; 5]| -> Vec<String> {
        [name.to_owned()].into_iter().chain(counts.map(|count| count.to_string())).collect()
    };
    table.add_rows(rows.iter().map(|row| cells(&row.kernel, row.counts())));
    let sum = |at: usize| rows.iter().map(|row| row.counts()[at]).sum();
    table.add_row(cells("all", [0, 1, 2, 3, 4].map(sum)));
    let mut text = format!("{table}\n");
    for survivor in rows.iter().flat_map(|row| &row.survivors) {
        let Survivor { place, step, mistake, was, is } = survivor;
        let _ = writeln!(text, "\nsurvives: {place}\n  step = \"{step}\", mistakes = [\"{mistake}\"]\n- {was}\n+ {is}");
    }
    for Unneeded { kernel, mistake } in unneeded {
        let _ = writeln!(text, "\nlisted, but killed or gone: {kernel}, {mistake}");
    }
    text
}
