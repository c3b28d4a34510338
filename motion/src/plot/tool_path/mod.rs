//! The picture of a milling job: where the tool goes, in colours that say how fast or how deep, and its axes over time.

mod colours;
mod gather;
mod path;
mod ramps;
mod series;
mod time;

use super::drawing::Drawing;
use super::error::PlotError;
use super::html::Page;
use super::sheet::Sheet;
use super::theme::Theme;
use crate::plan::milling::Row;
pub use colours::Colouring;
use gather::Gathered;

/// A milling job, gathered move by move. It takes no more memory than its picture needs, however many moves there are.
#[derive(Debug, Clone, Default)]
pub struct ToolPath {
    gathered: Gathered,
}

impl ToolPath {
    /// One without moves.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a move.
    pub fn add(&mut self, row: &Row) {
        self.gathered.add(row);
    }

    /// Adds a time in which nothing moves, in s.
    pub fn dwell(&mut self, time: f64) {
        self.gathered.dwell(time);
    }

    /// Draws it.
    ///
    /// # Errors
    ///
    /// No move has a length.
    pub fn draw(&self, colouring: Colouring, title: &str, note: &str, theme: Theme) -> Result<Drawing, PlotError> {
        self.check()?;
        let mut sheet = Sheet::new(title, note, theme, &[])?;
        sheet.frames.extend(path::frames(&self.gathered, colouring, &theme));
        sheet.frames.extend(time::frames(&self.gathered, &theme));
        Drawing::new(sheet, title)
    }

    /// The same as a page that can be zoomed and read.
    ///
    /// # Errors
    ///
    /// No move has a length.
    pub fn page(&self, title: &str, note: &str, theme: Theme) -> Result<Page, PlotError> {
        self.check()?;
        let time = time::unit(&self.gathered);
        let mut panels = vec![path::panel(&self.gathered, time.size)];
        panels.extend(time::panels(&self.gathered));
        Ok(Page {
            title: title.to_owned(),
            note: note.to_owned(),
            names: vec!["cut".to_owned(), "rapid".to_owned()],
            end: self.gathered.time / time.size,
            unit: time.name,
            panels,
            is_dark: theme == Theme::DARK,
        })
    }

    fn check(&self) -> Result<(), PlotError> {
        if self.gathered.is_empty() { Err(PlotError::Empty { what: "no move has a length" }) } else { Ok(()) }
    }
}
