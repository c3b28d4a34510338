//! Errata: every printed output of a derivation against what its cell gives, judged by Maxima.

mod contrast;
mod error;
mod facts;
mod formula;
mod judge;
mod order;
mod page;
mod problem;
mod question;
mod row;
mod sheet;
mod shipped;

use std::path::{Path, PathBuf};

pub use contrast::Contrast;
pub use error::{Mistake, Mistakes, VerdictError};
pub use facts::{Facts, Value};
pub use formula::{Formula, FormulaError};
pub use judge::{Judged, Verdict, judge};
pub use page::listed;
pub use problem::{Form, Problem};
pub use sheet::{Example, Printed, Row, Sheet, Shipment};

use closedform_project::maxima_process::Maxima;
use shipped::Shipped;

/// The page in a folder of worksheets.
pub const PAGE: &str = "ERRATA.md";

/// The folder of errata in a folder of worksheets.
const FOLDER: &str = "errata";

/// The errata of a folder, read and checked.
#[derive(Debug, Clone)]
pub struct Errata {
    /// In the order of the page.
    pub sheets: Vec<Sheet>,
    /// Where the page stands.
    pub page: PathBuf,
}

/// Whether a folder of worksheets has errata of this name.
pub fn has_errata(folder: &Path, name: &str) -> bool {
    folder.join(FOLDER).join(format!("{name}.toml")).is_file()
}

impl Errata {
    /// The errata of a folder of worksheets; `None` where it has none.
    ///
    /// # Errors
    ///
    /// When a file of theirs, or a contract, cannot be read.
    pub fn load(folder: &Path) -> Result<Option<Self>, VerdictError> {
        let errata = folder.join(FOLDER);
        if !errata.is_dir() {
            return Ok(None);
        }
        let shipped = Shipped::load(folder)?;
        let sheet = |name: &String| Sheet::load(&errata, name, &shipped);
        let sheets = order::names(&errata)?.iter().map(sheet).collect::<Result<_, _>>()?;
        Ok(Some(Self { sheets, page: folder.join(PAGE) }))
    }

    /// Asks Maxima, one run a file, and compares every stated verdict; the text of the page.
    ///
    /// # Errors
    ///
    /// When a replay fails, or a verdict does not stand.
    pub fn judge(&self, maxima: &Maxima) -> Result<String, VerdictError> {
        let (mut judged, mut wrong) = (Vec::new(), Vec::new());
        for sheet in &self.sheets {
            match sheet.judge(maxima)? {
                Ok(rows) => judged.push((sheet, rows)),
                Err(mistakes) => wrong.push(mistakes),
            }
        }
        if wrong.is_empty() { Ok(page::print(&judged)) } else { Err(VerdictError::Wrong(wrong)) }
    }

    /// Every row with its stated verdict, as the page lists them.
    pub fn stated(&self) -> Vec<(String, String)> {
        let rows = self.sheets.iter().flat_map(|sheet| &sheet.rows);
        rows.map(|row| (row.cell.clone(), row.verdict.to_string())).collect()
    }
}

impl Sheet {
    fn judge(&self, maxima: &Maxima) -> Result<Result<Vec<Judged>, Mistakes>, VerdictError> {
        let messages = maxima.run(&self.replay, &question::driver(&self.rows))?;
        let facts = Facts::read(&messages, self.rows.len());
        let (mut judged, mut mistakes) = (Vec::new(), Vec::new());
        for (row, facts) in self.rows.iter().zip(&facts) {
            match judge(row, facts) {
                Ok(row) => judged.push(row),
                Err(problem) => {
                    let span = problem.place(row).into();
                    mistakes.push(Mistake::Verdict { cell: row.cell.clone(), problem: Box::new(problem), span });
                }
            }
        }
        if mistakes.is_empty() {
            return Ok(Ok(judged));
        }
        Ok(Err(Mistakes::new(&self.path, &self.text, mistakes)))
    }
}

#[cfg(test)]
mod tests;
