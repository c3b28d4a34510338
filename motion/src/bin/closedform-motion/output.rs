//! What becomes of a plan: summary, table and picture.

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use closedform_motion::Motion;
use closedform_motion::plot::{Picture, PlotError, Theme};
use closedform_motion::table::{self, Heading, Row, TableError, Timing, knots};
use indicatif::ProgressBar;

use crate::error::{Failure, Outcome};
use crate::export::Export;
use crate::standard::is_standard;
use crate::summary::Summary;

/// So many rows take a second.
const MANY: u64 = 100_000;

/// Where the results go.
#[derive(Args, Debug, Clone)]
pub struct Output {
    /// Inputs from a TOML file: the same names as the flags, which come before it
    #[arg(long, value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Write the table there: .csv or .json, or `-` for CSV on standard output (the summary then goes to standard error)
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,
    /// Write a picture there: .svg, .png, or .html to zoom and to read values
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// The first column of a PVT table says how long each segment takes, not when it ends
    #[arg(long)]
    pub durations: bool,
    /// How far cubics between the rows of a PVT table may be off, in m
    #[arg(long, value_name = "M", default_value_t = 1e-9)]
    pub tolerance: f64,
    /// What a controller takes.
    #[command(flatten)]
    pub export: Export,
    /// Draw the picture for a dark screen
    #[arg(long)]
    pub dark: bool,
    /// Draw the panels of the picture in two columns
    #[arg(long)]
    pub wide: bool,
    /// Print the summary as JSON
    #[arg(long)]
    pub json: bool,
}

impl Output {
    /// The colours of the picture.
    pub fn theme(&self) -> Theme {
        if self.dark { Theme::DARK } else { Theme::LIGHT }
    }

    /// Whether the names of the files say what to write, before anything is written.
    pub fn check(&self) -> Outcome<()> {
        if let Some(path) = self.table.as_deref().filter(|path| !is_standard(path) && !ends(path, &["csv", "json"])) {
            return Err(Failure::from(TableError::Format { path: path.display().to_string() }));
        }
        if let Some(path) = self.picture.as_deref().filter(|path| !ends(path, &["svg", "png", "html"])) {
            return Err(Failure::from(PlotError::Format { path: path.display().to_string() }));
        }
        if !(self.tolerance > 0.0 && self.tolerance.is_finite()) {
            return Err(Failure::from(TableError::Tolerance { tolerance: self.tolerance }));
        }
        if let Some(path) = &self.export.export {
            let others = [("file", &self.file), ("table", &self.table), ("picture", &self.picture)];
            if let Some((flag, _)) =
                others.into_iter().find(|(_, other)| other.as_ref().is_some_and(|other| other == path))
            {
                return Err(Failure(format!("this is the file of --{flag} too: give another name")).at(path));
            }
        }
        self.export.check()?;
        self.spares(self.file.as_deref())
    }

    /// Writes what a controller takes, if it is asked for.
    pub fn controller<R: Into<Row>>(
        &self,
        summary: &mut Summary,
        axes: &[String],
        count: u64,
        rows: impl IntoIterator<Item = R>,
        motion: impl FnOnce() -> Outcome<Motion>,
    ) -> Outcome<()> {
        if let Some((path, points)) = self.export.rows(axes, (count, rows), motion, &progress(count))? {
            summary.file(path, Some(points));
        }
        Ok(())
    }

    /// Whether what is to be written leaves a file alone that the plan is read from.
    pub fn spares(&self, read: Option<&Path>) -> Outcome<()> {
        let written = [("table", &self.table), ("picture", &self.picture), ("export", &self.export.export)];
        let mut written = written.into_iter().filter_map(|(flag, path)| Some((flag, path.as_deref()?)));
        match read.and_then(|read| written.find(|(_, path)| is_same_file(path, read))) {
            Some((flag, path)) => {
                let message = format!("the plan is read from this file: give --{flag} another name, so that it stays");
                Err(Failure(message).at(path))
            }
            None => Ok(()),
        }
    }

    /// Whether a file of this name may be written, of one of these kinds.
    pub fn writes(&self, path: &Path, endings: &[&str]) -> Outcome<()> {
        if !ends(path, endings) {
            let message = format!("its name must end in .{}: give it another", endings.join(" or ."));
            return Err(Failure(message).at(path));
        }
        for (flag, other) in [("file", &self.file), ("table", &self.table), ("picture", &self.picture)] {
            if other.as_deref().is_some_and(|other| other == path || is_same_file(other, path)) {
                return Err(Failure(format!("this is the file of --{flag} too: give another name")).at(path));
            }
        }
        Ok(())
    }

    /// Writes the table of so many rows, if one is asked for.
    pub fn table<R: Into<Row>>(
        &self,
        summary: &mut Summary,
        axes: &[String],
        count: u64,
        rows: impl IntoIterator<Item = R>,
    ) -> Outcome<()> {
        let Some(path) = &self.table else { return Ok(()) };
        let timing = if self.durations { Timing::Duration } else { Timing::Absolute };
        let heading = Heading { axes: axes.to_vec(), timing };
        let bar = progress(count);
        let rows = bar.wrap_iter(rows.into_iter());
        if is_standard(path) {
            return to_standard_output(&heading, rows);
        }
        let rows = table::save(path, &heading, rows).map_err(|error| Failure::from(error).at(path))?;
        bar.finish_and_clear();
        summary.file(path, Some(rows));
        Ok(())
    }

    /// Writes the table of a motion, if one is asked for.
    pub fn table_of(&self, summary: &mut Summary, motion: &Motion) -> Outcome<()> {
        let Some(path) = self.table.as_deref().or(self.export.export.as_deref()) else { return Ok(()) };
        let axes: Vec<String> = motion.axes().iter().map(|axis| axis.name.clone()).collect();
        let rows = knots(motion, self.tolerance).map_err(|error| Failure::from(error).at(path))?;
        self.controller(summary, &axes, rows.len() as u64, rows.clone(), || Ok(motion.clone()))?;
        self.table(summary, &axes, rows.len() as u64, rows)
    }

    /// Writes the picture, if one is asked for.
    pub fn picture(&self, summary: &mut Summary, picture: Picture) -> Outcome<()> {
        let Some(path) = &self.picture else { return Ok(()) };
        picture.theme(self.theme()).wide(self.wide).save(path).map_err(|error| Failure::from(error).at(path))?;
        summary.file(path, None);
        Ok(())
    }

    /// Prints the summary.
    pub fn print(&self, summary: &Summary) -> Outcome<()> {
        let text = if self.json { summary.json() } else { summary.text() };
        if self.table.as_deref().is_some_and(is_standard) {
            note(text.trim_end());
            return Ok(());
        }
        let mut output = io::stdout().lock();
        unless_closed(output.write_all(text.as_bytes()).and_then(|()| output.flush()))
    }
}

/// Writes a table as CSV to standard output; the summary then goes to standard error.
fn to_standard_output<R: Into<Row>>(heading: &Heading, rows: impl IntoIterator<Item = R>) -> Outcome<()> {
    match table::write_csv(io::BufWriter::new(io::stdout().lock()), heading, rows) {
        Ok(_) => Ok(()),
        Err(TableError::Csv(error)) => match error.into_kind() {
            csv::ErrorKind::Io(error) => unless_closed(Err(error)),
            other => Err(Failure(format!("the table cannot be written: {other:?}"))),
        },
        Err(TableError::Io(error)) => unless_closed(Err(error)),
        Err(error) => Err(error.into()),
    }
}

/// Shows how far it is with so many rows, on a terminal, where it takes some time.
fn progress(count: u64) -> ProgressBar {
    if count < MANY { ProgressBar::hidden() } else { ProgressBar::new(count) }
}

/// Whether the name of a file says that it is of one of some kinds.
fn ends(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    endings.iter().any(|one| ending.eq_ignore_ascii_case(one))
}

/// Whether both paths lead to one file that is there.
fn is_same_file(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(std::fs::canonicalize);
    one.is_ok_and(|one| other.is_ok_and(|other| one == other))
}

/// What writing to standard output came to; that nobody reads on is no failure.
pub fn unless_closed(written: io::Result<()>) -> Outcome<()> {
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure(format!("cannot write to standard output: {error}; make room, or send it elsewhere")))
        }
        _ => Ok(()),
    }
}

/// Writes a line to standard error, if anybody reads it: where that is closed or full, nothing is left to complain to.
pub fn note(text: &str) {
    _ = writeln!(io::stderr().lock(), "{text}");
}
