//! A drawing: SVG or PNG, as it is asked for.

use std::path::Path;

use plotters::prelude::SVGBackend;

use super::canvas::{Canvas, clean};
use super::error::PlotError;
use super::sheet::Sheet;

/// A picture, drawn: SVG or PNG as it is asked for.
#[derive(Clone)]
pub struct Drawing {
    #[cfg(feature = "png")]
    pub(super) sheet: Sheet,
    svg: String,
}

impl Drawing {
    /// Draws a sheet, which a screen reader calls by a name.
    pub(super) fn new(sheet: Sheet, name: &str) -> Result<Self, PlotError> {
        let mut svg = String::new();
        sheet.draw(SVGBackend::with_string(&mut svg, Canvas::SVG.size(sheet.size())), &Canvas::SVG)?;
        let svg = headed(&svg, sheet.size(), name);
        Ok(Self {
            #[cfg(feature = "png")]
            sheet,
            svg,
        })
    }

    /// As text of SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg.clone()
    }

    /// Writes it into a file that ends in `.svg`, or in `.png` (which needs the feature `png`), whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        super::file::save(path, self)
    }
}

/// The plotting library counts in whole pixels, so it draws on a large canvas, which another first line shows small. It
/// also has the name for screen readers, and rounds the joins of lines.
fn headed(svg: &str, (width, height): (f64, f64), name: &str) -> String {
    let (wide, high) = Canvas::SVG.size((width, height));
    let name = clean(name).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let body = svg.split_once('\n').map_or("", |(_, body)| body);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {wide} {high}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\" stroke-linejoin=\"round\">\n<title>{name}</title>\n{body}"
    )
}

impl std::fmt::Debug for Drawing {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Drawing").field("svg", &self.svg).finish_non_exhaustive()
    }
}
