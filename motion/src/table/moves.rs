//! The table of a milling job, a row a move, written as the moves are timed.

use std::io::{BufWriter, Write};
use std::path::Path;

use super::TableError;
use super::file::{Format, format};
use super::numbers::decimal;
use crate::file::write_whole;
use crate::plan::milling::{Feed, Path as Way, Row};

/// Names and units of the columns.
const COLUMNS: [(&str, &str); 12] = [
    ("number", ""),
    ("line", ""),
    ("kind", ""),
    ("x", "mm"),
    ("y", "mm"),
    ("z", "mm"),
    ("length", "mm"),
    ("feed", "mm/s"),
    ("peak", "mm/s"),
    ("start", "s"),
    ("time", "s"),
    ("end", "s"),
];

/// Takes moves, and writes each as a row: number, line of the G-code (0 without), kind (`rapid`, `cut` or `arc`), where it
/// ends, its length, the speed asked for and reached, and when it starts, how long it takes and when it ends.
pub struct MoveWriter<'a> {
    out: &'a mut dyn Write,
    format: Format,
    rows: u64,
}

impl MoveWriter<'_> {
    /// Writes a row.
    pub fn push(&mut self, row: &Row) -> Result<(), TableError> {
        let kind = match (row.cut.feed, row.cut.path) {
            (_, Way::Arc(_)) => "arc",
            (Feed::Rapid | Feed::RapidAt(_), Way::Straight) => "rapid",
            (Feed::Speed(_) | Feed::Within(_) | Feed::Unknown, Way::Straight) => "cut",
        };
        let [x, y, z] = row.cut.to;
        let numbers = [x, y, z, row.length, row.feed, row.peak, row.total - row.time, row.time, row.total].map(decimal);
        let (number, line, numbers) = (row.number, row.cut.line, numbers.join(","));
        match self.format {
            Format::Csv => writeln!(self.out, "{number},{line},{kind},{numbers}")?,
            Format::Json => {
                let comma = if self.rows == 0 { "" } else { "," };
                // No limit of the speed: JSON has no infinity.
                let numbers = numbers.replace("inf", "null");
                write!(self.out, "{comma}\n[{number},{line},\"{kind}\",{numbers}]")?;
            }
        }
        self.rows += 1;
        Ok(())
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    fn begin(&mut self) -> Result<(), TableError> {
        match self.format {
            Format::Csv => {
                let titled = |(name, unit): &(&str, &str)| match *unit {
                    "" => (*name).to_owned(),
                    unit => format!("{name} [{unit}]"),
                };
                writeln!(self.out, "{}", COLUMNS.iter().map(titled).collect::<Vec<_>>().join(","))?;
            }
            Format::Json => {
                let column = |(name, unit): &(&str, &str)| serde_json::json!({ "name": name, "unit": unit });
                let columns: Vec<serde_json::Value> = COLUMNS.iter().map(column).collect();
                write!(self.out, "{{\"columns\":{},\n\"rows\":[", serde_json::to_string(&columns)?)?;
            }
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), TableError> {
        match self.format {
            Format::Csv => Ok(()),
            Format::Json => Ok(self.out.write_all(b"\n]}\n")?),
        }
    }
}

/// Writes the moves that `run` pushes into a file that ends in `.csv` or `.json`, whole or, where `run` fails, not at all.
pub fn save_moves<T, E>(path: &Path, run: impl FnOnce(&mut MoveWriter) -> Result<T, E>) -> Result<T, E>
where
    E: From<TableError> + From<std::io::Error>,
{
    let format = format(path)?;
    write_whole(path, |out: &mut BufWriter<_>| {
        let mut writer = MoveWriter { out, format, rows: 0 };
        writer.begin()?;
        let result = run(&mut writer)?;
        writer.end()?;
        Ok(result)
    })
}
