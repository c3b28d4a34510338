//! The canvas that a backend of the plotting library draws on: lengths, lines and texts in its pixels.

use std::sync::LazyLock;

use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::error::PlotError;

/// The fonts of an SVG, the first that a machine has; their name in the plotting library, which has the first of them.
const FAMILY: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

/// By what the plotting library divides the size of a font when it writes SVG.
pub(super) const EM: f64 = 1.24;

/// How far below the top and the middle of a text it then sets the base line, in the size of the font.
pub(super) const BASE_BELOW_TOP: f64 = 0.76;
pub(super) const BASE_BELOW_MIDDLE: f64 = 0.27;

/// The height of a line of DejaVu Sans, which it takes for the size when it measures a text.
const LINE: f64 = 2384.0 / 2048.0;

/// By how much another font may be wider than DejaVu Sans, which is one of the widest.
const SPARE: f64 = 1.05;

/// How many pixels of a canvas a text is measured in a pixel of the SVG.
const FINE: f64 = 16.0;

/// Whether DejaVu Sans is in the plotting library.
static FONTS: LazyLock<bool> = LazyLock::new(|| {
    let faces = [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())];
    faces.into_iter().all(|(style, bytes)| register_font(FAMILY, style, bytes).is_ok())
});

/// How a text looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Font {
    pub size: f64,
    pub bold: bool,
    pub colour: &'static str,
}

impl Font {
    /// How wide a text may be, in pixels of the SVG.
    pub(super) fn width(self, text: &str) -> Result<f64, PlotError> {
        let wide = self.description(FINE * LINE).box_size(&clean(text));
        wide.map(|(width, _)| SPARE * f64::from(width) / FINE).map_err(PlotError::draw)
    }

    fn description(self, scale: f64) -> FontDesc<'static> {
        let style = if *FONTS && self.bold { FontStyle::Bold } else { FontStyle::Normal };
        FontDesc::new(FontFamily::Name(FAMILY), self.size * scale, style)
    }
}

/// What a backend makes of lengths and texts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Canvas {
    /// Of its pixels, which are whole numbers, how many a pixel of the SVG has.
    scale: f64,
}

impl Canvas {
    /// For text of SVG: coordinates to the tenth of a pixel.
    pub(super) const SVG: Self = Self { scale: 10.0 };

    /// For pixels, so many a pixel of the SVG.
    #[cfg(feature = "png")]
    pub(super) const fn pixels(scale: f64) -> Self {
        Self { scale }
    }

    /// A length in its pixels.
    pub(super) fn length(&self, length: f64) -> i32 {
        (length * self.scale).round() as i32
    }

    /// Width and height in its pixels.
    pub(super) fn size(&self, (width, height): (f64, f64)) -> (u32, u32) {
        (self.length(width).unsigned_abs(), self.length(height).unsigned_abs())
    }

    /// A line of some colour and width.
    pub(super) fn line(&self, colour: &str, width: f64) -> ShapeStyle {
        rgb(colour).stroke_width(self.length(width).unsigned_abs())
    }

    /// A text that is held at its top.
    pub(super) fn text(&self, font: Font, side: HPos) -> TextStyle<'static> {
        let style = font.description(self.scale * EM).color(&rgb(font.colour));
        style.pos(Pos::new(side, VPos::Top))
    }

    /// How far above its base line the top of a text is held.
    pub(super) fn top(&self, font: Font) -> i32 {
        self.length(BASE_BELOW_TOP * font.size)
    }

    /// How far below a tick the middle of its number is held, so that its digits, 0.73 high, stand in the middle.
    pub(super) fn sunk(&self, font: Font) -> i32 {
        self.length((0.365 - BASE_BELOW_MIDDLE) * font.size)
    }
}

/// Without characters that text of SVG may not have.
pub(super) fn clean(text: &str) -> String {
    text.chars().filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}')).collect()
}

/// Red, green and blue of `#rrggbb`.
pub(super) fn rgb(colour: &str) -> RGBColor {
    let part = |at: usize| colour.get(at..at + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok()).unwrap_or(0);
    RGBColor(part(1), part(3), part(5))
}
