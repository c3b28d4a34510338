//! A planned raster as a motion, and as a stream of rows that never holds it in memory.

use super::gap::Timed;
use super::input::RasterScan;
use super::pattern::{Piece, pieces};
use super::planned::{RasterPlan, count_of};
use crate::error::PlanError;
use crate::motion::{Axis, Knot, Motion};
use crate::profile::Profile;
use crate::segment::{Segment, State};

/// When a piece starts, how long it takes, and the states of both axes at both of its ends.
type Placed = (f64, f64, [[State; 2]; 2]);

/// The patterns of a raster, each from the start of a steady part on, and counted from its end.
struct Patterns {
    lead_in: Vec<Piece>,
    first: Vec<Piece>,
    middle: Vec<Piece>,
    last: Vec<Piece>,
}

impl RasterPlan {
    /// The names of the axes.
    pub const AXES: [&'static str; 2] = ["fly", "step"];

    /// Some lines from the first one on, from rest to rest: all in memory; [`RasterPlan::rows`] does without.
    ///
    /// # Errors
    ///
    /// A position is beyond the range of `f64`.
    pub fn motion(&self, lines: u64) -> Result<Motion, PlanError> {
        let few = lines.clamp(1, self.scan.lines);
        let shown = Self { scan: RasterScan { lines: few, ..self.scan }, ..self.clone() };
        let (mut fly, mut step) = (Vec::new(), Vec::new());
        for (_, duration, pair) in shown.placed() {
            let [from, to] = pair;
            fly.push(Segment::between(from[0], to[0], duration));
            step.push(Segment::between(from[1], to[1], duration));
        }
        let axis = |name: &str, segments, limits| {
            let profile = Profile::new(segments).map_err(|_| PlanError::Range { what: "a position of the raster" })?;
            Ok(Axis { name: name.into(), profile, limits })
        };
        Ok(Motion::new(vec![axis("fly", fly, self.scan.fly)?, axis("step", step, self.scan.stepping)?]))
    }

    /// The rows of a table of the whole raster, one by one, from rest to rest, each with the time of the piece that ends with
    /// it. The acceleration is that after the row.
    pub fn rows(&self) -> impl Iterator<Item = (Knot, f64)> + '_ {
        let mut before = 0.0;
        let mut end = None;
        let mut placed = self.placed();
        std::iter::from_fn(move || {
            let (time, states, next) = match placed.next() {
                Some((time, duration, [from, to])) => {
                    end = Some((time + duration, to));
                    (time, from, duration)
                }
                None => {
                    let (_, states) = end.take()?;
                    (self.duration, states, 0.0)
                }
            };
            let row = (Knot { time, states: states.to_vec() }, before);
            before = next;
            Some(row)
        })
    }

    /// How many rows there are.
    #[must_use]
    pub fn row_count(&self) -> u64 {
        let patterns = self.patterns();
        let inner = self.scan.lines.saturating_sub(2) * patterns.middle.len() as u64;
        let first = if self.scan.lines > 1 { patterns.first.len() } else { 0 };
        1 + inner + (patterns.lead_in.len() + first + patterns.last.len()) as u64
    }

    fn patterns(&self) -> Patterns {
        let (same, seconds) = (self.clock.same(count_of(&self.gap)), |count| self.clock.seconds(count));
        let shifted = |track: &[Timed], by: f64| -> Vec<Timed> {
            track.iter().map(|timed| Timed { start: timed.start + by, end: timed.end + by, ..*timed }).collect()
        };
        // counted from the end of the steady part: what is between two lines is short beside it
        let steady = shifted(&[self.steady], -self.steady.end);
        let line = [&steady[..], &self.gap].concat();
        let out = [&steady[..], &self.lead_out].concat();
        // the step starts before the end of the steady part, and may end after the start of the next
        let leaving = shifted(&self.step, -self.ahead);
        let mut arriving = shifted(&leaving, -count_of(&self.gap));
        arriving.retain(|timed| timed.end > same && self.scan.lines > 1);
        arriving = shifted(&arriving, -self.steady.end);
        arriving.iter_mut().for_each(|timed| *timed = lowered(*timed, self.scan.step));
        let both: Vec<Timed> = arriving.iter().chain(&leaving).copied().collect();
        Patterns {
            lead_in: pieces(&self.lead_in, &[], 0.0, same, seconds),
            first: pieces(&line, &leaving, 0.0, same, seconds),
            middle: pieces(&line, &both, 0.0, same, seconds),
            last: pieces(&out, &arriving, 0.0, same, seconds),
        }
    }

    /// All pieces in their places. Each ends where the next one starts, which is counted from another line perhaps.
    fn placed(&self) -> impl Iterator<Item = Placed> + '_ {
        let mut pieces = self.counted().peekable();
        std::iter::from_fn(move || {
            let (time, duration, [from, mut to]) = pieces.next()?;
            if let Some((_, _, [next, _])) = pieces.peek() {
                for (end, start) in to.iter_mut().zip(next) {
                    (end.position, end.velocity) = (start.position, start.velocity);
                }
            }
            Some((time, duration, [from, to]))
        })
    }

    fn counted(&self) -> impl Iterator<Item = Placed> + '_ {
        let patterns = self.patterns();
        let (lead, last) = (count_of(&self.lead_in), self.scan.lines - 1);
        let place = move |line: u64, base: f64, piece: Piece| {
            let ends = [0, 1].map(|end| [self.fly(line, piece.fly[end]), self.stepping(line, piece.step[end])]);
            (self.clock.seconds(base + piece.at), piece.duration, ends)
        };
        let before: Vec<_> = patterns.lead_in.iter().map(|piece| place(0, 0.0, *piece)).collect();
        let lines = (0..=last).flat_map(move |line| {
            let pattern = match line {
                _ if line == last => &patterns.last,
                0 => &patterns.first,
                _ => &patterns.middle,
            };
            let base = lead + line as f64 * self.count + self.steady.end;
            pattern.iter().map(|piece| place(line, base, *piece)).collect::<Vec<_>>()
        });
        before.into_iter().chain(lines)
    }

    /// The fly axis on a line, by what it does on the first.
    pub(super) fn fly(&self, line: u64, state: State) -> State {
        let back = self.is_snake() && line % 2 == 1;
        let along = if back { self.scan.line_length.abs() - state.position } else { state.position };
        let sign = self.scan.line_length.signum();
        let turned = if back { -sign } else { sign };
        State {
            position: self.scan.start[0] + sign * along + 0.0,
            velocity: turned * state.velocity + 0.0,
            acceleration: turned * state.acceleration + 0.0,
        }
    }

    /// The step axis on a line, by where it is from there.
    fn stepping(&self, line: u64, state: State) -> State {
        State { position: self.step_position(line) + state.position, ..state }
    }

    pub(super) fn step_position(&self, line: u64) -> f64 {
        self.scan.start[1] + line as f64 * self.scan.step
    }
}

/// A segment from another place.
fn lowered(timed: Timed, by: f64) -> Timed {
    let lower = |state: State| State { position: state.position - by, ..state };
    let segment = Segment { start: lower(timed.segment.start), end: lower(timed.segment.end), ..timed.segment };
    Timed { segment, ..timed }
}
