//! Gathers what a picture shows of the moves of a job.

use super::ramps::Ramps;
use super::series::Series;
use crate::plan::milling::{Path, Row};

/// Points of the path that are held before those that nobody tells apart are left out.
const MOST: usize = 400_000;

/// Parts of the largest extent of the path within which points are first told apart; twice as coarse each time that is not
/// coarse enough.
const PARTS: f64 = 4000.0;

/// More moves than this: each has fewer points over time.
const MANY: u64 = 5000;

/// An arc is drawn by straight lines that turn by no more than this, in radians.
const TURN: f64 = 0.05;

/// The end of a straight line of the path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// In mm.
    pub(super) at: [f64; 3],
    /// Of the move, in mm/s.
    pub(super) speed: f64,
    /// Asked for, in mm/s.
    pub(super) feed: f64,
    pub(super) is_rapid: bool,
    /// When it is reached, in s; within an arc as if its speed were even.
    pub(super) time: f64,
    /// No line leads there: a path begins.
    pub(super) is_start: bool,
}

/// All of it.
#[derive(Debug, Clone)]
pub(super) struct Gathered {
    pub(super) points: Vec<Point>,
    /// X, Y and Z in mm over time in s.
    pub(super) axes: [Series; 3],
    /// In mm/s.
    pub(super) speed: Series,
    pub(super) time: f64,
    pub(super) moves: u64,
    parts: f64,
}

impl Default for Gathered {
    fn default() -> Self {
        Self {
            points: Vec::new(),
            axes: <[Series; 3]>::default(),
            speed: Series::default(),
            time: 0.0,
            moves: 0,
            parts: PARTS,
        }
    }
}

impl Gathered {
    /// Whether there is nothing to draw.
    pub(super) fn is_empty(&self) -> bool {
        self.points.len() < 2 || self.time <= 0.0
    }

    pub(super) fn add(&mut self, row: &Row) {
        self.moves += 1;
        if row.time <= 0.0 {
            return;
        }
        let (begin, is_rapid) = (self.time, row.cut.feed.is_rapid());
        let point = |share: f64| {
            let time = begin + share * row.time;
            Point { at: at(row, share), speed: row.peak, feed: row.feed, is_rapid, time, is_start: share == 0.0 }
        };
        if self.points.last().is_none_or(|last| last.at != row.cut.from) {
            self.points.push(point(0.0));
        }
        let lines = lines(row);
        self.points.extend((1..=lines).map(|index| point(f64::from(index) / f64::from(lines))));
        self.over_time(row, lines);
        if self.points.len() > MOST {
            self.thin();
        }
    }

    pub(super) fn dwell(&mut self, time: f64) {
        self.speed.push(self.time, 0.0);
        self.time += time;
        self.speed.push(self.time, 0.0);
        if let Some(last) = self.points.last().copied() {
            self.points.push(Point { time: self.time, is_start: false, ..last });
        }
        for (axis, series) in self.axes.iter_mut().enumerate() {
            if let Some(last) = self.points.last() {
                series.push(self.time, last.at[axis]);
            }
        }
    }

    fn over_time(&mut self, row: &Row, lines: u32) {
        let ramps = Ramps::of(row);
        let between = if self.moves < MANY { lines.max(8) } else { lines.min(4) };
        for time in ramps.times(between) {
            let at = at(row, ramps.share(time));
            for (series, value) in self.axes.iter_mut().zip(at) {
                series.push(self.time + time, value);
            }
            self.speed.push(self.time + time, ramps.speed(time));
        }
        self.time += row.time;
    }

    /// The least and the largest coordinate of the path.
    pub(super) fn range(&self, axis: usize) -> (f64, f64) {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        self.points.iter().fold(start, |(low, high), point| (low.min(point.at[axis]), high.max(point.at[axis])))
    }

    /// Leaves out points that are nearer to the one before than anybody sees, and go on as that does.
    fn thin(&mut self) {
        let extent = (0..3).map(|axis| self.range(axis)).map(|(low, high)| high - low).fold(0.0, f64::max);
        while self.points.len() > MOST / 2 && self.parts > 1.0 {
            let near = extent / self.parts;
            let mut kept: Vec<Point> = Vec::new();
            for point in &self.points {
                let follows = |last: &Point| {
                    let off = (0..3).map(|axis| (point.at[axis] - last.at[axis]).abs()).fold(0.0, f64::max);
                    off < near && last.is_rapid == point.is_rapid && !point.is_start && !last.is_start
                };
                if !kept.last().is_some_and(follows) {
                    kept.push(*point);
                }
            }
            self.points = kept;
            self.parts /= 2.0;
        }
    }
}

/// How many straight lines draw a move.
fn lines(row: &Row) -> u32 {
    match row.cut.path {
        Path::Straight => 1,
        Path::Arc(arc) => (arc.angle / TURN).ceil().clamp(1.0, 1000.0) as u32,
    }
}

/// The point of a move at a share of its way.
fn at(row: &Row, share: f64) -> [f64; 3] {
    let (from, to) = (row.cut.from, row.cut.to);
    match row.cut.path {
        _ if share >= 1.0 => to,
        Path::Straight => std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis])),
        Path::Arc(arc) => arc.at(from, to, share),
    }
}
