//! Between two lines: the turn-around of the fly axis, or its way back, and the step, each on the clock.

use super::input::{Order, RasterScan};
use crate::error::PlanError;
use crate::plan::clock::Clock;
use crate::plan::fastest::{Fastest, Ramp};
use crate::segment::{Segment, State};

/// A segment, and when it starts and ends on the clock, from the start of what it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Timed {
    pub start: f64,
    pub end: f64,
    pub segment: Segment,
}

/// Segments, one after the other, of these counts.
pub(super) fn timed(segments: Vec<Segment>, counts: &[f64]) -> Vec<Timed> {
    let mut start = 0.0;
    let mut found = Vec::new();
    for (segment, count) in segments.into_iter().zip(counts.iter().filter(|count| **count > 0.0)) {
        found.push(Timed { start, end: start + count, segment });
        start += count;
    }
    found
}

/// A ramp of counts.
fn ramp(clock: &Clock, from: f64, to: f64, [jerk, constant]: [f64; 2]) -> Ramp {
    let [t_jerk, t_constant] = [jerk, constant].map(|count| clock.seconds(count));
    Ramp { from, to, t_jerk, t_constant, acceleration: (to - from) / (t_jerk + t_constant) }
}

/// The fly axis: from the scan velocity to its opposite in one ramp; or to that of a way back, on, and back again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FlyGap {
    velocity: f64,
    /// Of the way back, from line end to line start, with the run-ups; 0 for a turn-around.
    way: f64,
    /// Counts of a stretch with jerk, and of one between two of them, of a ramp.
    ramp: [f64; 2],
    /// Count of the time at the velocity of the way back.
    cruise: f64,
    is_turn: bool,
}

impl FlyGap {
    /// The fastest on the clock.
    pub(super) fn fastest(scan: &RasterScan, clock: &Clock, way: f64) -> Result<Self, PlanError> {
        let velocity = scan.velocity;
        let on = |ramp: Ramp| [ramp.t_jerk, ramp.t_constant].map(|time| clock.up(time));
        if scan.order == Order::Snake {
            let ramp = on(Ramp::fastest(velocity, -velocity, &scan.fly));
            return Ok(Self { velocity, way: 0.0, ramp, cruise: 0.0, is_turn: true });
        }
        let limits = crate::motion::Limits { velocity: scan.v_return(), ..scan.fly };
        let back = Fastest::within(State::cruise(way, velocity), State::cruise(0.0, velocity), limits)?;
        let (ramp, cruise) = back.first_ramp_and_cruise();
        let mut gap = Self { velocity, way, ramp: on(ramp), cruise: clock.up(cruise), is_turn: false };
        // with longer ramps between unequal velocities the way back may be faster, until it takes longer too
        while clock.step() > 0.0 && gap.back(clock) > scan.v_return() {
            gap.cruise += clock.step();
        }
        Ok(gap)
    }

    /// Count of all of it.
    pub(super) fn count(&self) -> f64 {
        self.ramps() + self.cruise
    }

    fn ramps(&self) -> f64 {
        let ramp = 2.0 * self.ramp[0] + self.ramp[1];
        if self.is_turn { ramp } else { 2.0 * ramp }
    }

    /// The same in a longer time: with less acceleration, or slower on the way back.
    pub(super) fn stretched(self, count: f64) -> Self {
        match self.is_turn {
            true => Self { ramp: [self.ramp[0], count - 2.0 * self.ramp[0]], ..self },
            false => Self { cruise: count - self.ramps(), ..self },
        }
    }

    /// Velocity of the way back: what the ramps leave of it, by its time.
    fn back(&self, clock: &Clock) -> f64 {
        let ramp = clock.seconds(2.0 * self.ramp[0] + self.ramp[1]);
        (self.way + self.velocity * ramp) / (ramp + clock.seconds(self.cruise))
    }

    /// From a position on.
    pub(super) fn segments(&self, scan: &RasterScan, clock: &Clock, position: f64) -> Vec<Timed> {
        let (v, [jerk, constant]) = (self.velocity, self.ramp);
        let mut segments = Vec::new();
        if self.is_turn {
            ramp(clock, v, -v, self.ramp).forward(position, &mut segments);
            return timed(segments, &[jerk, constant, jerk]);
        }
        let back = self.back(clock).min(scan.v_return().max(v));
        let (first, last) = (ramp(clock, v, -back, self.ramp), ramp(clock, -back, v, self.ramp));
        first.forward(position, &mut segments);
        let (from, to) = (position + first.way(), position - self.way - last.way());
        if self.cruise > 0.0 {
            let time = clock.seconds(self.cruise);
            segments.push(Segment::between(State::cruise(from, -back), State::cruise(to, -back), time));
        }
        last.backward(position - self.way, &mut segments);
        meet(&mut segments, position - self.way);
        timed(segments, &[jerk, constant, jerk, self.cruise, jerk, constant, jerk])
    }
}

/// The step: counts of a stretch with jerk, of one at the largest acceleration, and of that at the largest velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    way: f64,
    ramp: [f64; 2],
    cruise: f64,
}

impl Step {
    /// The fastest on the clock; nothing where there is no step.
    pub(super) fn fastest(scan: &RasterScan, clock: &Clock) -> Result<Option<Self>, PlanError> {
        if scan.step == 0.0 {
            return Ok(None);
        }
        let fastest = Fastest::new(State::rest(0.0), State::rest(scan.step), scan.stepping)?;
        let (ramp, cruise) = fastest.first_ramp_and_cruise();
        let ramp = [ramp.t_jerk, ramp.t_constant].map(|time| clock.up(time));
        Ok(Some(Self { way: scan.step, ramp, cruise: clock.up(cruise) }))
    }

    /// Count of all of it.
    pub(super) fn count(&self) -> f64 {
        4.0 * self.ramp[0] + 2.0 * self.ramp[1] + self.cruise
    }

    /// The same in a longer time: all of it slower, and what the clock leaves at the largest velocity.
    pub(super) fn stretched(self, clock: &Clock, count: f64) -> Self {
        let times = count / self.count();
        let longer = |least: f64| clock.down(clock.seconds(least) * times).max(least);
        let slower = Self { ramp: self.ramp.map(longer), cruise: 0.0, ..self };
        let slower = if slower.count() <= count { slower } else { Self { cruise: 0.0, ..self } };
        // without a tick the rounding of the counts is no time at the largest velocity
        let left = count - slower.count();
        let is_none = self.cruise == 0.0 && left <= clock.same(count);
        Self { cruise: if is_none { 0.0 } else { left.max(0.0) }, ..slower }
    }

    /// From 0 to the step.
    pub(super) fn segments(&self, clock: &Clock) -> Vec<Timed> {
        let [jerk, constant] = self.ramp;
        let peak = self.way / clock.seconds(2.0 * jerk + constant + self.cruise);
        let (first, last) = (ramp(clock, 0.0, peak, self.ramp), ramp(clock, peak, 0.0, self.ramp));
        let mut segments = Vec::new();
        first.forward(0.0, &mut segments);
        if self.cruise > 0.0 {
            let (from, to) = (State::cruise(first.way(), peak), State::cruise(self.way - last.way(), peak));
            segments.push(Segment::between(from, to, clock.seconds(self.cruise)));
        }
        last.backward(self.way, &mut segments);
        meet(&mut segments, self.way);
        timed(segments, &[jerk, constant, jerk, self.cruise, jerk, constant, jerk])
    }
}

/// The ramp from rest to the scan velocity, up to a position; or, backwards in time, to rest from there.
pub(super) fn lead(scan: &RasterScan, clock: &Clock, position: f64, is_in: bool) -> Vec<Timed> {
    let fastest = Ramp::fastest(0.0, scan.velocity, &scan.fly);
    let counts = [fastest.t_jerk, fastest.t_constant].map(|time| clock.up(time));
    let speeding = ramp(clock, 0.0, scan.velocity, counts);
    let mut segments = Vec::new();
    if is_in {
        speeding.backward(position, &mut segments);
    } else {
        speeding.reversed().forward(position, &mut segments);
    }
    let end = if is_in { position } else { segments.last().map_or(position, |segment| segment.end.position) };
    meet(&mut segments, end);
    timed(segments, &[counts[0], counts[1], counts[0]])
}

/// Lets each segment start exactly where the one before ends, and the last one end where it should.
fn meet(segments: &mut [Segment], end: f64) {
    for index in 1..segments.len() {
        let before = segments[index - 1].end;
        let start = &mut segments[index].start;
        (start.position, start.velocity) = (before.position, before.velocity);
    }
    if let Some(last) = segments.last_mut() {
        last.end.position = end;
    }
}
