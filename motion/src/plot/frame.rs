//! The frame of a panel: title, grid, numbers at the ticks.

use super::drawing::{Anchor, Drawing, Font, Stroke};
use super::scale::Scale;
use super::theme::Theme;

/// Of all pictures, in pixels of the SVG: as wide as a phone is, its text still readable there.
pub(super) const WIDTH: f64 = 600.0;
pub(super) const LEFT: f64 = 66.0;
pub(super) const RIGHT: f64 = WIDTH - 18.0;
pub(super) const TITLE: f64 = 19.0;
pub(super) const LABEL: f64 = 15.0;
pub(super) const NUMBER: f64 = 13.5;
pub(super) const NOTE: f64 = 12.5;
/// Above a frame, for its title.
pub(super) const HEAD: f64 = 32.0;

/// A panel to draw into.
pub(super) struct Frame<'a> {
    pub x: &'a Scale,
    pub y: &'a Scale,
    pub top: f64,
    pub bottom: f64,
    pub theme: &'a Theme,
}

impl Frame<'_> {
    /// Its title on the left and a note on the right.
    pub(super) fn title(&self, drawing: &mut Drawing, title: &str, note: &str) {
        let font = Font { size: LABEL, bold: true, colour: self.theme.text };
        drawing.text((LEFT, self.top - 9.0), Anchor::Start, font, title);
        if !note.is_empty() {
            let font = Font { size: NOTE, bold: false, colour: self.theme.muted };
            drawing.text((RIGHT, self.top - 9.0), Anchor::End, font, note);
        }
    }

    /// Lines at the ticks and the numbers on the left; those below only where asked.
    pub(super) fn grid(&self, drawing: &mut Drawing, ticks: (usize, usize), numbers_below: bool) {
        let thin = Stroke::solid(self.theme.grid, 1.0);
        let zero = Stroke::solid(self.theme.frame, 1.0);
        let font = Font { size: NUMBER, bold: false, colour: self.theme.muted };
        for tick in self.x.ticks(ticks.0) {
            drawing.line((tick.at, self.top), (tick.at, self.bottom), thin);
            if numbers_below {
                drawing.text((tick.at, self.bottom + 18.0), Anchor::Middle, font, &tick.label);
            }
        }
        for tick in self.y.ticks(ticks.1) {
            drawing.line((LEFT, tick.at), (RIGHT, tick.at), if tick.value == 0.0 { zero } else { thin });
            drawing.text((LEFT - 8.0, tick.at + 0.36 * NUMBER), Anchor::End, font, &tick.label);
        }
    }

    /// The frame itself, over the grid and under the curves.
    pub(super) fn border(&self, drawing: &mut Drawing) {
        let size = (RIGHT - LEFT, self.bottom - self.top);
        drawing.frame((LEFT, self.top), size, Stroke::solid(self.theme.frame, 1.0));
    }

    /// What the numbers below say.
    pub(super) fn below(&self, drawing: &mut Drawing, title: &str) {
        let font = Font { size: LABEL, bold: true, colour: self.theme.text };
        drawing.text(((LEFT + RIGHT) / 2.0, self.bottom + 39.0), Anchor::Middle, font, title);
    }
}

/// Below a frame that has numbers and their title there.
pub(super) const FOOT: f64 = 50.0;

/// The head of a picture: title, a line below it, and names beside their colours; how high it is.
pub(super) fn head(drawing: &mut Drawing, theme: &Theme, title: &str, note: &str, names: &[String]) -> f64 {
    let mut y = 10.0;
    if !title.is_empty() {
        y += TITLE;
        drawing.text((LEFT, y), Anchor::Start, Font { size: TITLE, bold: true, colour: theme.text }, title);
        y += 4.0;
    }
    if !note.is_empty() {
        y += NOTE + 4.0;
        drawing.text((LEFT, y), Anchor::Start, Font { size: NOTE, bold: false, colour: theme.muted }, note);
    }
    if names.len() > 1 {
        y = legend(drawing, theme, y + 20.0, names);
    }
    y
}

/// Names beside their colours, in as many lines as it takes.
fn legend(drawing: &mut Drawing, theme: &Theme, mut y: f64, names: &[String]) -> f64 {
    let mut x = LEFT;
    for (index, name) in names.iter().enumerate() {
        let room = 34.0 + super::drawing::width(name, LABEL);
        if x > LEFT && x + room > RIGHT {
            (x, y) = (LEFT, y + 22.0);
        }
        drawing.line((x, y - 5.0), (x + 26.0, y - 5.0), Stroke::solid(theme.curve(index), 3.5));
        drawing.text((x + 33.0, y), Anchor::Start, Font { size: LABEL, bold: false, colour: theme.text }, name);
        x += room + 18.0;
    }
    y
}
