//! Tables as CSV: a header with names and units, then a line a row.

use std::io::{Read, Write};

use csv::{ReaderBuilder, Writer};

use super::columns::{self, Rows, columns, title};
use super::numbers::decimal;
use super::{Heading, Row, Table, TableError};

/// Writes a table as CSV, row by row as the knots come; how many rows.
pub fn write_csv<R: Into<Row>>(
    out: impl Write,
    heading: &Heading,
    knots: impl IntoIterator<Item = R>,
) -> Result<u64, TableError> {
    columns::check(heading)?;
    let mut writer = Writer::from_writer(out);
    writer.write_record(columns(heading).iter().map(title))?;
    let mut rows = Rows::new(heading);
    for knot in knots {
        writer.write_record(rows.numbers(&knot.into())?.into_iter().map(decimal))?;
    }
    writer.flush()?;
    Ok(rows.count())
}

/// Reads a table that [`write_csv`] wrote.
pub fn read_csv(input: impl Read) -> Result<Table, TableError> {
    let mut reader = ReaderBuilder::new().flexible(true).from_reader(input);
    let heading = columns::heading(reader.headers()?.iter())?;
    let mut rows = Vec::new();
    let mut numbers = Rows::new(&heading);
    for record in reader.records() {
        rows.push(numbers.knot(record?.iter())?);
    }
    columns::set_accelerations(&mut rows);
    Ok(Table { heading, rows })
}
