//! Golden values, `NAME.tsv`: numbers that Maxima computed, with the exact inputs it computed them for.

use std::path::Path;

use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::hexfloat::{self, HexFloatError};
use super::source::{self, ReadError, Text};

/// One golden value.
#[derive(Debug, Clone, PartialEq)]
pub struct GoldenValue {
    /// The Maxima function.
    pub worksheet: String,
    /// Maxima names and values of its arguments, in order.
    pub inputs: Vec<(String, f64)>,
    /// The value in decimal, 40 digits of it correct.
    pub value: String,
}

/// Why there are no golden values.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum GoldenError {
    /// The file cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Read(#[from] ReadError),
    /// A line is no golden value.
    #[error("{cause}")]
    #[diagnostic(help("run `closedform derive`, which writes this file; it is not edited by hand"))]
    Line {
        /// What is wrong with it.
        cause: LineError,
        /// The file.
        #[source_code]
        text: Text,
        /// The line.
        #[label("here")]
        place: SourceSpan,
    },
}

/// What can be wrong with a line.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LineError {
    /// Not three columns.
    #[error("a golden value has three columns, separated by tabs: function, inputs, value")]
    Columns,
    /// No `name=value`.
    #[error("`{0}` is not an input of the form name=0x1.8p-3")]
    Input(String),
    /// No such number.
    #[error(transparent)]
    Number(#[from] HexFloatError),
    /// The value is no decimal number.
    #[error("`{0}` is not a decimal number")]
    Value(String),
}

/// Reads the golden values of a file.
pub fn load(path: &Path) -> Result<Vec<GoldenValue>, GoldenError> {
    let text = source::read(path, "run `closedform derive`, which writes this file")?;
    parse(path, &text)
}

/// Reads golden values from text; `path` names it in errors.
pub fn parse(path: &Path, text: &str) -> Result<Vec<GoldenValue>, GoldenError> {
    let mut values = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r']);
        if !content.is_empty() && !content.starts_with('#') {
            let place = (start, content.len()).into();
            let value = parse_line(content);
            values.push(value.map_err(|cause| GoldenError::Line { cause, text: source::named(path, text), place })?);
        }
        start += line.len();
    }
    Ok(values)
}

/// One line a value, each ended.
pub fn print(values: &[GoldenValue]) -> String {
    values.iter().map(print_line).collect()
}

fn print_line(value: &GoldenValue) -> String {
    let inputs: Vec<String> =
        value.inputs.iter().map(|(name, value)| format!("{name}={}", hexfloat::print(*value))).collect();
    format!("{}\t{}\t{}\n", value.worksheet, inputs.join(" "), value.value)
}

fn parse_line(line: &str) -> Result<GoldenValue, LineError> {
    let columns: Vec<&str> = line.split('\t').collect();
    let [worksheet, inputs, value] = columns[..] else { return Err(LineError::Columns) };
    if value.parse::<f64>().is_err() || value.contains(|c: char| c.is_alphabetic() && c != 'e') {
        return Err(LineError::Value(value.to_owned()));
    }
    Ok(GoldenValue {
        worksheet: worksheet.to_owned(),
        inputs: inputs.split(' ').map(parse_input).collect::<Result<_, _>>()?,
        value: value.to_owned(),
    })
}

fn parse_input(text: &str) -> Result<(String, f64), LineError> {
    let (name, value) = text.split_once('=').ok_or_else(|| LineError::Input(text.to_owned()))?;
    Ok((name.to_owned(), hexfloat::parse(value)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# written by closedform\n\ntIn\ttOut=0x1.8p-3 a2Max=-0x1p+0\t1.5e-2\nv\ta=0x0p+0\t0\n";

    #[test]
    fn values_come_back() {
        let values = parse(Path::new("t.tsv"), TEXT).unwrap();
        assert_eq!(values.len(), 2);
        assert_eq!(values[0].inputs, [("tOut".to_owned(), 0.1875), ("a2Max".to_owned(), -1.0)]);
        assert_eq!(print(&values), TEXT.split_once("\n\n").unwrap().1);
    }

    #[test]
    fn bad_lines_are_pointed_at() {
        let cause = |line: &str| match parse(Path::new("t.tsv"), &format!("# é\n{line}\n")) {
            Err(GoldenError::Line { cause, place, .. }) => (cause, place.offset(), place.len()),
            other => panic!("{other:?}"),
        };
        assert_eq!(cause("tIn"), (LineError::Columns, 5, 3));
        assert_eq!(cause("t\ta\t1").0, LineError::Input("a".to_owned()));
        assert_eq!(cause("t\ta=1.5\t1").0, LineError::Number(HexFloatError::Malformed("1.5".to_owned())));
        assert_eq!(cause("t\ta=0x1p0\tone").0, LineError::Value("one".to_owned()));
    }
}
