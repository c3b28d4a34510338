//! A drawing: paths and texts, in the order in which they lie over each other.

use std::path::Path;

use super::error::PlotError;

/// Where a text is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Font {
    pub size: f64,
    pub bold: bool,
    pub colour: &'static str,
}

/// How a line looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    pub colour: &'static str,
    pub width: f64,
    pub dashes: &'static str,
}

impl Stroke {
    pub(super) const fn solid(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dashes: "" }
    }
}

/// A path or a text.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// `data` is path data of SVG.
    Path {
        data: String,
        fill: Option<&'static str>,
        stroke: Stroke,
    },
    Text {
        at: (f64, f64),
        anchor: Anchor,
        font: Font,
        text: String,
    },
}

/// A picture, drawn: SVG or PNG as it is asked for.
#[derive(Debug, Clone)]
pub struct Drawing {
    pub(super) shapes: Vec<Shape>,
    pub(super) size: (f64, f64),
    pub(super) background: &'static str,
    /// What a screen reader says.
    pub(super) title: String,
}

/// A coordinate: hundredths of a pixel are more than any printer shows.
pub(super) fn coordinate(number: f64) -> String {
    let text = format!("{number:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// About how wide a text is: DejaVu Sans, the widest of the fonts asked for, has digits of 0.64 of its size.
pub(super) fn width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * 0.62
}

/// How much wider bold text is.
pub(super) const BOLD: f64 = 1.1;

impl Drawing {
    pub(super) fn new(background: &'static str, title: &str) -> Self {
        Self { shapes: Vec::new(), size: (0.0, 0.0), background, title: title.to_owned() }
    }

    /// Writes it into a file that ends in `.svg`, or in `.png` (which needs the feature `png`), whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        super::file::save(path, self)
    }

    pub(super) fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: Stroke) {
        self.path(format!("M{}L{}", point(from), point(to)), stroke);
    }

    pub(super) fn path(&mut self, data: String, stroke: Stroke) {
        self.shapes.push(Shape::Path { data, fill: None, stroke });
    }

    pub(super) fn frame(&mut self, corner: (f64, f64), size: (f64, f64), stroke: Stroke) {
        let [right, bottom] = [corner.0 + size.0, corner.1 + size.1].map(coordinate);
        let left = coordinate(corner.0);
        self.path(format!("M{}H{right}V{bottom}H{left}Z", point(corner)), stroke);
    }

    pub(super) fn dot(&mut self, centre: (f64, f64), radius: f64, fill: &'static str, stroke: Stroke) {
        let (left, right) = (point((centre.0 - radius, centre.1)), point((centre.0 + radius, centre.1)));
        let arc = format!("A{0} {0} 0 1 0 ", coordinate(radius));
        self.shapes.push(Shape::Path { data: format!("M{left}{arc}{right}{arc}{left}Z"), fill: Some(fill), stroke });
    }

    pub(super) fn text(&mut self, at: (f64, f64), anchor: Anchor, font: Font, text: &str) {
        self.shapes.push(Shape::Text { at, anchor, font, text: text.to_owned() });
    }
}

/// Both coordinates.
pub(super) fn point((x, y): (f64, f64)) -> String {
    format!("{} {}", coordinate(x), coordinate(y))
}
