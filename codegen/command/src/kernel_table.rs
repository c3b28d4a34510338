//! The table of kernels on a page of the project: written by `generate`, compared by `check`.

use closedform_measure::catalogue::{Catalogue, Entry};
use closedform_measure::ledger::{Row, as_written_of, costs_of, worst_of};
use closedform_project::{Project, markdown};
use closedform_system::scratch;
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};

const BEGIN: &str = "<!-- kernels: written by `closedform generate` -->\n";
const END: &str = "<!-- end of kernels -->\n";

/// The page as it should be, and as it is; `None` where there is none or it holds no table.
pub fn expected(project: &Project, catalogue: &Catalogue, rows: &[Row]) -> Option<(String, String)> {
    let text = fs::read_to_string(project.table.as_ref()?).ok()?;
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    let expected = format!("{before}{BEGIN}{}{END}{after}", table(catalogue, rows));
    Some((expected, text))
}

/// Writes the table, in one step; says whether anything changed.
///
/// # Errors
///
/// When the file cannot be written.
pub fn update(project: &Project, catalogue: &Catalogue, rows: &[Row]) -> miette::Result<bool> {
    let (Some(page), Some((expected, present))) = (&project.table, expected(project, catalogue, rows)) else {
        return Ok(false);
    };
    if expected == present {
        return Ok(false);
    }
    write(page, &expected).map_err(|cause| {
        miette::miette!(help = "get the right to write there", "cannot write {}: {cause}", page.display())
    })?;
    Ok(true)
}

fn write(page: &Path, text: &str) -> io::Result<()> {
    let file = scratch::beside(page, text)?;
    file.as_file().set_permissions(fs::metadata(page)?.permissions())?;
    file.persist(page).map_err(|error| error.error)?;
    Ok(())
}

fn table(catalogue: &Catalogue, rows: &[Row]) -> String {
    let mut text = String::from(
        "| kernel | what it computes | domain | bound, ulp | worst measured | formula, ulp | costs |\n|---|---|---|---|---|---|---|\n",
    );
    for entry in catalogue.entries() {
        let (as_written, default, faithful) = costs_of(rows, entry);
        let as_written = as_written.map_or_else(|| "-".to_owned(), |cost| cost.to_string());
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} | {:.2} | {} | {as_written} {default} {faithful} |",
            entry.full_name(),
            markdown::plain(entry.kernel.meta.summary.trim_end_matches('.')),
            domain(entry),
            bound(entry),
            worst_of(rows, &entry.full_name()),
            as_written_of(rows, &entry.full_name()).map_or_else(|| "-".to_owned(), short),
        );
    }
    text
}

/// An error of some ulp to a digit behind the point, a larger one as a power of ten.
fn short(ulp: f64) -> String {
    match ulp {
        _ if ulp.is_infinite() => "all digits".to_owned(),
        _ if ulp < 1e3 => format!("{ulp:.1}"),
        _ => format!("1e{}", ulp.log10().floor()),
    }
}

fn domain(entry: &Entry) -> String {
    let conditions = entry.kernel.requires.iter().map(|require| markdown::code(&require.text).replace('|', "\\|"));
    conditions.collect::<Vec<_>>().join(", ")
}

fn bound(entry: &Entry) -> f64 {
    entry.kernel.meta.results.iter().filter_map(|result| result.bound).fold(0.0, f64::max)
}
