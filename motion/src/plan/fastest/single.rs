//! The fastest move of one axis, and its segments.

use super::between::Course;
use super::ramp::Ramp;
use super::rest;
use crate::error::PlanError;
use crate::motion::Limits;
use crate::plan::check::{finite, positive, segments_in_range};
use crate::plan::single::check_limits;
use crate::plan::units::Units;
use crate::profile::Profile;
use crate::segment::{Segment, State};

/// A move of one axis between states without acceleration, in the least time, or stretched to a given one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fastest {
    pub(super) start: State,
    pub(super) end: State,
    pub(super) limits: Limits,
    /// In the units.
    pub(super) course: Course,
    pub(super) units: Units,
}

impl Fastest {
    /// The fastest move from one state to another.
    ///
    /// # Errors
    ///
    /// A number that is not finite; a state with an acceleration; a velocity beyond its limit; a limit that is not positive;
    /// neither acceleration nor jerk limited; numbers beyond the range of `f64`.
    pub fn new(start: State, end: State, limits: Limits) -> Result<Self, PlanError> {
        check(&start, &end, &limits)?;
        Self::within(start, end, limits)
    }

    /// The same where an end may be faster than the limit: between, the move is not.
    pub(crate) fn within(start: State, end: State, limits: Limits) -> Result<Self, PlanError> {
        let way = end.position - start.position;
        finite("the way", way)?;
        let units = units(way, &start, &end, &limits);
        let within = Limits {
            velocity: units.within(limits.velocity, 1, -1),
            acceleration: units.within(limits.acceleration, 1, -2),
            jerk: units.within(limits.jerk, 1, -3),
        };
        let d = units.within(way, 1, 0);
        let [v0, v1] = [start.velocity, end.velocity].map(|v| units.within(v, 1, -1));
        let course = match (v0, v1) {
            (0.0, 0.0) if d < 0.0 => rest::course(-d, &within).mirrored(),
            (0.0, 0.0) if d > 0.0 => rest::course(d, &within),
            _ => {
                let noise = units.within(start.position.abs().max(end.position.abs()), 1, 0);
                Course::fastest(d, v0, v1, noise, &within)
            }
        };
        if !course.time().is_finite() {
            return Err(PlanError::Range { what: "the time of the move" });
        }
        Ok(Self { start, end, limits, course, units })
    }

    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.units.outside(self.course.time(), 0, 1)
    }

    /// Its first ramp, and its time at the velocity between.
    pub(crate) fn first_ramp_and_cruise(&self) -> (Ramp, f64) {
        (outside(self.course.first, self.units), self.units.outside(self.course.cruise, 0, 1))
    }

    /// What it does, segment after segment.
    ///
    /// # Errors
    ///
    /// It takes no time; numbers beyond the range of `f64`.
    pub fn profile(&self) -> Result<Profile, PlanError> {
        let what = "a time, velocity, acceleration or jerk of the move";
        let segments = self.segments();
        segments_in_range(what, &segments)?;
        Profile::new(segments).map_err(|_| PlanError::Range { what })
    }

    /// Its segments, at most seven; none where it takes no time.
    pub(crate) fn segments(&self) -> Vec<Segment> {
        let mut segments = Vec::with_capacity(7);
        let [first, last] = [self.course.first, self.course.last].map(|ramp| outside(ramp, self.units));
        let cruise = self.units.outside(self.course.cruise, 0, 1);
        first.forward(self.start.position, &mut segments);
        let from = if first.time() > 0.0 { self.start.position + first.way() } else { self.start.position };
        let to = if last.time() > 0.0 { self.end.position - last.way() } else { self.end.position };
        if cruise > 0.0 {
            segments.push(Segment::between(State::cruise(from, first.to), State::cruise(to, first.to), cruise));
        }
        last.backward(self.end.position, &mut segments);
        join(&mut segments);
        if let Some(segment) = segments.last_mut() {
            segment.end.position = self.end.position;
        }
        segments
    }
}

/// What is computed from both ends of a move, and of a ramp, meets up to rounding: exactly, where a segment takes over
/// where the one before ends.
fn join(segments: &mut [Segment]) {
    for index in 1..segments.len() {
        let before = segments[index - 1].end;
        let start = &mut segments[index].start;
        (start.position, start.velocity) = (before.position, before.velocity);
    }
}

/// A ramp of units.
fn outside(ramp: Ramp, units: Units) -> Ramp {
    Ramp {
        from: units.outside(ramp.from, 1, -1),
        to: units.outside(ramp.to, 1, -1),
        t_jerk: units.outside(ramp.t_jerk, 0, 1),
        t_constant: units.outside(ramp.t_constant, 0, 1),
        acceleration: units.outside(ramp.acceleration, 1, -2),
    }
}

/// In which the way and the time of the move are near 1.
fn units(way: f64, start: &State, end: &State, limits: &Limits) -> Units {
    let (d, dv) = (way.abs(), (end.velocity - start.velocity).abs());
    let ramp = (dv / limits.acceleration).max((dv / limits.jerk).sqrt());
    let time = (d / limits.velocity).max((d / limits.acceleration).sqrt()).max((d / limits.jerk).cbrt()).max(ramp);
    let length = d.max(time * start.velocity.abs().max(end.velocity.abs()));
    if length > 0.0 && time > 0.0 { Units::of(length, time) } else { Units::of(1.0, 1.0) }
}

fn check(start: &State, end: &State, limits: &Limits) -> Result<(), PlanError> {
    check_limits(limits)?;
    let bounded = limits.acceleration.min(limits.jerk);
    if bounded == f64::INFINITY {
        let remedy = "limit the acceleration, the jerk, or both: without them there is no fastest move";
        return Err(PlanError::Input { name: "acceleration", value: bounded, remedy });
    }
    for limit in [limits.velocity, limits.acceleration, limits.jerk] {
        positive("a limit", limit.min(f64::MAX))?;
    }
    for state in [start, end] {
        finite("position", state.position)?;
        finite("velocity", state.velocity)?;
        if state.acceleration != 0.0 {
            let remedy = "a move begins and ends without acceleration here: give 0";
            return Err(PlanError::Input { name: "acceleration", value: state.acceleration, remedy });
        }
        if state.velocity.abs() > limits.velocity {
            let (limit, needed) = (limits.velocity, state.velocity.abs());
            let remedy = "the move begins or ends faster than that: give a smaller velocity";
            return Err(PlanError::Limit { name: "velocity", limit, needed, unit: "m/s", remedy });
        }
    }
    Ok(())
}
