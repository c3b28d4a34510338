//! The path: the second axis over the first.

use super::drawing::{Anchor, BOLD, Drawing, Font, Stroke, point, width};
use super::frame::{Frame, HEAD, LEFT, RIGHT};
use super::picture::{Mark, Picture};
use super::quantity::Piece;
use super::scale::{Scale, widened};
use super::unit::{Unit, axis_unit};
use crate::extremes::Quantity;
use crate::motion::Axis;

/// How high the panel may be, in pixels.
const HEIGHTS: (f64, f64) = (150.0, 420.0);

/// A path less high than this share of its width is stretched.
const FLAT: f64 = 0.2;

/// A stretch of the path: both axes over the same time.
type Stretch = (Piece, Piece);

/// Draws the panel from `top` on; where it ends.
pub(super) fn draw(picture: &Picture, drawing: &mut Drawing, top: f64) -> f64 {
    let [first, second] = [0, 1].map(|index| &picture.motion.axes()[index]);
    let path = stretches(first, second, picture.motion.duration());
    let (across, up) = ranges(&path, &picture.marks);
    let units = units(across, up);
    let (across, up) = (padded(across, &units[0]), padded(up, &units[1]));
    let layout = Layout::new(across, up, (units[0].size, units[1].size));
    let bottom = top + layout.height;
    let x = Scale::linear(layout.across, (LEFT, RIGHT));
    let y = Scale::linear(layout.up, (bottom, top));
    let frame = Frame { x: &x, y: &y, top, bottom, theme: &picture.theme };
    frame.grid(drawing, (6, (layout.height / 38.0) as usize), true);
    frame.border(drawing);
    let place = |at: (f64, f64)| (x.at(at.0 / units[0].size), y.at(at.1 / units[1].size));
    drawing.path(path_text(&path, &place), Stroke::solid(picture.theme.text, 2.2));
    ends(picture, drawing, &path, &place);
    marks(picture, drawing, &path, &place);
    let note = if layout.is_stretched { "not to one scale" } else { "" };
    let up_unit = if layout.is_stretched { format!(" ({})", units[1].name) } else { String::new() };
    frame.title(drawing, &format!("Path: {}{up_unit} over {}", second.name, first.name), note);
    frame.below(drawing, &format!("{} ({})", first.name, units[0].name));
    bottom
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

/// Both axes, cut wherever a segment of one of them begins.
fn stretches(first: &Axis, second: &Axis, duration: f64) -> Vec<Stretch> {
    let mut times: Vec<f64> = [first, second].iter().flat_map(|axis| axis.profile.times()).copied().collect();
    times.push(duration);
    times.sort_by(f64::total_cmp);
    times.dedup();
    let pieces = [first, second].map(|axis| Quantity::Position.pieces(&axis.profile, fine(axis)));
    let mut cut = times;
    cut.extend(pieces.iter().flatten().map(|piece| piece.from));
    cut.sort_by(f64::total_cmp);
    cut.dedup();
    cut.windows(2).map(|pair| (stretch(first, pair[0], pair[1]), stretch(second, pair[0], pair[1]))).collect()
}

/// What no picture of the path can show, in m.
fn fine(axis: &Axis) -> f64 {
    let positions = axis.profile.segments().iter().flat_map(|segment| [segment.start.position, segment.end.position]);
    let (low, high) = positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    if high > low { (high - low) * 2e-5 } else { f64::INFINITY }
}

fn stretch(axis: &Axis, from: f64, to: f64) -> Piece {
    let profile = &axis.profile;
    if from >= profile.duration() {
        let position = profile.end().position;
        return Piece { from, to, values: (position, position), slopes: (0.0, 0.0) };
    }
    // Within one segment: the end as the segment has it that begins the stretch.
    let index = profile.times().partition_point(|start| *start <= from) - 1;
    let segment = &profile.segments()[index];
    let at = |time: f64| segment.at((time - profile.times()[index]).clamp(0.0, segment.duration));
    let (begin, end) = (at(from), at(to));
    Piece { from, to, values: (begin.position, end.position), slopes: (begin.velocity, end.velocity) }
}

fn ranges(path: &[Stretch], marks: &[Mark]) -> ((f64, f64), (f64, f64)) {
    let points =
        path.iter().flat_map(|(x, y)| (0..=16).map(move |k| (x.at(f64::from(k) / 16.0), y.at(f64::from(k) / 16.0))));
    let points = points.chain(marks.iter().map(|mark| (mark.x, mark.y)));
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
        let height = ((RIGHT - LEFT) * share).clamp(HEIGHTS.0, HEIGHTS.1);
        let room = high * (RIGHT - LEFT) / height / wide;
        let grown = |(low, high): (f64, f64), by: f64| {
            let more = (high - low) * (by - 1.0) / 2.0;
            (low - more, high + more)
        };
        Self { across: grown(across, room.max(1.0)), up: grown(up, (1.0 / room).max(1.0)), height, is_stretched: false }
    }
}

/// Cubics over the same time make a Bezier curve; steps too small to see are left out.
fn path_text(path: &[Stretch], place: &impl Fn((f64, f64)) -> (f64, f64)) -> String {
    let mut text = String::new();
    let mut at: Option<(f64, f64)> = None;
    for (x, y) in path {
        let third = (x.to - x.from) / 3.0;
        let controls = [
            place((x.values.0 + third * x.slopes.0, y.values.0 + third * y.slopes.0)),
            place((x.values.1 - third * x.slopes.1, y.values.1 - third * y.slopes.1)),
        ];
        let (start, end) = (place((x.values.0, y.values.0)), place((x.values.1, y.values.1)));
        if at.is_none() {
            text.push_str(&format!("M{}", point(start)));
        }
        let from = at.unwrap_or(start);
        let near = |other: (f64, f64)| (other.0 - from.0).abs() < 0.3 && (other.1 - from.1).abs() < 0.3;
        if at.is_some() && near(end) && controls.iter().all(|control| near(*control)) {
            continue;
        }
        match is_straight(start, controls, end) {
            true => text.push_str(&format!("L{}", point(end))),
            false => text.push_str(&format!("C{} {} {}", point(controls[0]), point(controls[1]), point(end))),
        }
        at = Some(end);
    }
    text
}

/// Whether the control points lie on the line between the ends.
fn is_straight(start: (f64, f64), controls: [(f64, f64); 2], end: (f64, f64)) -> bool {
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let length = dx.hypot(dy).max(1e-9);
    let off = |(x, y): (f64, f64)| ((x - start.0) * dy - (y - start.1) * dx).abs() / length;
    let along = |(x, y): (f64, f64)| ((x - start.0) * dx + (y - start.1) * dy) / (length * length);
    controls.iter().all(|control| off(*control) < 0.01 && (-1e-3..=1.001).contains(&along(*control)))
}

/// A ring where the path begins and a dot where it ends.
fn ends(picture: &Picture, drawing: &mut Drawing, path: &[Stretch], place: &impl Fn((f64, f64)) -> (f64, f64)) {
    let (theme, stroke) = (&picture.theme, Stroke::solid(picture.theme.text, 2.0));
    if let (Some((x, y)), true) = (path.first(), picture.marks.is_empty()) {
        drawing.dot(place((x.values.0, y.values.0)), 5.0, theme.background, stroke);
    }
    if let (Some((x, y)), true) = (path.last(), picture.marks.is_empty()) {
        drawing.dot(place((x.values.1, y.values.1)), 5.0, theme.text, stroke);
    }
}

/// Points with their names, each in the corner beside its point that is farthest from the path.
fn marks(picture: &Picture, drawing: &mut Drawing, path: &[Stretch], place: &impl Fn((f64, f64)) -> (f64, f64)) {
    let theme = &picture.theme;
    let font = Font { size: HEAD / 2.2, bold: true, colour: theme.text };
    let shares = || (0..=16).map(|index| f64::from(index) / 16.0);
    let points = path.iter().flat_map(|(x, y)| shares().map(|share| place((x.at(share), y.at(share)))));
    let points: Vec<(f64, f64)> = if picture.marks.is_empty() { Vec::new() } else { points.collect() };
    for mark in &picture.marks {
        let (x, y) = place((mark.x, mark.y));
        let wide = width(&mark.name, font.size) * BOLD;
        let middle = |(right, down): &(f64, f64)| (x + right * (7.0 + wide / 2.0), y + down * 13.0);
        let free = |corner: &(f64, f64)| {
            let (a, b) = middle(corner);
            points.iter().map(|(x, y)| (x - a).hypot(y - b)).fold(f64::INFINITY, f64::min)
        };
        let corners = [(1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let inside = |corner: &&(f64, f64)| (LEFT..=RIGHT).contains(&(middle(corner).0 + corner.0 * wide / 2.0));
        let best = corners.iter().filter(inside).max_by(|a, b| free(a).total_cmp(&free(b))).unwrap_or(&corners[0]);
        let (at, base) = middle(best);
        drawing.dot((x, y), 4.5, theme.background, Stroke::solid(theme.curve(1), 2.4));
        drawing.text((at, base + 0.36 * font.size), Anchor::Middle, font, &mark.name);
    }
}
