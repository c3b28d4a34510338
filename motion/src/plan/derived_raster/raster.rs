//! A planned raster as motions, and as a stream of knots that never holds it in memory.

use super::turn::{Half, Turn};
use super::{Back, DerivedRasterPlan, Raster};
use crate::error::PlanError;
use crate::motion::{Axis, Knot, Motion};
use crate::plan::check::segments_in_range;
use crate::plan::clock::Clock;
use crate::profile::Profile;
use crate::segment::{Segment, State};

/// What both axes do between two knots.
#[derive(Debug, Clone, Copy)]
struct Piece {
    duration: f64,
    fly: [State; 2],
    step: [State; 2],
}

impl Piece {
    fn fly(&self) -> Segment {
        Segment::between(self.fly[0], self.fly[1], self.duration)
    }

    fn step(&self) -> Segment {
        Segment::between(self.step[0], self.step[1], self.duration)
    }
}

/// An end of the line: beyond it positions are counted outwards.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Side {
    /// At position 0.
    Left,
    /// At the length of the line.
    Right,
}

impl Side {
    fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// The state of the fly axis `beyond` the end, with velocity and acceleration outwards.
    fn state(self, length: f64, beyond: f64, velocity: f64, acceleration: f64) -> State {
        // adding 0 leaves no -0 for tables to print
        match self {
            Self::Left => State { position: 0.0 - beyond, velocity: 0.0 - velocity, acceleration: 0.0 - acceleration },
            Self::Right => {
                State { position: length + beyond, velocity: velocity + 0.0, acceleration: acceleration + 0.0 }
            }
        }
    }
}

impl DerivedRasterPlan {
    /// The first line, at `v1_scan`, from time 0: axes `fly` and `step`.
    pub fn line_motion(&self) -> Result<Motion, PlanError> {
        self.joined([self.line(0)].into_iter())
    }

    /// The turn-around after the first line, with the step, from time 0.
    pub fn turn_motion(&self) -> Result<Motion, PlanError> {
        let [from, to] = [self.step_position(0), self.step_position(1)];
        self.joined(self.turn_pieces(&self.turn, Side::Right, from, to).into_iter())
    }

    /// The whole raster, from rest to rest: all lines in memory; [`DerivedRasterPlan::knots`] does without.
    pub fn motion(&self) -> Result<Motion, PlanError> {
        self.joined(self.pieces().map(|(_, piece)| piece))
    }

    /// The rows of a PVT table of the whole raster, one by one, from rest to rest. The acceleration is that after the
    /// knot.
    pub fn knots(&self) -> impl Iterator<Item = Knot> + '_ {
        let knot = |time, fly, step| Knot { time, states: vec![fly, step] };
        let rest = self.rest_position();
        let step = State::rest(self.step_position(self.scan.lines - 1));
        let starts = self.pieces().map(move |(time, piece)| knot(time, piece.fly[0], piece.step[0]));
        let end = std::iter::once_with(move || knot(self.on_tick(self.duration), rest, step));
        starts.chain(end).scan(0.0, |before: &mut f64, row| {
            // a piece shorter than the resolution of its time does not turn time back
            *before = before.max(row.time);
            Some(Knot { time: *before, ..row })
        })
    }

    /// The same rows, each with the time of the segment that ends with it: the same every time.
    pub fn rows(&self) -> impl Iterator<Item = (Knot, f64)> + '_ {
        let durations = self.pieces().map(|(_, piece)| self.on_tick(piece.duration));
        self.knots().zip(std::iter::once(0.0).chain(durations))
    }

    /// How many knots there are.
    #[must_use]
    pub fn knot_count(&self) -> u64 {
        let turn = self.turn_pieces(&self.turn, Side::Right, 0.0, 0.0).len() as u64;
        let back = self.back.map_or(0, |back| 1 + self.turn_pieces(&back.turn, Side::Left, 0.0, 0.0).len() as u64);
        5 + self.scan.lines + (self.scan.lines - 1) * (turn + back)
    }

    /// That all states and jerks have their digits, from the start to the second line; the steps after it repeat.
    pub(super) fn check_range(&self) -> Result<(), PlanError> {
        let pieces: Vec<Piece> = self.run_up().into_iter().chain([self.line(0)]).chain(self.to_next(0)).collect();
        let what = "a time, velocity, acceleration or jerk of the raster";
        let segments = |of: fn(&Piece) -> Segment| pieces.iter().map(of).collect::<Vec<_>>();
        segments_in_range(what, &segments(Piece::fly))?;
        segments_in_range(what, &segments(Piece::step))
    }

    fn joined(&self, pieces: impl Iterator<Item = Piece>) -> Result<Motion, PlanError> {
        let (mut fly, mut step) = (Vec::new(), Vec::new());
        for piece in pieces {
            fly.push(piece.fly());
            step.push(piece.step());
        }
        let [fly_limits, step_limits] = self.scan.limits();
        let axis = |name: &str, segments, limits| {
            let profile = Profile::new(segments).map_err(|_| PlanError::Range { what: "a position of the raster" })?;
            Ok(Axis { name: name.into(), profile, limits })
        };
        Ok(Motion::new(vec![axis("fly", fly, fly_limits)?, axis("step", step, step_limits)?]))
    }

    /// All pieces, with the times at which they start.
    fn pieces(&self) -> impl Iterator<Item = (f64, Piece)> + '_ {
        let entering = self.entering();
        let lead = entering.time();
        let last = self.scan.lines - 1;
        let start = move |line: u64| lead + line as f64 * self.period;
        let lead_in = self.run_up().to_vec();
        let lead_out = self.run_out().to_vec();
        std::iter::once_with(move || self.timed(0.0, lead_in))
            .chain((0..self.scan.lines).map(move |line| self.timed(start(line), self.line_and_turn(line))))
            .chain(std::iter::once_with(move || self.timed(start(last) + self.line_time, lead_out)))
            .flatten()
    }

    /// Pieces that follow each other, with their times.
    fn timed(&self, start: f64, pieces: Vec<Piece>) -> Vec<(f64, Piece)> {
        let mut offset = 0.0;
        let mut time = |piece: Piece| {
            let time = self.on_tick(start + offset);
            offset += piece.duration;
            (time, piece)
        };
        pieces.into_iter().map(&mut time).collect()
    }

    /// A time without the rounding of its sum, where it is known to be a multiple of the tick.
    fn on_tick(&self, time: f64) -> f64 {
        self.scan.tick.map_or(time, |tick| Clock::new(Some(tick), 0.0).seconds((time / tick).round()))
    }

    /// A line, and what leads to the next, if there is one.
    fn line_and_turn(&self, line: u64) -> Vec<Piece> {
        let mut pieces = vec![self.line(line)];
        if line + 1 < self.scan.lines {
            pieces.extend(self.to_next(line));
        }
        pieces
    }

    /// What leads from a line to the next.
    fn to_next(&self, line: u64) -> Vec<Piece> {
        let [from, to] = [self.step_position(line), self.step_position(line + 1)];
        let mut pieces = self.turn_pieces(&self.turn, self.side(line), from, to);
        if let Some(back) = &self.back {
            pieces.push(self.way_back(back, to));
            pieces.extend(self.turn_pieces(&back.turn, Side::Left, to, to));
        }
        pieces
    }

    /// Where a line ends.
    fn side(&self, line: u64) -> Side {
        if self.scan.raster == Raster::Snake && line % 2 == 1 { Side::Left } else { Side::Right }
    }

    /// Where the step axis is on a line.
    fn step_position(&self, line: u64) -> f64 {
        line as f64 * self.scan.d2_step
    }

    /// What leads into lines: the half, seen from the line to rest.
    fn entering(&self) -> &Half {
        self.back.as_ref().map_or(&self.turn.entering, |back| &back.turn.entering)
    }

    fn entering_at(&self) -> [f64; 3] {
        self.back.as_ref().map_or(self.turn.entering_at, |back| back.turn.entering_at)
    }

    fn line(&self, line: u64) -> Piece {
        let (side, length) = (self.side(line), self.scan.line_length);
        let start = side.opposite().state(length, self.entering_at()[0], -self.v1_scan, 0.0);
        let end = side.state(length, self.turn.leaving_at[0], self.v1_scan, 0.0);
        let step = State::rest(self.step_position(line));
        Piece { duration: self.line_time, fly: [start, end], step: [step; 2] }
    }

    fn way_back(&self, back: &Back, step: f64) -> Piece {
        let length = self.scan.line_length;
        let start = Side::Right.state(length, self.turn.entering_at[0], -back.v1_return, 0.0);
        let end = Side::Left.state(length, back.turn.leaving_at[0], back.v1_return, 0.0);
        Piece { duration: back.time, fly: [start, end], step: [State::rest(step); 2] }
    }

    /// From rest to the first line.
    fn run_up(&self) -> [Piece; 2] {
        let half = self.entering();
        let [line, ramp, rest] = self.fly_states(half, self.entering_at(), Side::Left, -1.0);
        let step = [State::rest(0.0); 2];
        [
            Piece { duration: half.t_out, fly: [rest, ramp], step },
            Piece { duration: half.t_in, fly: [ramp, line], step },
        ]
    }

    /// From the last line to rest.
    fn run_out(&self) -> [Piece; 2] {
        let last = self.scan.lines - 1;
        let half = &self.turn.leaving;
        let [line, ramp, rest] = self.fly_states(half, self.turn.leaving_at, self.side(last), 1.0);
        let step = [State::rest(self.step_position(last)); 2];
        [
            Piece { duration: half.t_in, fly: [line, ramp], step },
            Piece { duration: half.t_out, fly: [ramp, rest], step },
        ]
    }

    /// Where the raster ends, with the acceleration it ends with.
    fn rest_position(&self) -> State {
        self.run_out()[1].fly[1]
    }

    /// The fly axis at the ends of the ramps of a half, outwards (1) or inwards (-1).
    fn fly_states(&self, half: &Half, at: [f64; 3], side: Side, direction: f64) -> [State; 3] {
        let state = |beyond, velocity: f64, deceleration: f64| {
            side.state(self.scan.line_length, beyond, direction * velocity, -deceleration)
        };
        [state(at[0], half.velocity, 0.0), state(at[1], half.v1_out, half.a1_in), state(at[2], 0.0, half.a1_peak)]
    }

    /// A turn-around, with the step axis going from one position to another.
    fn turn_pieces(&self, turn: &Turn, side: Side, from: f64, to: f64) -> Vec<Piece> {
        let (a, b) = (&turn.leaving, &turn.entering);
        let fly_out = self.fly_states(a, turn.leaving_at, side, 1.0);
        let fly_in = self.fly_states(b, turn.entering_at, side, -1.0);
        let outwards = |state: State| State { position: from + state.position, ..state };
        let inwards =
            |s: State| State { position: to - s.position, velocity: s.velocity, acceleration: 0.0 - s.acceleration };
        let step_out = turn.step(a, turn.a2_leaving).map(outwards);
        let mut step_in = turn.step(b, turn.a2_entering).map(inwards);
        if turn.t_edge == 0.0 {
            step_in[1] = step_out[1];
        }
        let piece = |duration, fly: [State; 2], step: [State; 2]| Piece { duration, fly, step };
        let mut pieces = vec![
            piece(a.t_in, [fly_out[0], fly_out[1]], [State::rest(from), step_out[0]]),
            piece(a.t_out, [fly_out[1], fly_out[2]], [step_out[0], step_out[1]]),
        ];
        let still = [State::rest(fly_out[2].position); 2];
        if turn.t_edge > 0.0 && turn.is_symmetric() {
            pieces.push(piece(turn.t_edge, still, [step_out[1], step_in[1]]));
        } else if turn.t_edge > 0.0 {
            pieces.push(piece(turn.t_edge / 2.0, still, [step_out[1], step_out[2]]));
            pieces.push(piece(turn.t_edge / 2.0, still, [step_out[2], step_in[1]]));
        }
        pieces.push(piece(b.t_out, [fly_in[2], fly_in[1]], [step_in[1], step_in[0]]));
        pieces.push(piece(b.t_in, [fly_in[1], fly_in[0]], [step_in[0], State::rest(to)]));
        pieces
    }
}
