//! The worksheet errors, sorted by how wrong the number is.

use std::cmp::Ordering;
use std::fmt::Write as _;

use closedform_maxima::ExprKind;

use super::JudgedSheet;
use super::text::{example, formula_in_list, number, printed, prose, value};
use crate::contrast::Contrast;
use crate::formula::Formula;
use crate::judge::{Judged, Verdict};
use crate::sheet::{Row, Sheet};

const HEAD: &str = "
## The worst errors first

The cells whose formula is not true, sorted by how wrong the number is that they give: first where there is no such
number, or the cell has none; then those of the wrong sign; then by the relative difference from the right one, which is
infinite where that is 0. Where something made of the forms is compared, `live` is what the cell gives and `right` the
right form. Long formulas are cut; the file named beside the cell has them in full.
";

/// The section.
pub(super) fn section(sheets: &[JudgedSheet]) -> String {
    let rows = sheets.iter().flat_map(|(sheet, judged)| {
        let rows = sheet.rows.iter().zip(judged).filter(|(row, _)| row.verdict == Verdict::WorksheetError);
        rows.filter_map(move |(row, judged)| Some((*sheet, row, judged, judged.contrast.as_ref()?)))
    });
    let mut errors: Vec<_> = rows.collect();
    errors.sort_by(|(.., one, wrong), (.., other, too)| exists(one, other).then(wrong.compare_badness(too)));
    let mut section = HEAD.to_owned();
    for (rank, (sheet, row, _, contrast)) in errors.into_iter().enumerate() {
        section += &entry(rank + 1, sheet, row, contrast);
    }
    section
}

/// Those whose right form is an empty list come first: there is no such number.
fn exists(one: &Judged, other: &Judged) -> Ordering {
    one.values.is_empty().cmp(&other.values.is_empty()).reverse()
}

fn entry(rank: usize, sheet: &Sheet, row: &Row, contrast: &Contrast) -> String {
    let mut text = format!("\n### {rank}. {} ([{1}](errata/{1}.toml))\n", prose(&row.cell), sheet.name);
    let _ = write!(text, "\n{}\n\n", prose(row.error.as_deref().unwrap_or_default()));
    let mut point = |what: &str, formula: Option<String>| {
        if let Some(formula) = formula {
            let _ = writeln!(text, "- {what}: {formula}");
        }
    };
    point("printed", printed(row));
    let reads = if row.printed.is_some() { "to be read as" } else { "not shown, but" };
    point(reads, row.reads.as_ref().map(|form| formula_in_list(&form.text())));
    point("right", row.right.as_ref().map(right));
    if let Some([wrong, right]) = &row.shows {
        let (wrong, right) = (formula_in_list(&wrong.text()), formula_in_list(&right.text()));
        point("compared", Some(format!("{wrong} with {right}")));
    }
    point("at", row.example.as_ref().map(|at| format!("{}: {}", example(at), numbers(contrast))));
    text
}

fn right(form: &Formula) -> String {
    match &form.expression.kind {
        ExprKind::List(elements) if elements.is_empty() => "there is none".to_owned(),
        _ => formula_in_list(&form.text()),
    }
}

fn numbers(contrast: &Contrast) -> String {
    match contrast {
        Contrast::Entries { wrong, right } => format!("{wrong} entries, right {right}"),
        Contrast::Values { entry: (entry, of), wrong, right } => {
            let place = if *of > 1 { format!("entry {entry} of {of}: ") } else { String::new() };
            let relative = contrast.relative().filter(|relative| relative.is_finite());
            let relative = relative.map(|relative| format!(" (off by {} %)", number(rounded(100.0 * relative))));
            format!("{place}**{}**, right **{}**{}", value(wrong), value(right), relative.unwrap_or_default())
        }
    }
}

/// Three digits say how wrong a number is.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
