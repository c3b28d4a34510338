//! A ramp: the fastest change from one velocity to another, without acceleration at both ends.

use closedform_kernels::s_curve;

use crate::motion::Limits;
use crate::segment::{Segment, State};

/// A ramp: up with the jerk in `t_jerk`, on for `t_constant`, and back in `t_jerk`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ramp {
    pub from: f64,
    pub to: f64,
    pub t_jerk: f64,
    pub t_constant: f64,
    /// The largest, with its sign.
    pub acceleration: f64,
}

impl Ramp {
    /// The fastest within limits, of which the acceleration or the jerk is finite.
    pub(crate) fn fastest(from: f64, to: f64, limits: &Limits) -> Self {
        Self::of_change(from, to, (to - from).abs(), limits)
    }

    /// The same where the difference of both velocities is known with more digits than they have.
    pub(crate) fn of_change(from: f64, to: f64, dv: f64, limits: &Limits) -> Self {
        let (t_jerk, t_constant, peak) = times(dv, limits);
        Self { from, to, t_jerk, t_constant, acceleration: if to < from { -peak } else { peak } }
    }

    /// Seen backwards in time.
    pub(crate) fn reversed(self) -> Self {
        Self { from: self.to, to: self.from, acceleration: -self.acceleration, ..self }
    }

    /// In the other direction.
    pub(crate) fn mirrored(self) -> Self {
        Self { from: -self.from, to: -self.to, acceleration: -self.acceleration, ..self }
    }

    /// In so many times the time, between velocities that are so many times smaller.
    pub(crate) fn slower(self, times: f64) -> Self {
        Self {
            from: self.from / times,
            to: self.to / times,
            t_jerk: self.t_jerk * times,
            t_constant: self.t_constant * times,
            acceleration: self.acceleration / times / times,
        }
    }

    /// In s.
    pub(crate) fn time(&self) -> f64 {
        2.0 * self.t_jerk + self.t_constant
    }

    /// Its mean velocity, which its symmetry makes that of its ends, by its time.
    pub(crate) fn way(&self) -> f64 {
        (self.from + self.to) / 2.0 * self.time()
    }

    /// How its way grows with the velocity `to`, where that rises above `from`.
    pub(crate) fn growth(&self, limits: &Limits) -> f64 {
        let rate = if self.t_constant > 0.0 { 1.0 / limits.acceleration } else { 1.0 / (limits.jerk * self.t_jerk) };
        self.time() / 2.0 + (self.from + self.to) / 2.0 * rate
    }

    /// Its segments, from a position on.
    pub(crate) fn forward(&self, position: f64, segments: &mut Vec<Segment>) {
        self.push(segments, |way| position + way);
    }

    /// Its segments, up to a position.
    pub(crate) fn backward(&self, position: f64, segments: &mut Vec<Segment>) {
        let whole = self.way();
        self.push(segments, |way| position - (whole - way));
    }

    /// Those of its stretches that take time. Where the jerk has no limit, the acceleration jumps.
    fn push(&self, segments: &mut Vec<Segment>, at: impl Fn(f64) -> f64) {
        let states = self.states(at);
        for (index, duration) in [self.t_jerk, self.t_constant, self.t_jerk].into_iter().enumerate() {
            if duration > 0.0 {
                segments.push(Segment::between(states[index], states[index + 1], duration));
            }
        }
    }

    /// Where its stretches meet, by what it has made of its way.
    fn states(&self, at: impl Fn(f64) -> f64) -> [State; 4] {
        let (t, a) = (self.t_jerk, self.acceleration);
        // what each stretch of jerk changes, from the nearer end
        let (near, far) = (self.from + a * t / 2.0, self.to - a * t / 2.0);
        let first = t * (self.from + a * t / 6.0);
        let last = t * (self.to - a * t / 6.0);
        let (state, way) =
            (|way, velocity, acceleration| State { position: at(way), velocity, acceleration }, self.way());
        // without a limit of the jerk both ends are where the acceleration has jumped
        let end = if t > 0.0 { 0.0 } else { a };
        [state(0.0, self.from, end), state(first, near, a), state(way - last, far, a), state(way, self.to, end)]
    }
}

/// Times of jerk and of constant acceleration, and the largest acceleration.
fn times(dv: f64, limits: &Limits) -> (f64, f64, f64) {
    let (a, j) = (limits.acceleration, limits.jerk);
    if dv == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    if j == f64::INFINITY {
        return (0.0, dv / a, a);
    }
    // outside of its domain, where the ramp is pointed, the kernel gives no number
    let flat = s_curve::ramp(dv, a, j);
    if flat.t_constant >= 0.0 {
        return (flat.t_jerk, flat.t_constant, a);
    }
    let t_jerk = s_curve::pointed_ramp(dv, j);
    (t_jerk, 0.0, (dv / t_jerk).min(a))
}
