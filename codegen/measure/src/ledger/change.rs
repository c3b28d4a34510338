//! How the rows of a ledger differ from those of the one that is on disk: what got better, and what worse.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::Deserialize;

use super::Row;

/// What became of one result.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// `family::name`
    pub kernel: String,
    /// The result.
    pub result: String,
    /// What became of it.
    pub kind: Kind,
}

/// What became of a result.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// The ledger does not know it.
    New,
    /// The ledger knows it, but there is no such result any more.
    Gone,
    /// Numbers differ, and none is larger.
    Better(Vec<Step>),
    /// Numbers differ, and one is larger.
    Worse(Vec<Step>),
}

/// A number that is not what it was; smaller ones are better.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Which.
    pub what: &'static str,
    /// What the ledger says.
    pub was: String,
    /// What was found now.
    pub is: String,
}

/// A row as it was written, by this version or an earlier one.
#[derive(Debug, Deserialize)]
struct Written {
    kernel: String,
    result: String,
    #[serde(default)]
    bound_ulp: String,
    #[serde(default)]
    worst_ulp: String,
    #[serde(default)]
    default_cost: String,
    #[serde(default)]
    faithful_cost: String,
}

impl Change {
    /// The family of the kernel.
    #[must_use]
    pub fn family(&self) -> &str {
        self.kernel.split("::").next().unwrap_or_default()
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kernel, result, kind } = self;
        write!(f, "{kernel}")?;
        if kernel.split("::").nth(1) != Some(result) {
            write!(f, " {result}")?;
        }
        match kind {
            Kind::New => write!(f, ": new"),
            Kind::Gone => write!(f, ": gone"),
            Kind::Better(steps) | Kind::Worse(steps) => {
                let steps = steps.iter().map(|Step { what, was, is }| format!("{what} {was} -> {is}"));
                write!(f, ": {}", steps.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// The changes from the text of a ledger to these rows, in order. `measured`: the rows are measured at as many points as those
/// of a ledger, so that their worst errors compare.
#[must_use]
pub fn changes(ledger: &str, rows: &[Row], measured: bool) -> Vec<Change> {
    let mut reader = csv::Reader::from_reader(ledger.as_bytes());
    // a line that does not read is of a result that is new now
    let written = reader.deserialize::<Written>().filter_map(Result::ok);
    let written: BTreeMap<(String, String), Written> =
        written.map(|row| ((row.kernel.clone(), row.result.clone()), row)).collect();
    let present: BTreeMap<(String, String), &Row> =
        rows.iter().map(|row| ((row.kernel.clone(), row.result.clone()), row)).collect();
    let names: BTreeSet<&(String, String)> = written.keys().chain(present.keys()).collect();
    let change = |name: &(String, String)| {
        let kind = match (written.get(name), present.get(name)) {
            (Some(was), Some(is)) => compared(was, is, measured)?,
            (None, _) => Kind::New,
            (_, None) => Kind::Gone,
        };
        Some(Change { kernel: name.0.clone(), result: name.1.clone(), kind })
    };
    names.into_iter().filter_map(change).collect()
}

fn compared(was: &Written, is: &Row, measured: bool) -> Option<Kind> {
    let numbers = [
        ("bound", &was.bound_ulp, is.bound_ulp.clone()),
        ("worst", &was.worst_ulp, if measured { is.worst_ulp.clone() } else { was.worst_ulp.clone() }),
        ("cost", &was.default_cost, is.default_cost.to_string()),
        ("faithful cost", &was.faithful_cost, is.faithful_cost.to_string()),
    ];
    let steps = numbers.into_iter().filter(|(_, was, is)| !was.is_empty() && *was != is);
    let steps: Vec<Step> = steps.map(|(what, was, is)| Step { what, was: was.clone(), is }).collect();
    match steps.iter().any(Step::is_worse) {
        _ if steps.is_empty() => None,
        true => Some(Kind::Worse(steps)),
        false => Some(Kind::Better(steps)),
    }
}

impl Step {
    /// A number that is larger now, or none any more.
    fn is_worse(&self) -> bool {
        let number = |text: &str| text.parse().unwrap_or(f64::INFINITY);
        number(&self.is) > number(&self.was)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;
    use crate::ledger::{rows, text};

    #[test]
    fn every_change_is_told_with_its_direction() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = rows(folder.path(), &catalogue, 5).unwrap();
        let ledger = text(&rows).unwrap();
        assert_eq!(changes(&ledger, &rows, true), []);
        let mut now = rows.clone();
        now[0].bound_ulp = "2.5".to_owned(); // was 3.5
        now[0].default_cost += 1;
        now[2].faithful_cost -= 1;
        now.remove(1);
        let said: Vec<String> = changes(&ledger, &now, true).iter().map(Change::to_string).collect();
        let cost = |row: usize| (rows[row].default_cost, rows[row].faithful_cost);
        assert_eq!(
            said,
            [
                format!("line::root: bound 3.5 -> 2.5, cost {} -> {}", cost(0).0, cost(0).0 + 1),
                "line::slope: gone".to_owned(),
                format!("plane::slope c: faithful cost {} -> {}", cost(2).1, cost(2).1 - 1),
            ]
        );
        let kinds = changes(&ledger, &now, true);
        assert!(matches!((&kinds[0].kind, &kinds[2].kind), (Kind::Worse(_), Kind::Better(_))));
        assert_eq!(kinds[2].family(), "plane");
        assert!(changes("", &rows, true).iter().all(|change| change.kind == Kind::New));
    }

    #[test]
    fn what_was_measured_otherwise_is_not_compared() {
        let (folder, catalogue) = fixture::catalogue();
        let few = rows(folder.path(), &catalogue, 5).unwrap();
        let ledger = text(&rows(folder.path(), &catalogue, 50).unwrap()).unwrap();
        assert_eq!(changes(&ledger, &few, false), []);
        assert_ne!(changes(&ledger, &few, true), []);
    }

    #[test]
    fn a_ledger_of_an_earlier_version_compares_as_far_as_it_goes() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = rows(folder.path(), &catalogue, 5).unwrap();
        let ledger = "kernel,result,bound_ulp,plain_cost\nline::root,root,9.5,3\n";
        let root = &changes(ledger, &rows, true)[0];
        assert_eq!(root.to_string(), "line::root: bound 9.5 -> 3.5");
    }
}
