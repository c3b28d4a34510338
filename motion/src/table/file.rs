//! Tables as files, CSV or JSON by their ending.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::{Heading, Row, Table, TableError, read_csv, read_json, write_csv, write_json};
use crate::file::write_whole;

/// By the ending of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Csv,
    Json,
}

/// What a file of this name holds.
pub(super) fn format(path: &Path) -> Result<Format, TableError> {
    match path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("csv") => Ok(Format::Csv),
        Some("json") => Ok(Format::Json),
        _ => Err(TableError::Format { path: path.display().to_string() }),
    }
}

/// Writes a table into a file that ends in `.csv` or `.json`, whole or not at all; how many rows.
pub fn save<R: Into<Row>>(
    path: &Path,
    heading: &Heading,
    knots: impl IntoIterator<Item = R>,
) -> Result<u64, TableError> {
    match format(path)? {
        Format::Csv => write_whole(path, |out| write_csv(out, heading, knots)),
        Format::Json => write_whole(path, |out| write_json(out, heading, knots)),
    }
}

/// Reads a table from a file that ends in `.csv` or `.json`.
pub fn load(path: &Path) -> Result<Table, TableError> {
    let format = format(path)?;
    let input = BufReader::new(File::open(path)?);
    match format {
        Format::Csv => read_csv(input),
        Format::Json => read_json(input),
    }
}
