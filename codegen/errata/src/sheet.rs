//! One file of errata, checked: its rows with every formula read and every kernel found.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use closedform_maxima::Expr;
use toml::Spanned;

use super::error::{Mistake, Mistakes, VerdictError};
use super::formula::{self, Formula, FormulaError};
use super::judge::Verdict;
use super::row::{self, Text};
use super::shipped::Shipped;
use closedform_project::source;

/// `errata/NAME.toml` with its neighbour `errata/NAME.mac`.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// `NAME`
    pub name: String,
    /// The TOML file.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
    /// The cells, replayed in Maxima.
    pub replay: PathBuf,
    /// What it is about.
    pub title: String,
    /// The derivation: its title, and the section.
    pub source: String,
    /// The rows, in the order of the derivation.
    pub rows: Vec<Row>,
}

/// One printed output with its stated verdict.
#[derive(Debug, Clone)]
pub struct Row {
    /// Section, label, name.
    pub cell: String,
    /// The stated verdict.
    pub verdict: Verdict,
    /// Where it is stated.
    pub place: Range<usize>,
    /// What the input cell gives, over the names of the replay.
    pub live: Formula,
    /// What the derivation prints.
    pub printed: Option<Printed>,
    /// Which slip of the print is repaired, and how.
    pub repair: Option<String>,
    /// The text after the repair, or what the derivation does not show.
    pub reads: Option<Formula>,
    /// Why the cell is not true.
    pub error: Option<String>,
    /// What is true instead.
    pub right: Option<Formula>,
    /// What must be 0 if `right` is right.
    pub proof: Vec<Formula>,
    /// What to compare at the example, where it is not `live` and `right` themselves.
    pub shows: Option<[Formula; 2]>,
    /// Where wrong forms have other values.
    pub example: Option<Example>,
    /// The shipped formulas that it is.
    pub kernels: Vec<Shipment>,
}

/// What the derivation prints.
#[derive(Debug, Clone)]
pub struct Printed {
    /// The transcription, on one line.
    pub text: String,
    /// What it says, if it says anything.
    pub form: Result<Expr, FormulaError>,
    /// Where it stands.
    pub place: Range<usize>,
}

/// Symbols with exact numbers.
#[derive(Debug, Clone)]
pub struct Example {
    /// In the order of the file.
    pub numbers: Vec<(String, Expr)>,
    /// Where it stands.
    pub place: Range<usize>,
}

/// A shipped formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shipment {
    /// The family that ships it.
    pub family: String,
    /// The kernel.
    pub kernel: String,
}

impl Sheet {
    /// Reads `NAME.toml` in the folder of errata; all mistakes are reported at once.
    pub(super) fn load(folder: &Path, name: &str, shipped: &Shipped) -> Result<Self, VerdictError> {
        let path = folder.join(format!("{name}.toml"));
        let remedy = "write this file, or strike its name out of errata/ORDER";
        let text = source::read(&path, remedy)?;
        let sheet = read(&text, shipped).map_err(|mistakes| Mistakes::new(&path, &text, mistakes))?;
        let (heading, rows) = sheet;
        let replay = path.with_extension("mac");
        Ok(Self { name: name.to_owned(), path, text, replay, title: heading.title, source: heading.source, rows })
    }
}

fn read(text: &str, shipped: &Shipped) -> Result<(row::Heading, Vec<Row>), Vec<Mistake>> {
    let file: row::File = toml::from_str(text).map_err(|error| vec![Mistake::toml(&error)])?;
    let mut reader = Reader { text, shipped, mistakes: Vec::new() };
    reader.cells_differ(&file.output);
    let rows: Vec<Row> = file.output.into_iter().filter_map(|row| reader.row(row)).collect();
    if reader.mistakes.is_empty() { Ok((file.derivation, rows)) } else { Err(reader.mistakes) }
}

struct Reader<'a> {
    text: &'a str,
    shipped: &'a Shipped,
    mistakes: Vec<Mistake>,
}

impl Reader<'_> {
    fn cells_differ(&mut self, rows: &[row::Row]) {
        let mut seen: BTreeMap<&str, Range<usize>> = BTreeMap::new();
        for row in rows {
            let cell = row.cell.get_ref();
            if let Some(first) = seen.insert(cell, row.cell.span()) {
                let span = row.cell.span().into();
                self.mistakes.push(Mistake::CellTwice { cell: cell.clone(), first: first.into(), span });
            }
        }
    }

    /// The row, unless a formula of it cannot be read.
    fn row(&mut self, row: row::Row) -> Option<Row> {
        let cell = row.cell.into_inner();
        let before = self.mistakes.len();
        let live = self.formula(&cell, &row.live, formula::expression);
        let reads = row.reads.map(|text| self.formula(&cell, &text, formula::form));
        let right = row.right.map(|text| self.formula(&cell, &text, formula::form));
        let proof: Vec<_> = row.proof.iter().map(|text| self.formula(&cell, text, formula::expression)).collect();
        let shows = row.shows.map(|texts| texts.map(|text| self.formula(&cell, &text, formula::expression)));
        let example = row.example.map(|text| self.example(&cell, &text));
        let kernels: Vec<_> = row.kernel.iter().map(|kernel| self.kernel(&cell, kernel)).collect();
        if self.mistakes.len() > before {
            return None;
        }
        Some(Row {
            verdict: *row.verdict.get_ref(),
            place: row.verdict.span(),
            live: live?,
            printed: row.printed.map(|text| printed(&text)),
            repair: row.repair.map(Spanned::into_inner),
            reads: reads.flatten(),
            error: row.error.map(Spanned::into_inner),
            right: right.flatten(),
            proof: proof.into_iter().flatten().collect(),
            shows: shows.and_then(|[one, other]| Some([one?, other?])),
            example: example.flatten(),
            kernels: kernels.into_iter().flatten().collect(),
            cell,
        })
    }

    fn formula(&mut self, cell: &str, text: &Text, read: fn(&str) -> Result<Expr, FormulaError>) -> Option<Formula> {
        let expression = self.noted(cell, text, read(text.get_ref()))?;
        Some(Formula { expression, place: text.span() })
    }

    fn example(&mut self, cell: &str, text: &Text) -> Option<Example> {
        let numbers = self.noted(cell, text, formula::example(text.get_ref()))?;
        Some(Example { numbers, place: text.span() })
    }

    fn kernel(&mut self, cell: &str, kernel: &row::Call) -> Option<Shipment> {
        let text = &kernel.call;
        let (function, arguments) = self.noted(cell, text, formula::call(text.get_ref()))?;
        if let Some(zero) = kernel.part.iter().find(|step| *step.get_ref() == 0) {
            self.mistakes.push(Mistake::Part { cell: cell.to_owned(), span: zero.span().into() });
        }
        let Some((inputs, shipment)) = self.shipped.get(&function) else {
            let span = text.span().into();
            self.mistakes.push(Mistake::NotShipped { cell: cell.to_owned(), function, span });
            return None;
        };
        if arguments.len() != *inputs {
            let (found, wanted, span) = (arguments.len(), *inputs, text.span().into());
            self.mistakes.push(Mistake::Arguments { cell: cell.to_owned(), function, found, wanted, span });
        }
        Some(shipment.clone())
    }

    fn noted<T>(&mut self, cell: &str, text: &Text, read: Result<T, FormulaError>) -> Option<T> {
        let note = |cause: FormulaError| {
            let span = self.within(text, cause.span()).into();
            self.mistakes.push(Mistake::Formula { cell: cell.to_owned(), cause: cause.into(), span });
        };
        read.map_err(note).ok()
    }

    /// A place in a text as a place in the file; the whole string where TOML escapes moved its letters.
    fn within(&self, text: &Text, place: Range<usize>) -> Range<usize> {
        let string = text.span();
        let start = self.text.get(string.clone()).and_then(|quoted| quoted.find(text.get_ref().as_str()));
        start.map_or(string.clone(), |start| string.start + start + place.start..string.start + start + place.end)
    }
}

fn printed(text: &Text) -> Printed {
    let line = text.get_ref().split_whitespace().collect::<Vec<_>>().join(" ");
    Printed { text: line, form: formula::form(text.get_ref()), place: text.span() }
}
