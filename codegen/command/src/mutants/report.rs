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
    #[serde(skip)]
    kernel: String,
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
        let kernel = outcome.kernel.clone();
        Survivor { kernel, place, step, mistake, was: change.was.clone(), is: change.is.clone() }
    }
}

/// The table of all rows, and what is wrong.
pub fn text(rows: &[Row], unneeded: &[Unneeded]) -> String {
    let header = ["kernel", "mutants", "killed", "same function", "listed", "survivors"];
    let cells = |name: &str, counts: [usize; 5]| -> [String; 6] {
        std::array::from_fn(|at| if at == 0 { name.to_owned() } else { counts[at - 1].to_string() })
    };
    let sum = |at: usize| rows.iter().map(|row| row.counts()[at]).sum();
    let all = cells("all", [0, 1, 2, 3, 4].map(sum));
    let table = crate::columns::table(header, rows.iter().map(|row| cells(&row.kernel, row.counts())).chain([all]));
    let mut text = format!("{table}\n");
    for survivor in rows.iter().flat_map(|row| &row.survivors) {
        let Survivor { kernel, place, step, mistake, was, is } = survivor;
        let _ = writeln!(text, "\nsurvives: {place}\n- {was}\n+ {is}");
        // as the list of equivalent mutants takes it
        let _ = writeln!(
            text,
            "[[equivalent]]\nkernel = {kernel:?}\nstep = {step:?}\nmistakes = [{mistake:?}]\nreason = \"..\""
        );
    }
    for Unneeded { kernel, mistake } in unneeded {
        let _ = writeln!(text, "\nlisted, but killed or gone: {kernel}, {mistake}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_survivor_is_told_as_the_list_takes_it() {
        let words = ["a::f", "a::f at line 3 of a.rs", "result", "<= as ==", "x <= 0.0", "x == 0.0"].map(str::to_owned);
        let [kernel, place, step, mistake, was, is] = words;
        let survivors = vec![Survivor { kernel: kernel.clone(), place, step, mistake, was, is }];
        let row = Row { kernel, mutants: 1, killed: 0, same: 0, listed: Vec::new(), survivors };
        let text = text(&[row], &[]);
        let (_, told) = text.split_once("survives: a::f at line 3 of a.rs\n- x <= 0.0\n+ x == 0.0\n").unwrap();
        let list: toml::Table = told.parse().unwrap();
        let entry = &list["equivalent"][0];
        assert_eq!((entry["kernel"].as_str(), entry["step"].as_str()), (Some("a::f"), Some("result")));
        assert_eq!(entry["mistakes"][0].as_str(), Some("<= as =="));
    }
}
