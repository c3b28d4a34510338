//! Charts: curves of any numbers, with linear or logarithmic scales.

use std::path::Path;

use super::drawing::Drawing;
use super::error::PlotError;
use super::frame::{Frame, Line};
use super::scale::{Scale, widened};
use super::sheet::Sheet;
use super::theme::Theme;

/// How high the panel is, in pixels.
const HEIGHT: f64 = 300.0;

/// At most.
const TICKS: usize = 8;

/// The least and the largest value.
type Range = (f64, f64);

/// A curve of a chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// As the legend says it.
    pub name: String,
    /// Joined by straight lines.
    pub points: Vec<(f64, f64)>,
}

/// Curves of any numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Above all.
    pub title: String,
    /// Below the title.
    pub note: String,
    /// What x is, and in which unit.
    pub x_title: String,
    /// What y is, and in which unit.
    pub y_title: String,
    /// Whether the scales of x and y are logarithmic; all their numbers are then positive.
    pub logarithmic: (bool, bool),
    /// The curves.
    pub series: Vec<Series>,
    /// The colours.
    pub theme: Theme,
}

impl Chart {
    /// Draws it.
    ///
    /// # Errors
    ///
    /// There are no points, or one that has no place on its scale.
    pub fn draw(&self) -> Result<Drawing, PlotError> {
        let (across, up) = self.ranges()?;
        let names: Vec<String> = self.series.iter().map(|series| series.name.clone()).collect();
        let mut sheet = Sheet::new(&self.title, &self.note, self.theme, &names)?;
        let line = |(index, series): (usize, &Series)| Line {
            points: series.points.clone(),
            colour: self.theme.curve(index),
            width: 2.0,
            is_dashed: false,
        };
        sheet.frames.push(Frame {
            title: self.y_title.clone(),
            note: String::new(),
            height: HEIGHT,
            x: scale(across, self.logarithmic.0),
            y: scale(up, self.logarithmic.1),
            below: Some(self.x_title.clone()),
            meetings: Vec::new(),
            lines: self.series.iter().enumerate().map(line).collect(),
            dots: Vec::new(),
            arrows: Vec::new(),
            labels: Vec::new(),
        });
        Drawing::new(sheet, &self.title)
    }

    /// Draws it into a file that ends in `.svg` or `.png`, whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        self.draw()?.save(path)
    }

    fn ranges(&self) -> Result<(Range, Range), PlotError> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let has_place = |value: f64, logarithmic: bool| value.is_finite() && (value > 0.0 || !logarithmic);
        let fits =
            |point: &&(f64, f64)| has_place(point.0, self.logarithmic.0) && has_place(point.1, self.logarithmic.1);
        match points().all(|point| fits(&point)) {
            true if points().next().is_some() => {
                Ok((range(points().map(|point| point.0)), range(points().map(|point| point.1))))
            }
            true => Err(PlotError::Empty { what: "no points" }),
            false => Err(PlotError::Empty { what: "a point is not finite, or not positive on a logarithmic scale" }),
        }
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

fn scale((low, high): Range, logarithmic: bool) -> Scale {
    match logarithmic {
        true if low < high => Scale::logarithmic((low / 1.6, high * 1.6), TICKS),
        true => Scale::logarithmic((low / 10.0, high * 10.0), TICKS),
        false => Scale::linear(widened((low, high), 0.05, 0.05), TICKS),
    }
}
