//! Texts in Markdown: sentences, formulas, numbers.

use closedform_maxima::print;

use crate::facts::Value;
use crate::sheet::{Example, Row};

/// Longer formulas are cut in tables.
const LONGEST: usize = 120;

/// Longer formulas are cut in lists, where there is more room.
const LONGEST_IN_LIST: usize = 480;

/// Digits of a number.
const DIGITS: usize = 12;

/// A sentence: on one line, nothing in it taken for a mark, but its formulas in backticks.
pub(super) fn prose(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let spans = line.split('`').enumerate().map(|(position, part)| match position % 2 {
        0 => part.replace('*', "\\*").replace('<', "\\<").replace('|', "\\|"),
        _ => part.replace('|', "\\|"),
    });
    spans.collect::<Vec<_>>().join("`")
}

/// A formula in a table.
pub(super) fn formula(text: &str) -> String {
    cut(text, LONGEST)
}

/// A formula in a list.
pub(super) fn formula_in_list(text: &str) -> String {
    cut(text, LONGEST_IN_LIST)
}

fn cut(text: &str, longest: usize) -> String {
    let text = text.replace('|', "\\|").replace('`', "'");
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("`{} ..`", &text[..end]),
        None => format!("`{text}`"),
    }
}

/// What the derivation prints, as a formula where it is one.
pub(super) fn printed(row: &Row) -> Option<String> {
    row.printed
        .as_ref()
        .map(|printed| formula_in_list(&printed.form.as_ref().map_or_else(|_| printed.text.clone(), print)))
}

/// The symbols of an example with their numbers.
pub(super) fn example(example: &Example) -> String {
    let equations = example.numbers.iter().map(|(symbol, number)| format!("{symbol} = {}", print(number)));
    format!("`{}`", equations.collect::<Vec<_>>().join(", "))
}

/// The value of an entry.
pub(super) fn value(value: &Value) -> String {
    match value {
        Value::Number(value) => number(*value),
        Value::NotReal => "no real number".to_owned(),
        Value::Nothing => "no number: a division by 0".to_owned(),
        Value::Symbols(left) => formula(left),
        Value::Unstable => "no settled digits".to_owned(),
    }
}

/// A number with its significant digits, zeros at the end left out.
pub(super) fn number(value: f64) -> String {
    let scientific = format!("{value:.*e}", DIGITS - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    if (-4..DIGITS as i32).contains(&exponent) {
        let decimals = (DIGITS as i32 - 1 - exponent).max(0) as usize;
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    format!("{}e{exponent}", trimmed(mantissa))
}

fn trimmed(decimal: &str) -> &str {
    if decimal.contains('.') { decimal.trim_end_matches('0').trim_end_matches('.') } else { decimal }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_twelve_digits() {
        let cases = [
            (1.0 / 3.0, "0.333333333333"),
            (-2.0, "-2"),
            (0.0, "0"),
            (1e-7 / 3.0, "3.33333333333e-8"),
            (123_456_789_012.0, "123456789012"),
            (2e12, "2e12"),
            (0.000_5, "0.0005"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn sentences_keep_their_formulas() {
        assert_eq!(prose("2*a <\n b|c: `2*a | b`"), "2\\*a \\< b\\|c: `2*a \\| b`");
        assert_eq!(formula(&"x".repeat(121)), format!("`{} ..`", "x".repeat(120)));
    }
}
