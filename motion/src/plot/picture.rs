//! The picture of a motion: panels below each other, those over time on one time axis.

use std::path::Path;

use super::canvas::Font;
use super::curve::thinned;
use super::drawing::Drawing;
use super::error::PlotError;
use super::frame::{Frame, INSIDE, LABEL, Line, NOTE};
use super::limit::{self, Limit, limits};
use super::path;
use super::scale::{Scale, widened};
use super::sheet::Sheet;
use super::theme::Theme;
use super::unit::{Unit, axis_unit};
use crate::extremes::Quantity;
use crate::motion::{Axis, Motion};

/// How high a panel over time is, in pixels.
const HEIGHT: f64 = 124.0;

/// The axes share a panel as long as the whole panel is at most this many times as high as the curve of each axis; beyond
/// that the smallest curve could not be read.
const COMPARABLE: f64 = 12.0;

/// A curve is drawn by straight lines, which are at most this far from it, in pixels of the SVG.
pub(super) const OFF: f64 = 0.02;

/// What is narrower than this, in pixels of the SVG, cannot be told apart.
const COLUMN: f64 = 0.5;

/// If there are more points than this at which segments meet, none is marked.
const MOST_MEETINGS: usize = 40;

/// What a panel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Panel {
    /// The second axis over the first.
    Path,
    /// Over time.
    Position,
    /// Over time, with its limits.
    Velocity,
    /// Over time, with its limits.
    Acceleration,
    /// Over time, with its limits.
    Jerk,
}

/// A point to mark in the path.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Of the first axis, in m.
    pub x: f64,
    /// Of the second axis, in m.
    pub y: f64,
    /// What stands beside it.
    pub name: String,
}

/// The picture of a motion.
#[derive(Debug, Clone)]
pub struct Picture<'a> {
    pub(super) motion: &'a Motion,
    pub(super) title: String,
    pub(super) note: String,
    panels: Vec<Panel>,
    pub(super) marks: Vec<Mark>,
    pub(super) theme: Theme,
    /// Those that move: one that never does would take a colour, and lie over the others.
    pub(super) axes: Vec<usize>,
    is_wide: bool,
}

/// A panel over time: one quantity of one or more axes.
pub(super) struct Curves {
    pub quantity: Quantity,
    pub axes: Vec<usize>,
}

impl<'a> Picture<'a> {
    /// All panels of the axes that move, the path where there are two of them or more, for paper.
    #[must_use]
    pub fn new(motion: &'a Motion) -> Self {
        let axes = moving(motion);
        let mut panels = vec![Panel::Position, Panel::Velocity, Panel::Acceleration, Panel::Jerk];
        if axes.len() > 1 {
            panels.insert(0, Panel::Path);
        }
        Self {
            motion,
            title: String::new(),
            note: String::new(),
            panels,
            marks: Vec::new(),
            theme: Theme::LIGHT,
            axes,
            is_wide: false,
        }
    }

    /// With a title.
    #[must_use]
    pub fn title(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// With a line below the title.
    #[must_use]
    pub fn note(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }

    /// With these panels, in this order.
    #[must_use]
    pub fn panels(self, panels: &[Panel]) -> Self {
        Self { panels: panels.to_vec(), ..self }
    }

    /// With these points in the path.
    #[must_use]
    pub fn marks(self, marks: Vec<Mark>) -> Self {
        Self { marks, ..self }
    }

    /// With its panels in two columns, for a page that is wide enough.
    #[must_use]
    pub fn wide(self, is_wide: bool) -> Self {
        Self { is_wide, ..self }
    }

    /// In these colours.
    #[must_use]
    pub fn theme(self, theme: Theme) -> Self {
        Self { theme, ..self }
    }

    /// Draws it.
    ///
    /// # Errors
    ///
    /// The motion takes no time or has no axes, or no panel is asked for.
    pub fn draw(&self) -> Result<Drawing, PlotError> {
        self.check()?;
        let mut sheet = Sheet::new(&self.title, &self.note, self.theme, &self.names())?;
        let time = axis_unit("s", self.motion.duration());
        let over_time = self.over_time();
        sheet.is_wide = self.is_wide;
        for panel in &self.panels {
            if *panel == Panel::Path {
                sheet.frames.push(path::frame(self)?);
            }
            for curves in over_time.iter().filter(|curves| curves.is_of(*panel)) {
                sheet.frames.push(self.frame(curves, &time)?);
            }
        }
        for column in sheet.columns() {
            // the last panel of a column has the numbers of the time for all above it
            if let Some(frame) = sheet.frames[column].last_mut().filter(|frame| frame.below.is_none()) {
                frame.below = Some(format!("Time ({})", time.name));
            }
        }
        Drawing::new(sheet, if self.title.is_empty() { "Motion" } else { &self.title })
    }

    /// Draws it into a file that ends in `.svg` or `.png`, or writes its page into one that ends in `.html`, whole or not at
    /// all.
    pub fn save(&self, path: &Path) -> Result<(), PlotError> {
        let is_page = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html"));
        if is_page { self.page()?.save(path) } else { self.draw()?.save(path) }
    }

    /// Of the axes that are shown.
    pub(super) fn names(&self) -> Vec<String> {
        self.axes.iter().map(|index| self.motion.axes()[*index].name.clone()).collect()
    }

    /// Of an axis, counted among those that are shown.
    pub(super) fn colour(&self, index: usize) -> i32 {
        self.axes.iter().position(|shown| *shown == index).unwrap_or(0) as i32
    }

    /// The two axes of the path: the first two that move, if there are as many.
    pub(super) fn plane(&self) -> [usize; 2] {
        match self.axes.as_slice() {
            [first, second, ..] => [*first, *second],
            _ => [0, 1],
        }
    }

    pub(super) fn has_path(&self) -> bool {
        self.panels.contains(&Panel::Path)
    }

    pub(super) fn check(&self) -> Result<(), PlotError> {
        let what = match (self.motion.axes().len(), self.panels.as_slice()) {
            (0, _) => "the motion has no axes",
            (_, []) => "no panel is asked for",
            (1, panels) if panels.contains(&Panel::Path) => "a path needs two axes",
            _ if self.motion.duration() == 0.0 => "the motion takes no time",
            _ => return Ok(()),
        };
        Err(PlotError::Empty { what })
    }

    /// The panels over time, each quantity in one, or in one an axis.
    pub(super) fn over_time(&self) -> Vec<Curves> {
        let quantity = |panel: &Panel| match panel {
            Panel::Path => None,
            Panel::Position => Some(Quantity::Position),
            Panel::Velocity => Some(Quantity::Velocity),
            Panel::Acceleration => Some(Quantity::Acceleration),
            Panel::Jerk => Some(Quantity::Jerk),
        };
        let split = |quantity| match self.share_a_panel(quantity) {
            true => vec![Curves { quantity, axes: self.axes.clone() }],
            false => self.axes.iter().map(|index| Curves { quantity, axes: vec![*index] }).collect(),
        };
        self.panels.iter().filter_map(quantity).flat_map(split).collect()
    }

    fn share_a_panel(&self, quantity: Quantity) -> bool {
        let axes = self.axes.iter().map(|index| &self.motion.axes()[*index]);
        let ranges: Vec<(f64, f64)> = axes.map(|axis| range(axis, quantity)).collect();
        let extents = ranges.iter().map(|(low, high)| high - low).filter(|extent| *extent > 0.0);
        let (low, high) = union(&ranges);
        high - low <= COMPARABLE * extents.fold(f64::INFINITY, f64::min)
    }

    fn frame(&self, curves: &Curves, time: &Unit) -> Result<Frame, PlotError> {
        let view = View::new(self, curves);
        let (View { limits, range, unit, .. }, end) = (&view, self.motion.duration() / time.size);
        let title = self.name(curves, unit);
        let heading = Font { size: LABEL, bold: true, colour: self.theme.text };
        let room = INSIDE - heading.width(&title)? - LABEL;
        let mut frame = Frame {
            note: limit::note(limits, *range, unit, (Font { size: NOTE, bold: false, ..heading }, room))?,
            title,
            height: HEIGHT,
            x: Scale::linear((0.0, end), 6),
            y: Scale::linear(view.shown, 5),
            below: None,
            meetings: self.meetings(time),
            lines: Vec::new(),
            dots: Vec::new(),
            arrows: Vec::new(),
            labels: Vec::new(),
        };
        limit::draw(&mut frame, limits, unit, *range, end)?;
        frame.lines.extend(curves.axes.iter().map(|index| self.curve(*index, curves.quantity, &view, time)));
        Ok(frame)
    }

    /// What an axis does, in the units of a panel.
    fn curve(&self, index: usize, quantity: Quantity, view: &View, time: &Unit) -> Line {
        let (axis, end) = (&self.motion.axes()[index], self.motion.duration());
        let pixel = (view.shown.1 - view.shown.0) * view.unit.size / HEIGHT;
        let mut points = quantity.points(&axis.profile, OFF * pixel);
        points.extend(rest(axis, quantity, end).into_iter().flatten());
        let points = thinned(points, COLUMN * end / INSIDE).into_iter();
        let points = points.map(|(at, value)| (at / time.size, value / view.unit.size)).collect();
        Line { points, colour: self.theme.curve(self.colour(index) as usize), width: 2.4, is_dashed: false }
    }

    pub(super) fn name(&self, curves: &Curves, unit: &Unit) -> String {
        let quantity = curves.quantity.title();
        match curves.axes.as_slice() {
            [axis] if self.axes.len() > 1 => {
                format!("{quantity} of {} ({})", self.motion.axes()[*axis].name, unit.name)
            }
            _ => format!("{quantity} ({})", unit.name),
        }
    }

    /// Where segments meet, if that can be told apart.
    fn meetings(&self, time: &Unit) -> Vec<f64> {
        let end = self.motion.duration();
        let inside = |at: &f64| *at > 0.0 && *at < end;
        let mut times: Vec<f64> = self.motion.times().into_iter().filter(inside).map(|at| at / time.size).collect();
        times.dedup_by(|later, earlier| *later - *earlier < COLUMN * end / time.size / INSIDE);
        if times.len() <= MOST_MEETINGS { times } else { Vec::new() }
    }
}

impl Curves {
    fn is_of(&self, panel: Panel) -> bool {
        let own = match self.quantity {
            Quantity::Position => Panel::Position,
            Quantity::Velocity => Panel::Velocity,
            Quantity::Acceleration => Panel::Acceleration,
            Quantity::Jerk => Panel::Jerk,
        };
        panel == own
    }
}

/// What a panel has to show.
pub(super) struct View {
    pub limits: Vec<Limit>,
    /// Of the values, in SI units.
    pub range: (f64, f64),
    pub unit: Unit,
    /// From the lower end of the panel to the upper one, in its unit.
    pub shown: (f64, f64),
}

impl View {
    pub(super) fn new(picture: &Picture, curves: &Curves) -> Self {
        let shown = |index: &usize| (picture.colour(*index) as usize, &picture.motion.axes()[*index]);
        let axes: Vec<(usize, &Axis)> = curves.axes.iter().map(shown).collect();
        let limits = limits(curves.quantity, &axes, &picture.theme);
        let range = union(&axes.iter().map(|(_, axis)| range(axis, curves.quantity)).collect::<Vec<_>>());
        let shown = with_limits(range, &limits);
        let unit = axis_unit(curves.quantity.unit(), shown.1.max(-shown.0));
        let shown = frame_range(shown, unit.size, &limits, range);
        Self { limits, range, unit, shown }
    }
}

/// The axes that move; all of them, if none does.
fn moving(motion: &Motion) -> Vec<usize> {
    let moves = |axis: &Axis| {
        let (low, high) = range(axis, Quantity::Position);
        low < high
    };
    let found: Vec<usize> = (0..motion.axes().len()).filter(|index| moves(&motion.axes()[*index])).collect();
    if found.is_empty() { (0..motion.axes().len()).collect() } else { found }
}

/// An axis that ends before the others stays where it is.
pub(super) fn rest(axis: &Axis, quantity: Quantity, end: f64) -> Option<[(f64, f64); 2]> {
    let (from, position) = (axis.profile.duration(), axis.profile.end().position);
    let value = if quantity == Quantity::Position { position } else { 0.0 };
    (from < end).then_some([(from, value), (end, value)])
}

fn with_limits((low, high): (f64, f64), limits: &[Limit]) -> (f64, f64) {
    limits.iter().fold((low, high), |(below, above), limit| {
        let [lower, upper] = limit.sides((low, high));
        (if lower { below.min(-limit.value) } else { below }, if upper { above.max(limit.value) } else { above })
    })
}

/// With room around, more where the text of a limit stands.
fn frame_range(shown: (f64, f64), unit: f64, limits: &[Limit], range: (f64, f64)) -> (f64, f64) {
    let sides: Vec<[bool; 2]> = limits.iter().map(|limit| limit.sides(range)).collect();
    let above = sides.iter().any(|side| side[1]);
    let below = sides.contains(&[true, false]);
    let room = |text: bool| if text { 0.18 } else { 0.08 };
    widened((shown.0 / unit, shown.1 / unit), room(below), room(above))
}

fn range(axis: &Axis, quantity: Quantity) -> (f64, f64) {
    let extremes = axis.profile.extremes(quantity);
    (extremes.least.value, extremes.largest.value)
}

fn union(ranges: &[(f64, f64)]) -> (f64, f64) {
    ranges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), range| (low.min(range.0), high.max(range.1)))
}
