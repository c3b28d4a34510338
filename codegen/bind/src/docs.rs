//! The documentation of a kernel, as paragraphs that every language prints in its own comments.

use crate::library::{Bound, Quantity};
use closedform_project::markdown::one_line;

/// Paragraphs: what it is, its formula, inputs, domain, results with their bounds, and where it comes from.
pub fn paragraphs(kernel: &Bound) -> Vec<Vec<String>> {
    let meta = &kernel.kernel.meta;
    let formula = meta.maxima.iter().flat_map(|formula| formula.lines()).map(one_line).collect();
    let mut paragraphs = vec![vec![one_line(&meta.summary)], formula];
    paragraphs.push(kernel.inputs.iter().map(|input| format!("input {}", quantity(input))).collect());
    paragraphs.push(domain(kernel));
    paragraphs.push(kernel.results.iter().map(result).collect());
    paragraphs.extend(meta.source.iter().map(|source| vec![format!("From: {}.", one_line(source))]));
    paragraphs.retain(|paragraph| paragraph.iter().any(|line| !line.is_empty()));
    paragraphs
}

fn domain(kernel: &Bound) -> Vec<String> {
    if kernel.domain.is_empty() {
        return vec!["Domain: all finite inputs.".to_owned()];
    }
    let conditions = kernel.domain.iter().map(|condition| format!("  {}", one_line(condition)));
    ["Domain: all inputs are finite, and".to_owned()].into_iter().chain(conditions).collect()
}

fn result(result: &Quantity) -> String {
    let bound = match result.bound {
        Some(bound) => format!("off by {bound} ulp at most, barring overflow and underflow of the result"),
        None => "no bound of its error is proved".to_owned(),
    };
    format!("result {}: {bound}", quantity(result))
}

/// Name, name in the worksheet where that is another one, and unit.
fn quantity(quantity: &Quantity) -> String {
    let worksheet = match quantity.worksheet.as_str() {
        worksheet if worksheet.is_empty() || worksheet == quantity.name => String::new(),
        worksheet => format!(" ({})", one_line(worksheet)),
    };
    let unit = quantity.unit().map_or_else(String::new, |unit| format!(", in {}", one_line(unit)));
    format!("{}{worksheet}{unit}", quantity.name)
}
