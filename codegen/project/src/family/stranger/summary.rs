//! What was taken of a worksheet, what was put into it, and what was passed over and why, in lines that people read.

use std::collections::BTreeSet;

use super::super::reference::ReferenceMistake;
use super::mistake::WorksheetMistake;
use crate::contract::KernelContract;
use crate::worksheet::{Formula, Reading};

/// The most lines of one kind.
const MOST: usize = 40;

/// What a worksheet came to.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Summary {
    /// A line for each thing worth telling.
    pub lines: Vec<String>,
    /// How many formulas and statements were passed over.
    pub passed_over: usize,
}

impl Summary {
    /// Of a file in which these mistakes are all that is passed over.
    pub(super) fn of_mistakes(text: &str, mistakes: &[WorksheetMistake]) -> Self {
        let place = |mistake: &WorksheetMistake| mistake.span().map_or(1, |span| line_of(text, span.offset()));
        let lines = mistakes.iter().map(|mistake| (place(mistake), mistake.to_string())).collect();
        Self { lines: passed_over(lines), passed_over: mistakes.len() }
    }
}

/// Of a worksheet with this text, of which these kernels are made, and where these mistakes are in others.
pub(super) fn summary(
    text: &str,
    reading: &Reading,
    kernels: &[KernelContract],
    unfit: &[ReferenceMistake],
) -> Summary {
    let line = |at: usize| line_of(text, at);
    let formulas = || reading.formulas.iter();
    let is_taken = |formula: &&Formula| {
        let of_formula =
            |kernel: &KernelContract| kernel.results.iter().any(|result| formula.result(&result.worksheet).is_some());
        kernels.iter().any(of_formula)
    };
    let mut skipped: Vec<(usize, String)> = Vec::new();
    for (name, because) in &reading.refused {
        let cause = because.cause.as_ref().map(|cause| format!(" (line {})", line(cause.start))).unwrap_or_default();
        skipped.push((line(because.span.start), format!("`{name}`: {}{cause}", because.what)));
    }
    for formula in formulas().filter(|formula| !is_taken(formula)) {
        let of_formula =
            |mistake: &&ReferenceMistake| mistake.worksheet().is_some_and(|name| formula.result(name).is_some());
        if let Some(mistake) = unfit.iter().find(of_formula) {
            let place = mistake.span().map_or(formula.span.start, |span| span.offset());
            skipped.push((line(place), mistake.to_string()));
        }
    }
    skipped.extend(reading.passed.iter().map(|(what, span)| (line(span.start), what.clone())));
    skipped.sort();
    let mut lines = Vec::new();
    let inlined: BTreeSet<&str> = reading.inlined.iter().map(String::as_str).collect();
    let put_in: Vec<&str> =
        reading.constants.iter().map(String::as_str).filter(|name| inlined.contains(name)).collect();
    if !put_in.is_empty() {
        lines.push(format!("values put in: {}", listed(&put_in)));
    }
    for (name, span) in reading.replaced.iter().take(MOST) {
        lines.push(format!(
            "line {}: `{name}` is defined again later, and the last definition counts",
            line(span.start)
        ));
    }
    for formula in formulas().filter(is_taken) {
        let free = &formula.inputs[formula.parameters..];
        if formula.parameters > 0 && !free.is_empty() {
            let free: Vec<&str> = free.iter().map(String::as_str).collect();
            lines.push(format!("`{}` takes {} too, which no statement gives a value", formula.name, listed(&free)));
        }
    }
    let count = skipped.len();
    lines.extend(passed_over(skipped));
    Summary { lines, passed_over: count }
}

fn line_of(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

/// A line for each thing that is passed over, up to a limit, after the line of the file in which it stands.
fn passed_over(skipped: Vec<(usize, String)>) -> Vec<String> {
    let count = skipped.len();
    let line = |(line, what): (usize, String)| format!("line {line}: passed over: {what}");
    let mut lines: Vec<String> = skipped.into_iter().take(MOST).map(line).collect();
    if count > MOST {
        lines.push(format!("and {} others are passed over", count - MOST));
    }
    lines
}

fn listed(names: &[&str]) -> String {
    let shown: Vec<String> = names.iter().take(MOST).map(|name| format!("`{name}`")).collect();
    let more = if names.len() > MOST { " and others" } else { "" };
    format!("{}{more}", shown.join(", "))
}
