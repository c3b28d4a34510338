//! The table of kernels in README.md: written by `generate`, compared by `check`.

use super::verify::worst_of;
use crate::catalogue::{Catalogue, Entry};
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};

const BEGIN: &str = "<!-- kernels: written by `closedform generate` -->\n";
const END: &str = "<!-- end of kernels -->\n";

/// How many points of each domain the table's measured errors come from.
pub const POINTS: u32 = 200;

/// README.md as it should be, and as it is; `None` where there is none or it holds no table.
///
/// # Errors
///
/// When a kernel cannot be measured.
pub fn expected(root: &Path, catalogue: &Catalogue) -> miette::Result<Option<(String, String)>> {
    let Ok(text) = fs::read_to_string(root.join("README.md")) else { return Ok(None) };
    let Some((before, rest)) = text.split_once(BEGIN) else { return Ok(None) };
    let Some((_, after)) = rest.split_once(END) else { return Ok(None) };
    let table = table(catalogue)?;
    Ok(Some((format!("{before}{BEGIN}{table}{END}{after}"), text)))
}

/// Writes the table, in one step; says whether anything changed.
///
/// # Errors
///
/// When a kernel cannot be measured or the file cannot be written.
pub fn update(root: &Path, catalogue: &Catalogue) -> miette::Result<bool> {
    let Some((expected, present)) = expected(root, catalogue)? else { return Ok(false) };
    if expected == present {
        return Ok(false);
    }
    write(root, &expected).map_err(|cause| miette::miette!("cannot write README.md: {cause}"))?;
    Ok(true)
}

fn write(root: &Path, text: &str) -> io::Result<()> {
    let path = root.join("README.md");
    let file = tempfile::NamedTempFile::new_in(root)?;
    fs::write(file.path(), text)?;
    file.as_file().set_permissions(fs::metadata(&path)?.permissions())?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

fn table(catalogue: &Catalogue) -> miette::Result<String> {
    let mut text = String::from("| kernel | what it computes | domain | bound, ulp | worst measured |\n|---|---|---|---|---|\n");
    for entry in catalogue.entries() {
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} | {:.2} |",
            entry.full_name(),
            entry.kernel.meta.summary.trim_end_matches('.'),
            domain(entry),
            bound(entry),
            worst_of(entry, POINTS)?
        );
    }
    Ok(text)
}

fn domain(entry: &Entry) -> String {
    let conditions = entry.kernel.requires.iter().map(|require| format!("`{}`", require.text.replace('|', "\\|")));
    conditions.collect::<Vec<_>>().join(", ")
}

fn bound(entry: &Entry) -> f64 {
    entry.kernel.meta.results.iter().filter_map(|result| result.bound).fold(0.0, f64::max)
}
