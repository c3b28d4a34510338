//! The table of one file, and the rows that a written page lists.

use std::fmt::Write as _;

use super::text::{example, prose, value};
use crate::contrast::Contrast;
use crate::judge::Judged;
use crate::sheet::{Row, Sheet};

const HEADER: &str = "| cell | verdict | remark | at the example | kernel |";

/// How many values of a list are told.
const VALUES: usize = 4;

/// The table.
pub(super) fn table(sheet: &Sheet, judged: &[Judged]) -> String {
    let mut table = format!("{HEADER}\n|---|---|---|---|---|\n");
    for (row, judged) in sheet.rows.iter().zip(judged) {
        let (remark, numbers, kernels) = (remark(row), numbers(row, judged), kernels(row));
        let _ = writeln!(table, "| {} | {} | {remark} | {numbers} | {kernels} |", prose(&row.cell), row.verdict);
    }
    table
}

/// Every cell with its verdict that the tables of a page list.
pub fn listed(page: &str) -> Vec<(String, String)> {
    let mut listed = Vec::new();
    let mut inside = false;
    for line in page.lines() {
        inside = line == HEADER || inside && line.starts_with('|');
        let mut columns = line.split(" | ");
        if let (true, Some(cell), Some(verdict)) = (inside, columns.next(), columns.next()) {
            let cell = cell.trim_start_matches("| ").replace('\\', "");
            listed.extend((line != HEADER).then(|| (cell, verdict.to_owned())));
        }
    }
    listed
}

fn remark(row: &Row) -> String {
    let repair = row.repair.as_ref().map(|repair| format!("Read: {}.", prose(repair).trim_end_matches('.')));
    let error = row.error.as_ref().map(|error| prose(error));
    repair.into_iter().chain(error).collect::<Vec<_>>().join(" ")
}

fn numbers(row: &Row, judged: &Judged) -> String {
    let Some(at) = &row.example else { return String::new() };
    let numbers = match &judged.contrast {
        Some(Contrast::Values { wrong, right, .. }) => format!("{} instead of {}", value(wrong), value(right)),
        Some(Contrast::Entries { wrong, right }) => format!("{wrong} entries instead of {right}"),
        None => {
            let more = if judged.values.len() > VALUES { ", .." } else { "" };
            let values: Vec<String> = judged.values.iter().take(VALUES).map(value).collect();
            values.join(", ") + more
        }
    };
    format!("{numbers} at {}", example(at))
}

fn kernels(row: &Row) -> String {
    let mut links: Vec<String> = Vec::new();
    for shipment in &row.kernels {
        let (family, kernel) = (&shipment.family, &shipment.kernel);
        let link = format!("[`{family}::{kernel}`](../kernels/src/generated/{family}.rs)");
        if !links.contains(&link) {
            links.push(link);
        }
    }
    links.join(", ")
}
