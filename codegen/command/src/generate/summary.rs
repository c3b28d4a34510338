//! What was made, in a few lines: a row for every family or kernel, and what got better or worse against the ledger.

use std::collections::BTreeMap;

use closedform_measure::ledger::change::{Change, Kind};
use closedform_measure::ledger::{Row, worst_of};
use closedform_project::generated::Made;

use crate::columns;

/// How many changes are told one by one.
const TOLD: usize = 20;

/// A row for every kernel, and what changed.
pub fn each_kernel(made: &[Made], rows: &[Row], changes: &[Change]) -> String {
    let lines = made.iter().map(|kernel| {
        let worst = format!("{:.2}", worst_of(rows, &kernel.kernel));
        [kernel.kernel.clone(), worst, kernel.bound.to_string(), kernel.rules.join(" ")]
    });
    columns::text(["kernel", "worst ulp", "bound", "rules"], lines) + &told(changes)
}

/// A row for every family, and what changed.
pub fn each_family(made: &[Made], rows: &[Row], changes: &[Change]) -> String {
    let mut families: BTreeMap<&str, Vec<&Made>> = BTreeMap::new();
    for kernel in made {
        families.entry(kernel.kernel.split("::").next().unwrap_or_default()).or_default().push(kernel);
    }
    // a family that is gone has no kernels, but changes
    changes.iter().for_each(|change| _ = families.entry(change.family()).or_default());
    let line = |(family, kernels): (&&str, &Vec<&Made>)| {
        let worst = kernels.iter().map(|kernel| worst_of(rows, &kernel.kernel)).fold(0.0, f64::max);
        let bound = kernels.iter().map(|kernel| kernel.bound).fold(0.0, f64::max);
        let changes = changes.iter().filter(|change| change.family() == *family);
        let against = against(changes.map(|change| &change.kind));
        [(*family).to_owned(), kernels.len().to_string(), format!("{worst:.2}"), bound.to_string(), against]
    };
    let header = ["family", "kernels", "worst ulp", "bound", "results, against the ledger"];
    columns::text(header, families.iter().map(line)) + &told(changes)
}

/// How many results became what.
fn against<'a>(kinds: impl Iterator<Item = &'a Kind>) -> String {
    let mut counts: [(usize, &str); 4] = [(0, "better"), (0, "worse"), (0, "new"), (0, "gone")];
    for kind in kinds {
        let position = match kind {
            Kind::Better(_) => 0,
            Kind::Worse(_) => 1,
            Kind::New => 2,
            Kind::Gone => 3,
        };
        counts[position].0 += 1;
    }
    let present: Vec<String> =
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    if present.is_empty() { "as before".to_owned() } else { present.join(", ") }
}

/// A line for every result that got worse or better, the worse ones first.
fn told(changes: &[Change]) -> String {
    let (mut worse, mut better) = (Vec::new(), Vec::new());
    for change in changes {
        match change.kind {
            Kind::Worse(_) => worse.push(format!("worse   {change}\n")),
            Kind::Better(_) => better.push(format!("better  {change}\n")),
            Kind::New | Kind::Gone => {}
        }
    }
    let lines: Vec<String> = worse.into_iter().chain(better).collect();
    let more = match lines.len().saturating_sub(TOLD) {
        0 => String::new(),
        more => format!("and {more} more: the difference of the ledger shows all\n"),
    };
    lines.into_iter().take(TOLD).collect::<String>() + &more
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::ledger::change::Step;

    fn change(kernel: &str, result: &str, kind: Kind) -> Change {
        Change { kernel: kernel.to_owned(), result: result.to_owned(), kind }
    }

    fn step(was: &str, is: &str) -> Vec<Step> {
        vec![Step { what: "bound", was: was.to_owned(), is: is.to_owned() }]
    }

    fn made(kernel: &str) -> Made {
        Made {
            kernel: kernel.to_owned(),
            rules: Vec::new(),
            operations: [0; 5],
            bound: 2.5,
            certified_because: None,
            added: Vec::new(),
        }
    }

    #[test]
    fn a_family_has_one_line_and_changes_are_told() {
        let changes = [
            change("line::root", "root", Kind::Better(step("3", "2"))),
            change("line::slope", "slope", Kind::Worse(step("2", "3"))),
            change("old::gone", "gone", Kind::Gone),
        ];
        let text = each_family(&[made("line::root"), made("line::slope"), made("plane::slope")], &[], &changes);
        assert_eq!(
            text,
            "family  kernels  worst ulp  bound  results, against the ledger\n\
             line    2        0.00       2.5    1 better, 1 worse\n\
             old     0        0.00       0      1 gone\n\
             plane   1        0.00       2.5    as before\n\
             worse   line::slope: bound 2 -> 3\n\
             better  line::root: bound 3 -> 2\n"
        );
    }

    #[test]
    fn many_changes_are_cut() {
        let many: Vec<Change> =
            (0..25).map(|at| change(&format!("a::k{at}"), "r", Kind::Worse(step("1", "2")))).collect();
        let text = told(&many);
        assert_eq!(text.lines().count(), TOLD + 1);
        assert!(text.ends_with("and 5 more: the difference of the ledger shows all\n"));
    }
}
