//! A kernel is the true form that the rows of the errata say it ships.

use std::sync::LazyLock;

use closedform::Info;
use closedform_tests::check::Judge;
use closedform_tests::claim::Case;
use closedform_tests::errata::{self, Claim, Row};
use closedform_tests::harness::Said;
use closedform_tests::random::seed;

/// Points of each maker, for each claim.
const POINTS: usize = 60;

/// Points that must remain of these where arguments are constants, or the true form has gaps.
const ENOUGH: usize = 150;

/// The rows of all families.
static ROWS: LazyLock<Vec<(String, Row)>> = LazyLock::new(errata::rows);

/// The claims on the results of a kernel.
fn claims(info: &Info) -> impl Iterator<Item = (&'static str, &'static Row, &'static Claim)> {
    let all = ROWS.iter().flat_map(|(family, row)| row.claims.iter().map(move |claim| (family.as_str(), row, claim)));
    all.filter(|(_, _, claim)| info.results.iter().any(|result| result.worksheet == claim.function))
}

/// Whether a row is about the kernel.
pub fn concerns(info: &Info) -> bool {
    claims(info).next().is_some()
}

/// At points of the kernel, every true form has its value within its bound.
pub fn answer(judge: &Judge) -> Said {
    let mut complaints = Vec::new();
    for (family, row, claim) in claims(judge.kernel.info) {
        let broken = match Case::new(row, claim).and_then(|case| case.check(seed(), POINTS)) {
            Ok(judged) if judged >= ENOUGH => continue,
            Ok(judged) => format!("only {judged} points judged"),
            Err(error) => error,
        };
        complaints.push(format!("{family}, {}, `{}`: {broken}", row.cell, claim.function));
    }
    if complaints.is_empty() { Ok(String::new()) } else { Err(complaints.join("\n")) }
}
