//! The path: Y over X to one scale in mm, cuts by their colour, rapid moves thin, drilled holes as dots.

use super::colours::{self, Colouring, STEPS};
use super::gather::{Gathered, Point};
use crate::plot::frame::{Dot, Frame, INSIDE, Line};
use crate::plot::html::{PageCurve, PagePanel};
use crate::plot::scale::Scale;
use crate::plot::theme::Theme;
use crate::plot::unit::fixed;

/// How high the panel may be, in pixels.
const HEIGHTS: (f64, f64) = (150.0, 440.0);
/// Room around the path, in shares of its extent.
const ROOM: f64 = 0.06;
/// A path along one axis has at least so much room across it, in shares of its length.
const ACROSS: f64 = 0.15;
/// With more moves than this lines are thin and dots small.
const MANY: u64 = 2000;
/// Points nearer than so many pixels are drawn as one.
const NEAR: f64 = 0.4;
/// From one tick to the next, in pixels.
const TICKS: f64 = 38.0;
/// Values that differ by less than this share need no scale of colours.
const SAME: f64 = 1e-6;
/// The panel that says what the colours mean.
const BAR: f64 = 12.0;
/// Points of a page.
const MOST_OF_PAGE: usize = 60_000;

/// The path, and what its colours say.
pub(super) fn frames(gathered: &Gathered, colouring: Colouring, theme: &Theme) -> Vec<Frame> {
    let (view, range) = (View::of(gathered), range(gathered, colouring));
    let mut frame = empty("Path: Y over X (mm)", view.height, view.across, view.up, (view.height / TICKS) as usize);
    frame.below = Some("X (mm)".to_owned());
    frame.note = "to one scale; rapid moves thin".to_owned();
    let width = if gathered.moves > MANY { 1.0 } else { 2.0 };
    let rapid = Line { points: Vec::new(), colour: theme.frame, width: 0.8, is_dashed: false };
    frame.lines.extend(
        strokes(gathered, &view, |point| point.is_rapid.then_some(0))
            .map(|(points, _)| Line { points, ..rapid.clone() }),
    );
    let step = |point: &Point| (!point.is_rapid).then(|| colours::step(value(point, colouring), range));
    let palette = colours::of(theme);
    frame.lines.extend(strokes(gathered, &view, step).map(|(points, step)| Line {
        points,
        colour: palette[step],
        width,
        is_dashed: false,
    }));
    frame.dots = holes(gathered, &view, |point| palette[colours::step(value(point, colouring), range)]);
    if range.1 - range.0 <= SAME * range.1.abs().max(range.0.abs()) {
        let said = format!("{} {}, ", colouring.title(), fixed(range.1, 1));
        frame.note.insert_str(0, &said.to_lowercase());
        return vec![frame];
    }
    vec![frame, bar(colouring, range, theme)]
}

fn empty(title: &str, height: f64, across: (f64, f64), up: (f64, f64), ticks: usize) -> Frame {
    Frame {
        title: title.to_owned(),
        note: String::new(),
        height,
        x: Scale::linear(across, 7),
        y: Scale::linear(up, ticks),
        below: None,
        meetings: Vec::new(),
        lines: Vec::new(),
        dots: Vec::new(),
        arrows: Vec::new(),
        labels: Vec::new(),
    }
}

/// What the colours mean.
fn bar(colouring: Colouring, (low, high): (f64, f64), theme: &Theme) -> Frame {
    let mut frame = empty(colouring.title(), BAR, (low, high), (0.0, 1.0), 0);
    frame.note = "colour of cuts".to_owned();
    frame.below = Some(String::new());
    let at = |step: usize| low + (high - low) * step as f64 / STEPS as f64;
    frame.lines = colours::of(theme)
        .into_iter()
        .enumerate()
        .map(|(step, colour)| Line {
            points: vec![(at(step), 0.5), (at(step + 1), 0.5)],
            colour,
            width: BAR,
            is_dashed: false,
        })
        .collect();
    frame
}

fn value(point: &Point, colouring: Colouring) -> f64 {
    match colouring {
        Colouring::Speed => point.speed,
        Colouring::Feed => point.feed,
        Colouring::Height => point.at[2],
    }
}

/// Of the cuts; of all moves where nothing cuts.
fn range(gathered: &Gathered, colouring: Colouring) -> (f64, f64) {
    let of = |points: &mut dyn Iterator<Item = &Point>| {
        let values = points.map(|point| value(point, colouring)).filter(|value| value.is_finite());
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let cuts = of(&mut gathered.points.iter().filter(|point| !point.is_rapid && !point.is_start));
    if cuts.0 <= cuts.1 { cuts } else { of(&mut gathered.points.iter()) }
}

/// Which part of the plane is seen, in mm, and how high its panel is.
struct View {
    across: (f64, f64),
    up: (f64, f64),
    height: f64,
}

impl View {
    fn of(gathered: &Gathered) -> Self {
        let [x, y] = [0, 1].map(|axis| gathered.range(axis));
        let [wide, high] = [x, y].map(|(low, high)| high - low);
        let least = (wide.max(high) * ACROSS).max(1e-3);
        let [wide, high] = [wide, high].map(|extent| extent.max(least) * (1.0 + 2.0 * ROOM));
        let scale = (INSIDE / wide).min(HEIGHTS.1 / high);
        let height = (high * scale).clamp(HEIGHTS.0, HEIGHTS.1);
        let around = |(low, high): (f64, f64), extent: f64| {
            let middle = low + (high - low) / 2.0;
            (middle - extent / 2.0, middle + extent / 2.0)
        };
        Self { across: around(x, INSIDE / scale), up: around(y, height / scale), height }
    }

    /// Millimetres in a pixel.
    fn pixel(&self) -> f64 {
        (self.across.1 - self.across.0) / INSIDE
    }
}

/// A line, and its kind.
type Stroke = (Vec<(f64, f64)>, usize);

/// Lines of one kind each, without points that nobody tells apart.
fn strokes<'a>(
    gathered: &'a Gathered,
    view: &View,
    kind: impl Fn(&Point) -> Option<usize> + 'a,
) -> impl Iterator<Item = Stroke> + 'a {
    let near = NEAR * view.pixel();
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut before: Option<(&Point, Option<usize>)> = None;
    for point in &gathered.points {
        let (at, this) = ((point.at[0], point.at[1]), if point.is_start { None } else { kind(point) });
        if let (Some(this), Some((last, last_kind))) = (this, before) {
            match strokes.last_mut() {
                Some((points, of)) if last_kind == Some(this) && *of == this => {
                    let end = points[points.len() - 1];
                    if goes_on(points, at) {
                        points.pop();
                        points.push(at);
                    } else if (end.0 - at.0).hypot(end.1 - at.1) >= near {
                        points.push(at);
                    }
                }
                _ => strokes.push((vec![(last.at[0], last.at[1]), at], this)),
            }
        }
        before = Some((point, this));
    }
    // A point is none of a line: holes are drawn as dots.
    strokes.into_iter().filter(|(points, _)| points.iter().any(|point| *point != points[0]))
}

/// Whether a line goes straight on to a point.
fn goes_on(points: &[(f64, f64)], to: (f64, f64)) -> bool {
    let [.., before, end] = points else { return false };
    let (came, goes) = ((end.0 - before.0, end.1 - before.1), (to.0 - end.0, to.1 - end.1));
    let (cross, dot) = (came.0 * goes.1 - came.1 * goes.0, came.0 * goes.0 + came.1 * goes.1);
    // So strict that what is left out one after another adds up to nothing.
    dot > 0.0 && cross.abs() <= 1e-9 * dot
}

/// Where the tool goes down at feed, one dot a pixel.
fn holes(gathered: &Gathered, view: &View, colour: impl Fn(&Point) -> &'static str) -> Vec<Dot> {
    let radius = if gathered.moves > MANY { 0.7 } else { 1.8 };
    let mut seen = std::collections::HashSet::new();
    let mut dots = Vec::new();
    for pair in gathered.points.windows(2) {
        let (from, to) = (&pair[0], &pair[1]);
        let is_down = from.at[..2] == to.at[..2] && to.at[2] < from.at[2] && !to.is_rapid && !to.is_start;
        let place = [0, 1].map(|axis| (to.at[axis] / (2.0 * view.pixel())).round() as i64);
        if is_down && seen.insert(place) {
            let ring = (colour(to), 1.0);
            dots.push(Dot { at: (to.at[0], to.at[1]), radius, ring, fill: ring.0 });
        }
    }
    dots
}

/// The path of a page over its unit of time: cuts, and rapid moves thin.
pub(super) fn panel(gathered: &Gathered, unit: f64) -> PagePanel {
    let kept = kept(&gathered.points);
    PagePanel {
        title: "Path: Y (mm) over X".to_owned(),
        x_title: "X (mm)".to_owned(),
        x_name: "X".to_owned(),
        x_unit: "mm".to_owned(),
        y_unit: "mm".to_owned(),
        equal: true,
        curves: vec![moves(&kept, "cut", 0, unit), moves(&kept, "rapid", 1, unit)],
        ..PagePanel::default()
    }
}

/// So few points that a page can hold them; the ends of what cuts and of what does not are among them.
fn kept(points: &[Point]) -> Vec<Point> {
    let every = points.len().div_ceil(MOST_OF_PAGE).max(1);
    let is_end = |index: usize| {
        let next = points.get(index + 1);
        next.is_none_or(|next| next.is_start || next.is_rapid != points[index].is_rapid)
    };
    let is_kept = |index: &usize| index.is_multiple_of(every) || points[*index].is_start || is_end(*index);
    (0..points.len()).filter(is_kept).map(|index| points[index]).collect()
}

/// The moves of one kind: each run of them begins where the move before ended.
fn moves(points: &[Point], kind: &str, colour: i32, unit: f64) -> PageCurve {
    let is_rapid = colour != 0;
    let mut curve =
        PageCurve { name: "Y".to_owned(), colour, kind: kind.to_owned(), thin: is_rapid, ..PageCurve::default() };
    let mut is_going = false;
    for pair in points.windows(2) {
        let is_one = !pair[1].is_start && pair[1].is_rapid == is_rapid;
        if is_one && !is_going {
            curve.starts.push(curve.x.len());
            push(&mut curve, &pair[0], unit);
        }
        if is_one {
            push(&mut curve, &pair[1], unit);
        }
        is_going = is_one;
    }
    curve
}

fn push(curve: &mut PageCurve, point: &Point, unit: f64) {
    curve.x.push(point.at[0]);
    curve.y.push(point.at[1]);
    curve.when.push(point.time / unit);
}
