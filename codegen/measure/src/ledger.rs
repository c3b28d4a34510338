//! The ledger, `LEDGER.csv` among the records of a project: what each result of a kernel promises, what was measured, what it costs.

pub mod change;
mod cost;

use std::path::{Path, PathBuf};
use std::{fs, io};

use closedform_maxima::{Expr, evaluate_double};
use closedform_syntax::{Operations, Precision, operations, operations_of};
use miette::{Diagnostic, IntoDiagnostic};
use serde::Serialize;
use thiserror::Error;

use crate::accuracy::{Reference, ReferenceError, ValueError, covers, ulp_error, ulp_text, values};
use crate::catalogue::{Catalogue, DomainError, Entry};
use crate::kept::KeptInputs;
use closedform_project::hexfloat;
use closedform_project::kept::KeptError;
use closedform_project::sample::{EmptyDomain, sample};
use closedform_system::scratch;

/// How many points of each domain are measured besides the kept worst inputs.
pub const POINTS: u32 = 200;

/// The ledger's file, among the records.
const FILE: &str = "LEDGER.csv";

/// How every ledger begins; a file that does not is none, and is left alone.
const FIRST_COLUMNS: &str = "kernel,result,";

/// One result of a kernel.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// `family::name`
    pub kernel: String,
    /// The result.
    pub result: String,
    /// The rules of the kernel's program.
    pub rules: String,
    /// Operations that round, compensated expressions and iterations as one each.
    pub roundings: u32,
    /// Divisions among them.
    pub divisions: u32,
    /// Roots of numbers among them.
    pub roots: u32,
    /// Operations in double-double.
    pub double_double: u32,
    /// The error in ulp that is proved never to be exceeded.
    pub bound_ulp: String,
    /// The worst error in ulp at the kept worst inputs and the sample.
    pub worst_ulp: String,
    /// Where.
    pub worst_inputs: String,
    /// The worst error in ulp of the formula as Maxima writes it, at the sample; empty where it has no such form.
    pub as_written_ulp: String,
    /// The cost of the default call.
    pub default_cost: u32,
    /// That of the faithful one.
    pub faithful_cost: u32,
    /// That of the formula as Maxima writes it; empty where it has no such form.
    pub as_written_cost: Option<u32>,
    /// The worst error as a number.
    #[serde(skip)]
    pub worst: f64,
    /// The bound as a number.
    #[serde(skip)]
    pub bound: f64,
    /// The worst error of the formula as Maxima writes it, as a number.
    #[serde(skip)]
    pub as_written: Option<f64>,
}

/// Why there is no ledger.
#[derive(Debug, Error, Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
#[non_exhaustive]
pub enum LedgerError {
    /// A domain cannot be sampled.
    Domain(#[from] DomainError),
    /// A domain has no points.
    Empty(#[from] EmptyDomain),
    /// A kernel has no reference.
    Reference(#[from] ReferenceError),
    /// A reference has no value.
    Value(#[from] ValueError),
    /// The kept inputs cannot be read.
    Kept(#[from] KeptError),
}

/// The rows of all kernels, sorted, measured at `points` points each and at what these records keep.
///
/// # Errors
///
/// When a kernel cannot be measured.
pub fn rows(records: &Path, catalogue: &Catalogue, points: u32) -> Result<Vec<Row>, LedgerError> {
    let kept = KeptInputs::load(records)?;
    let rows = catalogue.entries().iter().map(|entry| rows_of(entry, &kept, points));
    let mut rows = rows.collect::<Result<Vec<_>, _>>()?.concat();
    rows.sort_by(|a, b| (&a.kernel, &a.result).cmp(&(&b.kernel, &b.result)));
    Ok(rows)
}

/// The worst error of all results of a kernel.
pub fn worst_of(rows: &[Row], kernel: &str) -> f64 {
    rows.iter().filter(|row| row.kernel == kernel).map(|row| row.worst).fold(0.0, f64::max)
}

/// The worst error of the formulas of a kernel as Maxima writes them; `None` where one has no such form.
pub fn as_written_of(rows: &[Row], kernel: &str) -> Option<f64> {
    rows.iter().filter(|row| row.kernel == kernel).try_fold(0.0, |worst: f64, row| Some(worst.max(row.as_written?)))
}

/// What all results of a kernel cost, in additions: as Maxima writes them, if it has such a form, by the default call, and
/// by the faithful one.
pub fn costs_of(rows: &[Row], entry: &Entry) -> (Option<u32>, u32, u32) {
    let (name, count) = (entry.full_name(), operations(&entry.kernel));
    let as_written = rows.iter().filter(|row| row.kernel == name).map(|row| row.as_written_cost).sum();
    (as_written, cost::default(&count, entry.kernel.meta.precision), cost::faithful(&count))
}

/// The ledger as it should be, and as it is.
///
/// # Errors
///
/// When it cannot be read.
pub fn expected(records: &Path, rows: &[Row]) -> miette::Result<(String, String)> {
    let present = match fs::read_to_string(path(records)) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        text => text.into_diagnostic()?,
    };
    Ok((text(rows)?, present))
}

/// Writes the ledger, in one step; says whether anything changed.
///
/// # Errors
///
/// When it cannot be written.
pub fn update(records: &Path, rows: &[Row]) -> miette::Result<bool> {
    let (expected, present) = expected(records, rows)?;
    if expected == present {
        return Ok(false);
    }
    if !present.is_empty() && !present.starts_with(FIRST_COLUMNS) {
        miette::bail!(
            help = "rename it if it is yours, or delete it",
            "{} is no ledger of kernels",
            path(records).display()
        );
    }
    write(records, &expected).map_err(|cause| {
        miette::miette!(help = "get the right to write there", "cannot write {}: {cause}", path(records).display())
    })?;
    Ok(true)
}

/// Where the ledger is.
#[must_use]
pub fn path(records: &Path) -> PathBuf {
    records.join(FILE)
}

fn write(records: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(records)?;
    let file = scratch::beside(&path(records), text)?;
    file.persist(path(records)).map_err(|error| error.error)?;
    Ok(())
}

fn text(rows: &[Row]) -> miette::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row)).into_diagnostic()?;
    let bytes = writer.into_inner().into_diagnostic()?;
    String::from_utf8(bytes).into_diagnostic()
}

/// What was measured of one result.
#[derive(Clone, Debug, Default)]
struct Measured {
    worst: f64,
    inputs: Vec<f64>,
    /// Of the formula as it is written, where it has a value in doubles.
    as_written: Option<f64>,
}

fn rows_of(entry: &Entry, kept: &KeptInputs, points: u32) -> Result<Vec<Row>, LedgerError> {
    let reference = Reference::of(&entry.kernel)?;
    let measured = measured(entry, &reference, kept, points)?;
    let formulas = reference.bodies().zip(&measured).enumerate();
    Ok(formulas.map(|(result, (formula, measured))| row(entry, result, formula, measured)).collect())
}

fn row(entry: &Entry, position: usize, formula: &Expr, measured: &Measured) -> Row {
    let result = &entry.kernel.meta.results[position];
    let count = operations_of(&entry.kernel, position);
    let precision = entry.kernel.meta.precision;
    let inputs = entry.maxima_names().into_iter().zip(&measured.inputs);
    let inputs: Vec<String> = inputs.map(|(name, value)| format!("{name}={}", hexfloat::print(*value))).collect();
    Row {
        kernel: entry.full_name(),
        result: result.name.to_string(),
        rules: entry.kernel.meta.rules.join(" "),
        roundings: roundings(&count, precision),
        divisions: count.div,
        roots: calls(&count),
        double_double: count.compensated,
        bound_ulp: result.bound.map_or_else(String::new, |bound| bound.to_string()),
        worst_ulp: ulp_text(measured.worst),
        worst_inputs: inputs.join(" "),
        as_written_ulp: measured.as_written.map_or_else(String::new, ulp_text),
        default_cost: cost::default(&count, precision),
        faithful_cost: cost::faithful(&count),
        as_written_cost: cost::as_written(formula),
        worst: measured.worst,
        bound: result.bound.unwrap_or(f64::INFINITY),
        as_written: measured.as_written,
    }
}

/// Calls of functions that round.
fn calls(count: &Operations) -> u32 {
    count.calls().map(|(_, calls)| calls).sum()
}

/// In double-double, and certified, only the result is rounded.
fn roundings(count: &Operations, precision: Precision) -> u32 {
    match precision {
        Precision::Double => {
            count.add + count.mul + count.div + calls(count) + count.compensated_expressions + count.root
        }
        Precision::DoubleDouble | Precision::Certified => 1,
    }
}

/// The worst errors at the kept inputs and at a sample, of the kernel and, at the sample, of the formula as written.
fn measured(
    entry: &Entry,
    reference: &Reference,
    kept: &KeptInputs,
    points: u32,
) -> Result<Vec<Measured>, LedgerError> {
    let domain = entry.domain()?;
    let inputs = entry.inputs();
    let sampled = sample(&domain, &inputs.iter().collect::<Vec<_>>(), points as usize, 1)?;
    let kept = kept.points(entry).concat().into_iter().filter(|point| domain.holds(point));
    let mut measured = vec![Measured::default(); entry.kernel.meta.results.len()];
    for (point, is_sampled) in kept.map(|point| (point, false)).chain(sampled.into_iter().map(|point| (point, true))) {
        if !covers(&entry.kernel, &point) {
            continue;
        }
        let Some((got, expected)) = values(&entry.kernel, reference, &point)? else { continue };
        for (result, formula) in reference.bodies().enumerate() {
            measured[result].include(ulp_error(got[result], &expected[result]), &point);
            if is_sampled {
                let as_written = evaluate_double(formula, domain.variables(), &point);
                measured[result].include_as_written(as_written.map(|value| ulp_error(value, &expected[result])));
            }
        }
    }
    Ok(measured)
}

impl Measured {
    fn include(&mut self, ulp: f64, point: &[f64]) {
        if ulp > self.worst || self.inputs.is_empty() {
            (self.worst, self.inputs) = (ulp, point.to_vec());
        }
    }

    fn include_as_written(&mut self, ulp: Option<f64>) {
        self.as_written = self.as_written.into_iter().chain(ulp).reduce(f64::max);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::fixture;

    #[test]
    fn the_ledger_says_what_is_won_and_what_it_costs() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = rows(folder.path(), &catalogue, 50).unwrap();
        let names: Vec<String> = rows.iter().map(|row| format!("{}.{}", row.kernel, row.result)).collect();
        assert_eq!(names, ["line::root.root", "line::slope.slope", "plane::slope.c", "plane::slope.d"]);
        let root = &rows[0];
        assert_eq!((root.roundings, root.divisions, root.roots, root.double_double), (5, 1, 1, 0));
        assert_eq!((root.default_cost, root.as_written_cost), (21, Some(13)));
        assert!(root.worst < 3.5 && root.as_written_ulp.parse::<f64>().unwrap() > 1e3, "{root:?}");
        assert_eq!(worst_of(&rows, "plane::slope"), rows[2].worst.max(rows[3].worst));
    }

    #[test]
    fn it_is_written_where_it_changed() {
        let (folder, catalogue) = fixture::catalogue();
        let rows = rows(folder.path(), &catalogue, 5).unwrap();
        let records = folder.path().join("records");
        assert!(update(&records, &rows).unwrap());
        assert!(!update(&records, &rows).unwrap());
        let (expected, present) = super::expected(&records, &rows).unwrap();
        assert_eq!((expected.lines().count(), &expected), (5, &present));
    }
}
