//! Tables as JSON: names and units of the columns, then the rows.

use std::io::{Read, Write};

use serde::{Deserialize, Serialize};

use super::columns::{self, Rows, columns, title};
use super::numbers::{decimal, quote_numbers};
use super::{Heading, Row, Table, TableError};

/// The title of a column, in parts.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Column {
    name: String,
    unit: String,
}

/// A table whose numbers are text.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    columns: Vec<Column>,
    rows: Vec<Vec<String>>,
}

/// Writes a table as JSON, row by row as the knots come; how many rows.
///
/// `{"columns": [{"name": "time", "unit": "s"}, ..], "rows": [[0.0, ..], ..]}`
pub fn write_json<R: Into<Row>>(
    mut out: impl Write,
    heading: &Heading,
    knots: impl IntoIterator<Item = R>,
) -> Result<u64, TableError> {
    columns::check(heading)?;
    let column = |(name, unit): (String, &str)| Column { name, unit: unit.to_owned() };
    let titles: Vec<Column> = columns(heading).into_iter().map(column).collect();
    write!(out, "{{\"columns\":{},\n\"rows\":[", serde_json::to_string(&titles)?)?;
    let mut rows = Rows::new(heading);
    for knot in knots {
        let comma = if rows.count() == 0 { "" } else { "," };
        let numbers: Vec<String> = rows.numbers(&knot.into())?.into_iter().map(decimal).collect();
        write!(out, "{comma}\n[{}]", numbers.join(","))?;
    }
    out.write_all(b"\n]}\n")?;
    out.flush()?;
    Ok(rows.count())
}

/// Reads a table that [`write_json`] wrote.
pub fn read_json(mut input: impl Read) -> Result<Table, TableError> {
    let mut text = String::new();
    input.read_to_string(&mut text)?;
    let document: Document = serde_json::from_str(&quote_numbers(&text))?;
    let titles: Vec<String> = document.columns.into_iter().map(|column| title(&(column.name, &column.unit))).collect();
    let heading = columns::heading(titles.iter().map(String::as_str))?;
    let mut rows = Vec::with_capacity(document.rows.len());
    let mut numbers = Rows::new(&heading);
    for fields in &document.rows {
        rows.push(numbers.knot(fields.iter().map(String::as_str))?);
    }
    columns::set_accelerations(&mut rows);
    Ok(Table { heading, rows })
}
