//! Charts: curves of any numbers, with linear or logarithmic scales.

use std::path::Path;

use super::drawing::{Drawing, Stroke, coordinate};
use super::error::PlotError;
use super::frame::{FOOT, Frame, HEAD, LEFT, RIGHT, WIDTH, head};
use super::scale::{Scale, widened};
use super::theme::Theme;

/// How high the panel is, in pixels.
const HEIGHT: f64 = 300.0;

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
        let mut drawing = Drawing::new(self.theme.background, &self.title);
        let names: Vec<String> = self.series.iter().map(|series| series.name.clone()).collect();
        let top = head(&mut drawing, &self.theme, &self.title, &self.note, &names) + HEAD;
        let bottom = top + HEIGHT;
        let x = scale(across, self.logarithmic.0, (LEFT, RIGHT));
        let y = scale(up, self.logarithmic.1, (bottom, top));
        let frame = Frame { x: &x, y: &y, top, bottom, theme: &self.theme };
        frame.grid(&mut drawing, (8, 8), true);
        frame.border(&mut drawing);
        for (index, series) in self.series.iter().enumerate() {
            drawing.path(polyline(series, &x, &y), Stroke::solid(self.theme.curve(index), 2.0));
        }
        frame.title(&mut drawing, &self.y_title, "");
        frame.below(&mut drawing, &self.x_title);
        drawing.size = (WIDTH, bottom + FOOT + 4.0);
        Ok(drawing)
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

fn scale((low, high): (f64, f64), logarithmic: bool, pixels: (f64, f64)) -> Scale {
    match logarithmic {
        true if low < high => Scale::logarithmic((low / 1.6, high * 1.6), pixels),
        true => Scale::logarithmic((low / 10.0, high * 10.0), pixels),
        false => Scale::linear(widened((low, high), 0.05, 0.05), pixels),
    }
}

fn polyline(series: &Series, x: &Scale, y: &Scale) -> String {
    let mut commands = std::iter::once('M').chain(std::iter::repeat('L'));
    let point = |(a, b): &(f64, f64)| {
        format!("{}{} {}", commands.next().unwrap_or('L'), coordinate(x.at(*a)), coordinate(y.at(*b)))
    };
    series.points.iter().map(point).collect()
}
