//! The points of a profile: rows in the units of the controller, on the steps of its time, none too long.

use super::error::ExportError;
use super::scaling::Scaling;
use crate::segment::State;
use crate::table::Row;

/// What the buffer of a controller holds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Buffer {
    /// The shortest time of a segment, in s; 0 for none.
    pub shortest: f64,
    /// The longest time of a segment, in s; none for what the form can say. Longer ones are divided.
    pub longest: Option<f64>,
    /// How many points it holds; none for any number.
    pub most: Option<u64>,
}

impl Buffer {
    /// The longest segment, in steps of a form.
    fn longest(&self, times: &Times) -> Result<f64, ExportError> {
        let Some(longest) = self.longest else { return Ok(times.longest) };
        // a time that is meant to be a number of steps may be a rounding below it
        let steps = (longest * times.per_second * (1.0 + 1e-12)).floor();
        let shortest = (self.shortest * times.per_second).max(1.0);
        // a longer segment has parts of more than half the longest
        let least = (2.0 * shortest).max(2.0);
        if steps >= least || self.shortest == 0.0 && steps >= 1.0 {
            return Ok(steps.min(times.longest));
        }
        Err(ExportError::Longest { longest, least: least / times.per_second })
    }
}

/// The times that a form can say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Times {
    /// How many steps a second has.
    pub per_second: f64,
    /// The longest segment, in steps.
    pub longest: f64,
}

/// Where a segment ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    /// Of the segment that ends here, in steps.
    pub steps: f64,
    /// Positions and velocities, in the units of the controller and those a second.
    pub axes: Vec<(f64, f64)>,
    /// Whether all axes go on at their velocity, in the segment that ends here, and at least one moves.
    pub is_steady: bool,
}

/// The points of rows, one by one; the first is the start, and takes no time.
pub(super) struct Points<I> {
    rows: I,
    scalings: Vec<Scaling>,
    buffer: Buffer,
    times: Times,
    /// In steps.
    longest: f64,
    before: Option<(f64, Vec<State>)>,
    left: std::vec::IntoIter<Point>,
    count: u64,
}

impl<I: Iterator<Item = Row>> Points<I> {
    pub(super) fn new(rows: I, scalings: Vec<Scaling>, buffer: &Buffer, times: Times) -> Result<Self, ExportError> {
        let (longest, left) = (buffer.longest(&times)?, Vec::new().into_iter());
        Ok(Self { rows, scalings, buffer: *buffer, times, longest, before: None, left, count: 0 })
    }

    /// A row, divided where it is too long.
    fn divided(&mut self, row: &Row) -> Result<Vec<Point>, ExportError> {
        let (time, states) = (row.knot.time, &row.knot.states);
        let finite = |state: &State| state.position.is_finite() && state.velocity.is_finite();
        if !time.is_finite() || !states.iter().all(finite) {
            return Err(ExportError::NotFinite { row: self.count + 1 });
        }
        let step = (time * self.times.per_second).round();
        let Some((begun, from)) = self.before.replace((step, states.clone())) else {
            return Ok(vec![self.point(0.0, states, false)]);
        };
        let steps = step - begun;
        let shortest = (self.buffer.shortest * self.times.per_second * (1.0 - 1e-12)).max(1.0);
        if steps < shortest {
            let (time, shortest) = (steps / self.times.per_second, shortest / self.times.per_second);
            return Err(ExportError::Short { segment: self.count, time, shortest });
        }
        let moves = |pair: (&State, &State)| pair.0.velocity == pair.1.velocity && pair.0.acceleration == 0.0;
        let is_steady = from.iter().zip(states).all(moves) && from.iter().any(|state| state.velocity != 0.0);
        let parts = (steps / self.longest).ceil();
        let ends: Vec<f64> = (0..=parts as u64).map(|part| (steps * part as f64 / parts).round()).collect();
        let point = |pair: &[f64]| {
            let share = pair[1] / steps;
            let states: Vec<State> = match share {
                1.0 => states.clone(),
                _ => from.iter().zip(states).map(|(a, b)| cubic(a, b, steps / self.times.per_second, share)).collect(),
            };
            self.point(pair[1] - pair[0], &states, is_steady)
        };
        Ok(ends.windows(2).map(point).collect())
    }

    fn point(&self, steps: f64, states: &[State], is_steady: bool) -> Point {
        let axis =
            |(state, scaling): (&State, &Scaling)| (scaling.position(state.position), scaling.velocity(state.velocity));
        Point { steps, axes: states.iter().zip(&self.scalings).map(axis).collect(), is_steady }
    }
}

impl<I: Iterator<Item = Row>> Iterator for Points<I> {
    type Item = Result<Point, ExportError>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            if let Some(point) = self.left.next() {
                self.count += 1;
                return match self.buffer.most {
                    Some(most) if self.count > most => Some(Err(ExportError::Many { most })),
                    _ => Some(Ok(point)),
                };
            }
            let row = self.rows.next()?;
            match self.divided(&row) {
                Ok(points) => self.left = points.into_iter(),
                Err(error) => return Some(Err(error)),
            }
        }
    }
}

/// On the cubic between two states, at a share of its time.
fn cubic(a: &State, b: &State, time: f64, share: f64) -> State {
    let (s, left) = (share, 1.0 - share);
    let rise = b.position - a.position;
    let position = a.position + rise * s * s * (3.0 - 2.0 * s) + time * s * left * (a.velocity * left - b.velocity * s);
    let velocity =
        6.0 * rise / time * s * left + a.velocity * left * (1.0 - 3.0 * s) + b.velocity * s * (3.0 * s - 2.0);
    State::cruise(position, velocity)
}
