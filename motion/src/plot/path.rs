//! The path: the second axis over the first.

use plotters::style::text_anchor::HPos;

use super::canvas::Font;
use super::error::PlotError;
use super::frame::{Arrow, Dot, Frame, INSIDE, Label, Line};
use super::picture::{Mark, OFF, Picture};
use super::scale::{Scale, widened};
use super::unit::{Unit, axis_unit};
use crate::extremes::Quantity;
use crate::motion::Axis;

/// How high the panel may be, in pixels.
const HEIGHTS: (f64, f64) = (150.0, 420.0);

/// A path less high than this share of its width is stretched.
const FLAT: f64 = 0.2;

/// Pixels from one tick to the next.
const TICKS: f64 = 38.0;

/// Points closer than so many pixels are drawn as one.
const NEAR: f64 = 0.3;

/// Pixels along the path from one arrow to the next.
const ARROWS: f64 = 150.0;

/// Size of the names of marks.
const NAME: f64 = 14.5;

/// The path in the units of a panel.
pub(super) struct Scaled {
    pub title: String,
    pub below: String,
    pub names: [String; 2],
    pub units: [Unit; 2],
    pub points: Vec<(f64, f64)>,
    pub is_stretched: bool,
    layout: Layout,
}

/// The path of the two axes that it is drawn for.
pub(super) fn scaled(picture: &Picture) -> Scaled {
    let [first, second] = picture.plane().map(|index| &picture.motion.axes()[index]);
    let path = points(first, second, picture.motion.times());
    let (across, up) = ranges(&path, &picture.marks);
    let units = units(across, up);
    let (across, up) = (padded(across, &units[0]), padded(up, &units[1]));
    let layout = Layout::new(across, up, (units[0].size, units[1].size));
    let up_unit = if layout.is_stretched { format!(" ({})", units[1].name) } else { String::new() };
    Scaled {
        title: format!("Path: {}{up_unit} over {}", second.name, first.name),
        below: format!("{} ({})", first.name, units[0].name),
        names: [first.name.clone(), second.name.clone()],
        points: path.iter().map(|(x, y)| (x / units[0].size, y / units[1].size)).collect(),
        is_stretched: layout.is_stretched,
        units,
        layout,
    }
}

/// The panel.
pub(super) fn frame(picture: &Picture) -> Result<Frame, PlotError> {
    let Scaled { title, below, units, points, layout, .. } = scaled(picture);
    let scaled = |(x, y): &(f64, f64)| (x / units[0].size, y / units[1].size);
    let path = layout.visible(&points);
    let mut frame = Frame {
        title,
        note: if layout.is_stretched { "not to one scale".to_owned() } else { String::new() },
        height: layout.height,
        x: Scale::linear(layout.across, 6),
        y: Scale::linear(layout.up, (layout.height / TICKS) as usize),
        below: Some(below),
        meetings: Vec::new(),
        lines: Vec::new(),
        dots: if picture.marks.is_empty() { ends(picture, &path) } else { Vec::new() },
        arrows: arrows(&layout, &path, picture.theme.text),
        labels: Vec::new(),
    };
    for mark in &picture.marks {
        let at = scaled(&(mark.x, mark.y));
        frame.dots.push(Dot { at, radius: 4.5, ring: (picture.theme.curve(1), 2.4), fill: picture.theme.background });
        frame.labels.push(layout.label(picture, at, &mark.name, &path)?);
    }
    frame.lines.push(Line { points: path, colour: picture.theme.text, width: 2.2, is_dashed: false });
    Ok(frame)
}

/// Of both axes; the same where they are drawn to one scale.
fn units(across: (f64, f64), up: (f64, f64)) -> [Unit; 2] {
    let largest = [across, up].map(|(low, high)| high.max(-low));
    let share = (up.1 - up.0) / (across.1 - across.0);
    match (FLAT..=1.0 / FLAT).contains(&share) {
        true => largest.map(|_| axis_unit("m", largest[0].max(largest[1]))),
        false => largest.map(|largest| axis_unit("m", largest)),
    }
}

/// Where both axes are, at all times that one of them needs to be seen as it is, and at those where segments meet.
fn points(first: &Axis, second: &Axis, mut times: Vec<f64>) -> Vec<(f64, f64)> {
    for axis in [first, second] {
        times.extend(Quantity::Position.points(&axis.profile, fine(axis)).into_iter().map(|(time, _)| time));
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    times.iter().map(|time| (first.profile.at(*time).position, second.profile.at(*time).position)).collect()
}

/// By how much an axis may be off in a picture of the path, in m.
fn fine(axis: &Axis) -> f64 {
    let extremes = axis.profile.extremes(Quantity::Position);
    let extent = extremes.largest.value - extremes.least.value;
    if extent > 0.0 { extent * OFF / INSIDE } else { f64::INFINITY }
}

fn ranges(path: &[(f64, f64)], marks: &[Mark]) -> ((f64, f64), (f64, f64)) {
    let points = path.iter().copied().chain(marks.iter().map(|mark| (mark.x, mark.y)));
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    let grow = |range: (f64, f64), value: f64| (range.0.min(value), range.1.max(value));
    points.fold((start, start), |(across, up), (x, y)| (grow(across, x), grow(up, y)))
}

fn padded((low, high): (f64, f64), unit: &Unit) -> (f64, f64) {
    widened((low / unit.size, high / unit.size), 0.08, 0.08)
}

/// Ranges in units of the axes, and the height of the panel.
struct Layout {
    across: (f64, f64),
    up: (f64, f64),
    height: f64,
    is_stretched: bool,
}

impl Layout {
    /// To one scale where that leaves something to see.
    fn new(across: (f64, f64), up: (f64, f64), units: (f64, f64)) -> Self {
        let (wide, high) = ((across.1 - across.0) * units.0, (up.1 - up.0) * units.1);
        let share = high / wide;
        if !(FLAT..=1.0 / FLAT).contains(&share) {
            return Self { across, up, height: 220.0, is_stretched: true };
        }
        let height = (INSIDE * share).clamp(HEIGHTS.0, HEIGHTS.1);
        let room = high * INSIDE / height / wide;
        let grown = |(low, high): (f64, f64), by: f64| {
            let more = (high - low) * (by - 1.0) / 2.0;
            (low - more, high + more)
        };
        Self { across: grown(across, room.max(1.0)), up: grown(up, (1.0 / room).max(1.0)), height, is_stretched: false }
    }

    /// Pixels of the SVG right of the left end and above the lower one.
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let share = |value: f64, (low, high): (f64, f64)| (value - low) / (high - low);
        (INSIDE * share(x, self.across), self.height * share(y, self.up))
    }

    /// The points without those that nobody tells from the one before.
    fn visible(&self, path: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let mut kept: Vec<(f64, f64)> = Vec::new();
        for (index, point) in path.iter().enumerate() {
            let (x, y) = self.place(*point);
            let near = |(a, b): (f64, f64)| (x - a).hypot(y - b) < NEAR;
            if index + 1 == path.len() || !kept.last().is_some_and(|last| near(self.place(*last))) {
                kept.push(*point);
            }
        }
        kept
    }

    /// A name in the corner beside its point that is farthest from the path.
    fn label(&self, picture: &Picture, at: (f64, f64), name: &str, path: &[(f64, f64)]) -> Result<Label, PlotError> {
        let font = Font { size: NAME, bold: true, colour: picture.theme.text };
        let ((x, y), wide) = (self.place(at), font.width(name)?);
        let middle = |(right, up): &(f64, f64)| (x + right * (7.0 + wide / 2.0), y + up * 13.0);
        let free = |corner: &(f64, f64)| {
            let middle = middle(corner);
            path.windows(2)
                .map(|pair| distance(middle, self.place(pair[0]), self.place(pair[1])))
                .fold(f64::INFINITY, f64::min)
        };
        let corners = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        let inside = |corner: &&(f64, f64)| {
            let (x, y) = middle(corner);
            (wide / 2.0..=INSIDE - wide / 2.0).contains(&x) && (NAME / 2.0..=self.height - NAME / 2.0).contains(&y)
        };
        let best = corners.iter().filter(inside).max_by(|a, b| free(a).total_cmp(&free(b))).unwrap_or(&corners[0]);
        let offset = (best.0 * (7.0 + wide / 2.0), 0.36 * NAME - best.1 * 13.0);
        Ok(Label { at, offset, side: HPos::Center, font, text: name.to_owned() })
    }
}

/// Of a point from a straight line between two others.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (along, off) = ((to.0 - from.0, to.1 - from.1), (point.0 - from.0, point.1 - from.1));
    let length = along.0.hypot(along.1).max(f64::MIN_POSITIVE);
    let share = ((off.0 / length) * (along.0 / length) + (off.1 / length) * (along.1 / length)).clamp(0.0, 1.0);
    (off.0 - share * along.0).hypot(off.1 - share * along.1)
}

/// Where it goes: the heads of arrows, one on so many pixels of the path, in the middle of what is straight.
fn arrows(layout: &Layout, path: &[(f64, f64)], colour: &'static str) -> Vec<Arrow> {
    let mut found = Vec::new();
    let mut run = ARROWS / 2.0;
    for pair in path.windows(2) {
        let [(x0, y0), (x1, y1)] = [layout.place(pair[0]), layout.place(pair[1])];
        let length = (x1 - x0).hypot(y1 - y0);
        run += length;
        if run < ARROWS || length <= NEAR {
            continue;
        }
        run = 0.0;
        let at = ((pair[0].0 + pair[1].0) / 2.0, (pair[0].1 + pair[1].1) / 2.0);
        found.push(Arrow { at, step: ((x1 - x0) / length, (y0 - y1) / length), colour });
    }
    found
}

/// A ring where the path begins and a dot where it ends.
fn ends(picture: &Picture, path: &[(f64, f64)]) -> Vec<Dot> {
    let theme = &picture.theme;
    let dot = |(at, fill): (&(f64, f64), _)| Dot { at: *at, radius: 5.0, ring: (theme.text, 2.0), fill };
    path.first().zip(Some(theme.background)).into_iter().chain(path.last().zip(Some(theme.text))).map(dot).collect()
}
