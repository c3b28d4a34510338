//! Pages: panels of curves as HTML that can be zoomed, moved and read, in one file without anything from elsewhere.

use std::io::Write;
use std::path::Path;

use serde::Serialize;

use super::error::PlotError;
use super::theme::Theme;
use crate::file::write_whole;

const PAGE: &str = include_str!("html/page.html");
const SCRIPT: &str = include_str!("html/page.js");

/// The colours of a dark screen, by their names in the page.
const DARK: &str = "--back: #0d1117; --text: #e6edf3; --muted: #9aa5b1; --grid: #222933; --frame: #4b5563; --c0: #56b4e9; \
                    --c1: #f0a13c; --c2: #3dd6a3; --c3: #e59ac6;";

/// A curve of a page.
#[derive(Debug, Clone, PartialEq, Serialize, Default)]
pub struct PageCurve {
    /// As the line of values calls it.
    pub name: String,
    /// Of the colours of a theme, counted on from the first again; negative for that of texts.
    pub colour: i32,
    /// Of its points, as many as of `y`; rising, in a panel over time.
    pub x: Vec<f64>,
    /// Of its points.
    pub y: Vec<f64>,
    /// Of a path, when each of its points is reached, in the unit of time of the page; empty where no time is known.
    pub when: Vec<f64>,
    /// The indices of points that no line leads to.
    pub starts: Vec<usize>,
    /// What its lines are, where a panel has several kinds.
    pub kind: String,
    /// With thin lines.
    pub thin: bool,
}

/// A dashed line at a value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PageLimit {
    /// In the unit of the panel.
    pub value: f64,
    /// As of [`PageCurve`]; negative for a muted one.
    pub colour: i32,
}

/// A named point.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PageMark {
    /// Across.
    pub x: f64,
    /// Up.
    pub y: f64,
    /// What stands beside it.
    pub name: String,
}

/// A panel of a page.
#[derive(Debug, Clone, PartialEq, Serialize, Default)]
pub struct PagePanel {
    /// Above it.
    pub title: String,
    /// On the right above it.
    pub note: String,
    /// Below it.
    pub x_title: String,
    /// What x is called where values are told.
    pub x_name: String,
    /// Of x.
    pub x_unit: String,
    /// Of y.
    pub y_unit: String,
    /// Over time: moves with all others that are.
    pub linked: bool,
    /// To one scale.
    pub equal: bool,
    /// With arrows along its curves.
    pub arrows: bool,
    /// The curves.
    pub curves: Vec<PageCurve>,
    /// Dashed lines.
    pub limits: Vec<PageLimit>,
    /// Named points.
    pub marks: Vec<PageMark>,
}

/// A page of panels.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// Above all.
    pub title: String,
    /// Below the title.
    pub note: String,
    /// Of the curves, in the order of their colours.
    pub names: Vec<String>,
    /// Where the panels over time end, in their unit.
    pub end: f64,
    /// Of time.
    pub unit: String,
    /// The panels.
    pub panels: Vec<PagePanel>,
    /// Whether it is dark, or as the screen is that shows it.
    pub is_dark: bool,
}

/// What the script reads.
#[derive(Serialize)]
struct Data<'a> {
    names: &'a [String],
    end: f64,
    unit: &'a str,
    panels: &'a [PagePanel],
}

impl Page {
    /// As text of HTML.
    ///
    /// # Errors
    ///
    /// A number is not finite.
    pub fn html(&self) -> Result<String, PlotError> {
        let data = Data { names: &self.names, end: self.end, unit: &self.unit, panels: &self.panels };
        if !self.is_finite() {
            return Err(PlotError::Empty { what: "a number of the page is not finite" });
        }
        // `<` inside of a string of JSON would end the element that it stands in
        let data = serde_json::to_string(&data).map_err(PlotError::draw)?.replace('<', "\\u003c");
        let (scheme, dark) = match self.is_dark {
            true => ("dark", format!(":root {{ {DARK} }}")),
            false => ("light dark", format!("@media (prefers-color-scheme: dark) {{ :root {{ {DARK} }} }}")),
        };
        let filled = [
            ("{{TITLE}}", escaped(&self.title)),
            ("{{NOTE}}", escaped(&self.note)),
            ("{{SCHEME}}", scheme.to_owned()),
            ("{{DARK}}", dark),
            ("{{SCRIPT}}", SCRIPT.to_owned()),
        ];
        let page = filled.iter().fold(PAGE.to_owned(), |page, (place, text)| page.replace(place, text));
        Ok(page.replacen("{{DATA}}", &data, 1))
    }

    /// Writes it into a file, whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        let html = self.html()?;
        write_whole(path, |out| Ok(out.write_all(html.as_bytes())?))
    }

    fn is_finite(&self) -> bool {
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        curves.flat_map(|curve| curve.x.iter().chain(&curve.y).chain(&curve.when)).all(|number| number.is_finite())
    }
}

/// The index of a colour in the theme, as a page counts.
pub(super) fn colour_index(theme: &Theme, colour: &str) -> i32 {
    theme.curves.iter().position(|curve| *curve == colour).map_or(-1, |index| index as i32)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('{', "&#123;")
}
