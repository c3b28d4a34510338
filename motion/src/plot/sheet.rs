//! A sheet: head and panels below each other, drawn on any canvas.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Font, clean, rgb};
use super::error::PlotError;
use super::frame::{Frame, INSIDE, LABEL, LEFT, NOTE, WIDTH};
use super::theme::Theme;

const TITLE: f64 = 19.0;
/// Below the last panel.
const REST: f64 = 8.0;
/// From a line of the legend to the next.
const LINE: f64 = 22.0;

/// What a picture shows.
#[derive(Clone)]
pub(super) struct Sheet {
    pub title: String,
    pub note: String,
    pub theme: Theme,
    /// Names beside their colours, and where they begin.
    legend: Vec<(String, (f64, f64))>,
    pub frames: Vec<Frame>,
    /// Whether the panels stand in two columns.
    pub is_wide: bool,
}

/// Base lines of title and note, and how high the head is without a legend.
fn lines(title: &str, note: &str) -> (f64, f64, f64) {
    let first = if title.is_empty() { 10.0 } else { 10.0 + TITLE };
    let second = if title.is_empty() { first + NOTE } else { first + NOTE + 8.0 };
    (first, second, if note.is_empty() { first } else { second })
}

impl Sheet {
    /// With a legend where there are several names.
    pub(super) fn new(title: &str, note: &str, theme: Theme, names: &[String]) -> Result<Self, PlotError> {
        let font = Font { size: LABEL, bold: false, colour: theme.text };
        let (mut x, mut y) = (LEFT, lines(title, note).2 + LINE);
        let mut legend = Vec::new();
        for name in names.iter().filter(|_| names.len() > 1) {
            let room = 34.0 + font.width(name)?;
            if x > LEFT && x + room > LEFT + INSIDE {
                (x, y) = (LEFT, y + LINE);
            }
            legend.push((name.clone(), (x, y)));
            x += room + 18.0;
        }
        Ok(Self { title: title.to_owned(), note: note.to_owned(), theme, legend, frames: Vec::new(), is_wide: false })
    }

    fn head(&self) -> f64 {
        self.legend.last().map_or(lines(&self.title, &self.note).2, |(_, (_, y))| *y) + 4.0
    }

    /// The panels of each column: the first is the one that comes to half of the height.
    pub(super) fn columns(&self) -> Vec<std::ops::Range<usize>> {
        let count = self.frames.len();
        if !self.is_wide || count < 2 {
            return std::iter::once(0..count).collect();
        }
        let mut left = self.frames.iter().map(Frame::room).sum::<f64>() / 2.0;
        let within = |frame: &&Frame| {
            left -= frame.room();
            left > -0.5 * frame.room()
        };
        let first = self.frames.iter().take_while(within).count().clamp(1, count - 1);
        vec![0..first, first..count]
    }

    /// Width and height, in pixels of the SVG.
    pub(super) fn size(&self) -> (f64, f64) {
        let columns = self.columns();
        let high = |column: &std::ops::Range<usize>| self.frames[column.clone()].iter().map(Frame::room).sum::<f64>();
        let highest = columns.iter().map(high).fold(0.0, f64::max);
        (WIDTH * columns.len() as f64, (self.head() + highest + REST).ceil())
    }

    /// Draws it.
    pub(super) fn draw<DB: DrawingBackend>(&self, backend: DB, canvas: &Canvas) -> Result<(), PlotError> {
        self.render(&backend.into_drawing_area(), canvas).map_err(PlotError::draw)
    }

    fn render<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        canvas: &Canvas,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        root.fill(&rgb(self.theme.background))?;
        let (head, mut right) = root.split_vertically(canvas.length(self.head()));
        self.texts(&head, canvas)?;
        for column in self.columns() {
            let (mut rest, next) = right.split_horizontally(canvas.length(WIDTH));
            for frame in &self.frames[column] {
                let (area, below) = rest.split_vertically(canvas.length(frame.room()));
                frame.draw(&area, canvas, &self.theme)?;
                rest = below;
            }
            right = next;
        }
        root.present()
    }

    /// Title, note and legend.
    fn texts<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        canvas: &Canvas,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let write = |text: &str, font: Font, (x, base): (f64, f64)| {
            let place = (canvas.length(x), canvas.length(base) - canvas.top(font));
            area.draw_text(&clean(text), &canvas.text(font, HPos::Left), place)
        };
        let (first, second, _) = lines(&self.title, &self.note);
        if !self.title.is_empty() {
            write(&self.title, Font { size: TITLE, bold: true, colour: self.theme.text }, (LEFT, first))?;
        }
        if !self.note.is_empty() {
            write(&self.note, Font { size: NOTE, bold: false, colour: self.theme.muted }, (LEFT, second))?;
        }
        for (index, (name, (x, y))) in self.legend.iter().enumerate() {
            let ends = [*x, x + 26.0].map(|x| (canvas.length(x), canvas.length(y - 5.0)));
            area.draw(&PathElement::new(ends, canvas.line(self.theme.curve(index), 3.5)))?;
            write(name, Font { size: LABEL, bold: false, colour: self.theme.text }, (x + 33.0, *y))?;
        }
        Ok(())
    }
}
