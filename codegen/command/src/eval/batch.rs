//! Many points: a CSV file in, the same rows with their results out.

use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::path::Path;

use csv::StringRecord;
use miette::Diagnostic;
use thiserror::Error;

use super::inputs::{self, InputMistake, InputsError};
use super::{digits, point};
use closedform_measure::accuracy::{self, Reference, ReferenceError, ulp_error};
use closedform_measure::catalogue::Entry;
use closedform_system::output::{self, OutputError};

/// How many unreadable rows are named.
const NAMED: usize = 20;

/// Why a table is not evaluated, or not all of it.
#[derive(Debug, Error, Diagnostic)]
pub enum BatchError {
    /// The file cannot be opened or read.
    #[error("cannot read {file}: {cause}")]
    #[diagnostic(help("name a CSV file, or - for standard input"))]
    Read {
        /// The file.
        file: String,
        /// Why not.
        cause: csv::Error,
    },
    /// The header does not name the inputs.
    #[error("the header of {file} does not fit")]
    Header {
        /// The file.
        file: String,
        /// Why not.
        #[source]
        #[diagnostic_source]
        cause: InputsError,
    },
    /// Some rows are no points.
    #[error("{count} rows of {file} could not be read; all others were evaluated")]
    #[diagnostic(help("correct them; the column `error` marks them too"))]
    Rows {
        /// The file.
        file: String,
        /// How many.
        count: usize,
        /// The first of them.
        #[related]
        rows: Vec<RowError>,
    },
    /// There are no true values to add.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Reference(#[from] ReferenceError),
    /// The results cannot be written.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Output(#[from] OutputError),
}

/// A row that is no point.
#[derive(Debug, Error, Diagnostic)]
#[error("line {line}: {cause}")]
pub struct RowError {
    /// Its line.
    pub line: u64,
    /// Why.
    pub cause: RowMistake,
}

/// What is wrong with a row.
#[derive(Debug, PartialEq, Eq, Error)]
pub enum RowMistake {
    /// Too few or too many columns.
    #[error("{found} columns, where the header has {expected}")]
    Columns {
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// No number.
    #[error(transparent)]
    Value(InputMistake),
    /// No text.
    #[error("it is not UTF-8 text")]
    NotText,
}

/// Evaluates every row of a file (`-`: standard input) and writes standard output.
///
/// # Errors
///
/// When the file cannot be read, its header does not fit, or rows are no points.
pub fn run(entry: &Entry, file: &Path, digits: Option<u32>) -> miette::Result<()> {
    let table = Table { entry, file: file_name(file), truths: truths(entry, digits)? };
    let input: Box<dyn Read> = if file == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(file).map_err(|cause| table.unreadable(cause.into()))?)
    };
    match table.evaluate(input, io::stdout().lock()) {
        Err(BatchError::Output(full)) => Err(full.into()), // which is told as by all commands
        done => Ok(done?),
    }
}

fn file_name(file: &Path) -> String {
    if file == Path::new("-") { "standard input".to_owned() } else { file.display().to_string() }
}

fn truths(entry: &Entry, digits: Option<u32>) -> Result<Option<(Reference, u32)>, ReferenceError> {
    digits.map(|digits| Ok((Reference::of(&entry.kernel)?, digits))).transpose()
}

/// A table of points of a kernel.
struct Table<'a> {
    entry: &'a Entry,
    file: String,
    /// The reference and how many digits of it to add, if any.
    truths: Option<(Reference, u32)>,
}

impl Table<'_> {
    fn evaluate(&self, input: impl Read, output: impl Write) -> Result<(), BatchError> {
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).flexible(true).from_reader(input);
        let mut writer = csv::Writer::from_writer(output);
        let header = reader.headers().map_err(|cause| self.unreadable(cause))?.clone();
        let columns = inputs::columns(self.entry, &header.iter().collect::<Vec<_>>())
            .map_err(|cause| BatchError::Header { file: self.file.clone(), cause })?;
        let mut written = write(&mut writer, header.iter().map(str::to_owned).chain(self.result_names()));
        let (mut count, mut rows) = (0, Vec::new());
        let mut record = StringRecord::new();
        while written.is_ok()
            && let Some(row) = self.next(&mut reader, &mut record)?
        {
            let cells = row.and_then(|()| read_point(self.entry, &record, &columns)).map(|point| self.results(&point));
            let cells = cells.unwrap_or_else(|cause| {
                let cells = self.refused(cause.to_string());
                count += 1;
                if rows.len() < NAMED {
                    rows.push(RowError { line: record.position().map_or(0, csv::Position::line), cause });
                }
                cells
            });
            written = write(&mut writer, padded(&record, header.len()).chain(cells));
        }
        output::unless_closed(written.and_then(|()| writer.flush()))?;
        if count == 0 { Ok(()) } else { Err(BatchError::Rows { file: self.file.clone(), count, rows }) }
    }

    /// Reads the next row; `None` at the end.
    fn next<R: Read>(
        &self,
        reader: &mut csv::Reader<R>,
        record: &mut StringRecord,
    ) -> Result<Option<Result<(), RowMistake>>, BatchError> {
        match reader.read_record(record) {
            Ok(true) => Ok(Some(Ok(()))),
            Ok(false) => Ok(None),
            Err(cause) => match cause.kind() {
                csv::ErrorKind::Utf8 { pos, .. } => {
                    record.clear();
                    record.set_position(pos.clone());
                    Ok(Some(Err(RowMistake::NotText)))
                }
                _ => Err(self.unreadable(cause)),
            },
        }
    }

    fn unreadable(&self, cause: csv::Error) -> BatchError {
        BatchError::Read { file: self.file.clone(), cause }
    }

    /// The columns that are added.
    fn result_names(&self) -> Vec<String> {
        let names: Vec<String> = self.entry.kernel.meta.results.iter().map(|result| result.name.to_string()).collect();
        let truths = names.iter().flat_map(|name| [format!("{name}_exact"), format!("{name}_ulp")]);
        let truths: Vec<String> = if self.truths.is_some() { truths.collect() } else { Vec::new() };
        names.iter().cloned().chain(truths).chain(["error".to_owned()]).collect()
    }

    /// The cells that are added to a point.
    fn results(&self, point: &[f64]) -> Vec<String> {
        let results = match accuracy::results(&self.entry.kernel, point) {
            Ok(results) => results,
            Err(violation) => {
                let condition = point::violated_text(self.entry, violation);
                return self.refused(format!("outside the domain: {condition} does not hold"));
            }
        };
        let (truths, error) = self.truth_cells(point, &results);
        let results = results.iter().map(|value| format!("{value:?}"));
        results.chain(truths).chain([error]).collect()
    }

    /// The true values and errors, and why there are none.
    fn truth_cells(&self, point: &[f64], results: &[f64]) -> (Vec<String>, String) {
        let Some((reference, digits)) = &self.truths else { return (Vec::new(), String::new()) };
        match reference.values(point, digits::bits(*digits)) {
            Ok(truths) => {
                let cells = results.iter().zip(&truths).flat_map(|(value, truth)| {
                    [digits::decimal(truth, *digits), format!("{:?}", ulp_error(*value, truth))]
                });
                (cells.collect(), String::new())
            }
            Err(error) => (vec![String::new(); 2 * results.len()], format!("{error}: {}", error.cause)),
        }
    }

    /// The cells that are added where there is no result.
    fn refused(&self, error: String) -> Vec<String> {
        let results = self.entry.kernel.meta.results.len();
        let truths = if self.truths.is_some() { 2 * results } else { 0 };
        let cells = vec!["NaN".to_owned(); results].into_iter().chain(vec![String::new(); truths]);
        cells.chain([error]).collect()
    }
}

fn read_point(entry: &Entry, record: &StringRecord, columns: &[usize]) -> Result<Vec<f64>, RowMistake> {
    let (found, expected) = (record.len(), columns.len());
    if found != expected {
        return Err(RowMistake::Columns { found, expected });
    }
    let inputs = entry.kernel.inputs.iter().zip(columns);
    let values = inputs.map(|(input, column)| {
        let name = input.name.to_string();
        inputs::value(&record[*column]).map_err(|cause| RowMistake::Value(InputMistake::Value { name, cause }))
    });
    values.collect()
}

/// The cells of a row, as many as the header has.
fn padded(record: &StringRecord, columns: usize) -> impl Iterator<Item = String> {
    record.iter().chain(std::iter::repeat("")).take(columns).map(str::to_owned)
}

fn write<W: Write>(writer: &mut csv::Writer<W>, cells: impl Iterator<Item = String>) -> io::Result<()> {
    writer.write_record(cells).map_err(|error| match error.into_kind() {
        csv::ErrorKind::Io(cause) => cause,
        other => io::Error::new(ErrorKind::InvalidData, format!("{other:?}")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;

    fn evaluated(kernel: &str, input: &[u8], digits: Option<u32>) -> (String, Result<(), BatchError>) {
        let (_folder, catalogue) = fixture::catalogue();
        let entry = catalogue.find(kernel).unwrap();
        let table = Table { entry, file: "points.csv".to_owned(), truths: truths(entry, digits).unwrap() };
        let mut output = Vec::new();
        let done = table.evaluate(input, &mut output);
        (String::from_utf8(output).unwrap(), done)
    }

    #[test]
    fn rows_keep_their_cells_and_order() {
        let (output, done) = evaluated("line::root", b"b, aMax\n4,0\n0x1p2,-1\n", None);
        let condition = "outside the domain: `aMax >= 0` does not hold";
        assert_eq!(output, format!("b,aMax,root,error\n4,0,2.0,\n0x1p2,-1,NaN,{condition}\n"));
        assert!(done.is_ok());
    }

    #[test]
    fn true_values_can_be_added() {
        let (output, done) = evaluated("plane::slope", b"x\n3\n", Some(5));
        assert_eq!(output, "x,c,d,c_exact,c_ulp,d_exact,d_ulp,error\n3,6.0,1.0,6.0000,0.0,1.0000,0.0,\n");
        assert!(done.is_ok());
    }

    #[test]
    fn unreadable_rows_are_named_and_passed_over() {
        let (output, done) = evaluated("line::root", b"a_max,b\n0,x\n0,4\n1\n\xff,1\n0,1\n", None);
        assert_eq!(output.lines().count(), 6);
        assert!(output.ends_with("0,1,1.0,\n"), "{output}");
        let Err(BatchError::Rows { count, rows, .. }) = done else { panic!("rows") };
        let messages: Vec<String> = rows.iter().map(ToString::to_string).collect();
        assert_eq!(count, 3);
        assert_eq!(
            messages,
            [
                "line 2: the input `b`: `x` is not a number",
                "line 4: 1 columns, where the header has 2",
                "line 5: it is not UTF-8 text",
            ]
        );
    }

    #[test]
    fn the_header_must_name_the_inputs() {
        for header in ["a_max\n1\n", "", "a_max,b,c\n"] {
            assert!(
                matches!(evaluated("line::root", header.as_bytes(), None).1, Err(BatchError::Header { .. })),
                "{header}"
            );
        }
    }
}
