//! What was taken of a worksheet, what was put into it, and what was passed over and why, in lines that people read.

use std::collections::BTreeSet;

use super::super::reference::ReferenceMistake;
use super::mistake::WorksheetMistake;
use crate::contract::KernelContract;
use crate::expression::UNKNOWN_FUNCTION;
use crate::worksheet::{Formula, Reading};

/// The most lines of one kind.
const MOST: usize = 40;

/// What a worksheet came to.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Summary {
    /// A line for each thing worth telling.
    pub lines: Vec<String>,
    /// The formulas and statements that were passed over, in the order of the text.
    pub passed: Vec<Passed>,
}

/// A formula or statement that was passed over.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Passed {
    /// The line of the file in which it stands.
    pub line: usize,
    /// Why, in words that say what it is.
    pub what: String,
    /// The name that has no formula because of it, if it is a definition.
    pub name: Option<String>,
}

impl Summary {
    /// Of a file in which these mistakes are all that is passed over.
    pub(super) fn of_mistakes(text: &str, mistakes: &[WorksheetMistake]) -> Self {
        let passed = |mistake: &WorksheetMistake| {
            let line = mistake.span().map_or(1, |span| line_of(text, span.offset()));
            Passed { line, what: mistake.to_string(), name: None }
        };
        let passed: Vec<Passed> = mistakes.iter().map(passed).collect();
        Self { lines: lines_of(&passed), passed }
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
    let mut passed: Vec<Passed> = Vec::new();
    for (name, because) in &reading.refused {
        let cause = because.cause.as_ref().map(|cause| format!(" (line {})", line(cause.start))).unwrap_or_default();
        let what = format!("`{name}`: {}{cause}", because.what);
        passed.push(Passed { line: line(because.span.start), what, name: Some(name.clone()) });
    }
    for formula in formulas().filter(|formula| !is_taken(formula)) {
        let of_formula =
            |mistake: &&ReferenceMistake| mistake.worksheet().is_some_and(|name| formula.result(name).is_some());
        let mistakes: Vec<&ReferenceMistake> = unfit.iter().filter(of_formula).collect();
        if let Some(first) = mistakes.first() {
            let place = first.span().map_or(formula.span.start, |span| span.offset());
            let name = Some(formula.name.clone());
            passed.push(Passed { line: line(place), what: all_of(&formula.name, &mistakes), name });
        }
    }
    let statement = |(what, span): &(String, std::ops::Range<usize>)| Passed {
        line: line(span.start),
        what: what.clone(),
        name: None,
    };
    passed.extend(reading.passed.iter().map(statement));
    passed.sort();
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
    lines.extend(lines_of(&passed));
    Summary { lines, passed }
}

/// What is wrong with one formula: every function that it calls in vain, and what else comes first.
fn all_of(formula: &str, mistakes: &[&ReferenceMistake]) -> String {
    let called = |mistake: &&ReferenceMistake| match mistake {
        ReferenceMistake::UnknownFunction { name, .. } => Some(format!("`{name}`")),
        // one inside another
        ReferenceMistake::Unsupported { what, .. } => what.strip_prefix(UNKNOWN_FUNCTION).map(str::to_owned),
        _ => None,
    };
    let mut functions: Vec<String> = mistakes.iter().filter_map(called).collect();
    let mut seen = BTreeSet::new();
    functions.retain(|name| seen.insert(name.clone()));
    let other = mistakes.iter().find(|mistake| called(mistake).is_none());
    let other = other.map(ToString::to_string);
    if functions.is_empty() {
        return other.unwrap_or_default();
    }
    let besides = other.map(|other| format!("; besides, {other}")).unwrap_or_default();
    format!("`{formula}` calls {}, which kernels cannot compute{besides}", functions.join(", "))
}

fn line_of(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

/// A line for each thing that is passed over, up to a limit, after the line of the file in which it stands.
fn lines_of(passed: &[Passed]) -> Vec<String> {
    let line = |Passed { line, what, .. }: &Passed| format!("line {line}: passed over: {what}");
    let mut lines: Vec<String> = passed.iter().take(MOST).map(line).collect();
    if passed.len() > MOST {
        lines.push(format!("and {} others are passed over", passed.len() - MOST));
    }
    lines
}

fn listed(names: &[&str]) -> String {
    let shown: Vec<String> = names.iter().take(MOST).map(|name| format!("`{name}`")).collect();
    let more = if names.len() > MOST { " and others" } else { "" };
    format!("{}{more}", shown.join(", "))
}
