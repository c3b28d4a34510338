//! Points from text and from files.

use std::io::Read;
use std::path::Path;

use crate::error::{Failure, Outcome};
use crate::output::note;
use crate::standard::is_standard;

/// A point from `X`, `X,Y`, `X,Y,Z` and so on.
pub fn point(text: &str) -> Result<Vec<f64>, String> {
    fields(text).into_iter().map(number).collect()
}

/// The points of a file, one a line; `-` for standard input.
///
/// A mark of the order of bytes, empty lines and those that begin with `#` are passed over. A first line of names is too,
/// and that is said: each of its fields begins like a word.
pub fn read(path: &Path) -> Outcome<Vec<Vec<f64>>> {
    let text = if is_standard(path) {
        let mut text = String::new();
        std::io::stdin().read_to_string(&mut text).map(|_| text)
    } else {
        std::fs::read_to_string(path)
    };
    let text = text.map_err(|error| Failure(format!("{error}: give a file of text that can be read")))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let has_points = |(_, line): &(usize, &str)| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let mut lines = (1..).zip(text.lines()).filter(has_points).peekable();
    if let Some((number, _)) = lines.next_if(|(_, line)| fields(line).into_iter().all(is_name)) {
        note(&format!("{}: passed over: line {number}: names of columns", path.display()));
    }
    let parse = |(number, line)| point(line).map_err(|error| Failure(format!("line {number}: {error}")));
    lines.map(parse).collect()
}

/// What is between semicolons, else between commas, else between blanks; what ends with one of them has nothing after it.
fn fields(line: &str) -> Vec<&str> {
    let line = line.trim();
    let separated = |by: char| -> Vec<&str> {
        line.strip_suffix(by).unwrap_or(line).split(by).map(|field| unquoted(field.trim())).collect()
    };
    match () {
        () if line.contains(';') => separated(';'),
        () if line.contains(',') => separated(','),
        () => line.split_whitespace().map(unquoted).collect(),
    }
}

fn unquoted(field: &str) -> &str {
    field.strip_prefix('"').and_then(|inner| inner.strip_suffix('"')).map_or(field, str::trim)
}

fn number(field: &str) -> Result<f64, String> {
    let remedy = match field.contains(',') {
        true => "write decimals with a point",
        false => "write a point as X,Y",
    };
    field.parse().map_err(|_| format!("`{}` is not a number: {remedy}", field.escape_debug()))
}

/// Whether a field is a word, and no number with a mistake in it.
fn is_name(field: &str) -> bool {
    field.starts_with(char::is_alphabetic) && field.parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_separated_as_people_do() {
        for text in ["1,-2e-1", "1;-0.2", "1\t-0.2", " 1  -0.2 ", "1,-0.2,", "\"1\", \"-0.2\"", "1 ; -0.2;"] {
            assert_eq!(point(text), Ok(vec![1.0, -0.2]), "{text}");
        }
        assert_eq!(point("5"), Ok(vec![5.0]));
        assert!(point("1,5;2").expect_err("a comma").contains("decimals with a point"));
        assert!(point("1,,2").is_err() && point("1,2x").is_err() && point("0.0.0,1").is_err());
    }

    #[test]
    fn words_are_names_and_numbers_with_mistakes_are_not() {
        assert!(["x", "X [m]", "time_s"].into_iter().all(is_name));
        assert!(!["1", "0.0.0", "-x", "nan", "inf", "", "1e"].into_iter().any(is_name));
    }
}
