//! Documentation: what a kernel computes, of what, where, and how well, as lines of Markdown.

use super::formula::broken;
use super::kernel_text::{InputDoc, KernelText, ResultText};
use closedform_project::markdown::{code, plain};
use closedform_syntax::Precision;
use std::fmt::Write as _;

/// How far a line of documentation may go, where it can be broken.
const WIDTH: usize = 110;

/// `in m/s`; nothing of a number.
pub fn in_unit(unit: &str) -> Option<String> {
    (unit != "1").then(|| format!("in {}", plain(unit)))
}

/// A text that somebody wrote, as one sentence of a documentation.
pub fn sentence(text: &str) -> String {
    format!("{}.", plain(text.trim().trim_end_matches('.')))
}

/// The documentation of a kernel: paragraphs with an empty line between.
#[must_use]
pub fn docs(kernel: &KernelText) -> Vec<String> {
    let doc = if kernel.doc.trim().is_empty() { code(&kernel.name) } else { plain(&kernel.doc) };
    let mut paragraphs: Vec<Vec<String>> = vec![wrapped(&doc, "")];
    let formulas = kernel.maxima.iter().flat_map(|formula| broken(formula, WIDTH));
    paragraphs.push(["```text".to_owned()].into_iter().chain(formulas).chain(["```".to_owned()]).collect());
    paragraphs.extend(kernel.branch.iter().map(|branch| wrapped(&format!("Branch: {}", sentence(branch)), "")));
    paragraphs.push(vec!["# Inputs".to_owned()]);
    paragraphs.push(items(kernel.inputs.iter().map(input_line)));
    paragraphs.push(vec!["# Domain".to_owned()]);
    paragraphs.extend(domain(kernel));
    paragraphs.extend(kernel.edges.iter().map(|edges| wrapped(&format!("At the edges: {}", sentence(edges)), "")));
    paragraphs.push(vec!["# Error".to_owned()]);
    paragraphs.push(items(kernel.results.iter().map(|result| bound_line(kernel, result))));
    if !kernel.source.trim().is_empty() {
        paragraphs.push(wrapped(&format!("From: {}", sentence(&kernel.source)), ""));
    }
    paragraphs.join(&String::new())
}

/// An input with what is known of it; its name in the worksheet where that is another one.
fn input_line(input: &InputDoc) -> String {
    let mut line = format!("- {}", code(&input.name));
    if input.maxima != input.name {
        let _ = write!(line, " ({})", code(&input.maxima));
    }
    if let Some(unit) = in_unit(&input.unit) {
        let _ = write!(line, ", {unit}");
    }
    if !input.doc.trim().is_empty() {
        let _ = write!(line, ": {}", plain(&input.doc));
    }
    line
}

fn bound_line(kernel: &KernelText, result: &ResultText) -> String {
    let what = if kernel.results.len() == 1 { String::new() } else { format!("{}: ", code(&result.name)) };
    let enforced = match kernel.precision {
        Precision::Double | Precision::DoubleDouble => "",
        Precision::Certified => "; every call sees to it, and gives NaN where 4,096 bits do not decide",
    };
    format!("- {what}at most {} ulp, barring overflow and underflow of the result{enforced}", result.bound)
}

/// Conditions, in the names of Rust and, where those are others, in those of the worksheet too.
fn domain(kernel: &KernelText) -> Vec<Vec<String>> {
    if kernel.requires.is_empty() {
        return vec![vec!["All finite inputs.".to_owned()]];
    }
    let conditions = kernel.requires.iter().map(|require| (in_rust(&require.text, &kernel.inputs), &require.text));
    let both = conditions.clone().any(|(rust, worksheet)| rust != *worksheet);
    let names = if both { ", in the names of Rust (and of the worksheet)" } else { "" };
    let line = |(rust, worksheet): (String, &String)| match rust == *worksheet {
        true => format!("- {}", code(worksheet)),
        false => format!("- {} ({})", code(&rust), code(worksheet)),
    };
    vec![vec![format!("All inputs are finite; NaN outside of{names}:")], items(conditions.map(line))]
}

/// A text of the worksheet with the Rust names of its inputs.
fn in_rust(text: &str, inputs: &[InputDoc]) -> String {
    let is_name = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '%' | '\\');
    let (mut renamed, mut rest) = (String::new(), text);
    while let Some(first) = rest.chars().next() {
        let length = match is_name(first) {
            true => rest.find(|letter| !is_name(letter)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (word, after) = rest.split_at(length);
        let input = inputs.iter().find(|input| input.maxima == word);
        renamed.push_str(input.map_or(word, |input| &input.name));
        rest = after;
    }
    renamed
}

/// The items of a list, each in lines of their own.
fn items(lines: impl Iterator<Item = String>) -> Vec<String> {
    lines.flat_map(|line| wrapped(&line, "  ")).collect()
}

/// A paragraph in lines; all but the first begin with `indent`. No line begins with what would be the mark of a list, a heading or a
/// table there.
#[must_use]
pub fn wrapped(paragraph: &str, indent: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in paragraph.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < WIDTH || begins_a_block(word) => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) => lines.push(format!("{indent}{word}")),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

fn begins_a_block(word: &str) -> bool {
    word.is_empty() || word.starts_with(|first: char| "-+*>#=`~|<:_".contains(first) || first.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_long_that_could_be_broken_and_none_begins_a_block() {
        let paragraph = format!("{} - 1. > # x", ["word"; 60].join(" "));
        let lines = wrapped(&paragraph, "  ");
        assert!(lines.len() > 2 && lines.iter().all(|line| line.chars().count() <= WIDTH + 10), "{lines:?}");
        assert!(lines.iter().skip(1).all(|line| line.starts_with("  ") && !begins_a_block(line.trim())));
        assert_eq!(lines.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" "), paragraph);
    }

    #[test]
    fn a_condition_has_both_names() {
        let input = |name: &str, maxima: &str| InputDoc {
            name: name.to_owned(),
            maxima: maxima.to_owned(),
            unit: String::new(),
            doc: String::new(),
            typical: [1.0, 2.0],
        };
        let inputs = [input("a_max", "aMax"), input("t", "t")];
        assert_eq!(in_rust("3*aMax^2 > aMax2*t and %pi > t", &inputs), "3*a_max^2 > aMax2*t and %pi > t");
    }
}
