//! The table of worst errors.

use crate::check::{Judge, Report, Worst};

/// One line for each result: points, worst error, bound.
pub fn render(judges: &[Judge], reports: &[Report]) -> String {
    let head = format!("{:<44} {:>8} {:>9} {:>7}\n", "result", "points", "worst/ulp", "bound");
    let lines = judges.iter().zip(reports).flat_map(|(judge, report)| lines(judge, report));
    head + &lines.collect::<String>()
}

fn lines(judge: &Judge, report: &Report) -> Vec<String> {
    let info = judge.kernel.info;
    let line = |(result, worst): (usize, &Worst)| {
        let name = match info.results.len() {
            1 => info.name.to_owned(),
            _ => format!("{}.{}", info.name, info.results[result].name),
        };
        let (points, bound) = (report.points, judge.bound(result));
        format!("{name:<44} {points:>8} {:>9.3} {bound:>7}\n", worst.ulp)
    };
    report.worst.iter().enumerate().map(line).collect()
}
