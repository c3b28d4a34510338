//! Turn-arounds: their halves by the fly axis, and the step that fits into both.

use closedform_kernels::{fly_axis, turnaround};

use super::{DerivedRaster, Ramps};
use crate::plan::units::Units;
use crate::segment::State;

/// What rounding may add to an acceleration that the choice of the times makes equal to its limit: the kernels that
/// give the times are good to 5 ulp, `delta` to a half, and the 6 operations that give the acceleration back from them
/// add at most one each, with all terms positive; twice 5 for the squared times makes less than 20 ulp in all.
pub(super) const SLACK: f64 = 20.0 * f64::EPSILON;

/// Half a turn-around of the fly axis: from the line to rest. Mirrored in time, from rest to the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Half {
    /// On the line, in m/s.
    pub velocity: f64,
    /// What it loses in `t_in`, in m/s.
    pub v1_diff: f64,
    /// What is left then, in m/s.
    pub v1_out: f64,
    /// Time of the ramp in, from no acceleration to `a1_in`, in s.
    pub t_in: f64,
    /// Time of the ramp out, from `a1_in` to `a1_peak` and rest, in s.
    pub t_out: f64,
    /// Deceleration at the end of the ramp in, in m/s².
    pub a1_in: f64,
    /// Deceleration at rest, the largest, in m/s².
    pub a1_peak: f64,
    /// Distance of the ramp in, in m.
    pub d1_in: f64,
    /// Distance of the ramp out, in m.
    pub d1_out: f64,
}

impl Half {
    /// From times and velocities that belong together.
    pub(super) fn new(velocity: f64, v1_diff: f64, t_in: f64, t_out: f64, a1_peak: f64) -> Self {
        let a1_in = (-fly_axis::a1_in(v1_diff, t_in)).min(a1_peak);
        let d1_in = fly_axis::d1_in(t_in, velocity, v1_diff);
        let v1_out = velocity - v1_diff;
        Self { velocity, v1_diff, v1_out, t_in, t_out, a1_in, a1_peak, d1_in, d1_out: d1_out(t_out, a1_in, a1_peak) }
    }

    /// From times that are given and the `v1_diff` that follows: what is left after it follows from the times too, with
    /// all digits where it is little.
    pub(super) fn of_times(velocity: f64, v1_diff: f64, t_in: f64, t_out: f64, a1_peak: f64) -> Self {
        let half = Self::new(velocity, v1_diff, t_in, t_out, a1_peak);
        Self { v1_out: t_out * (half.a1_in + a1_peak) / 2.0, ..half }
    }

    /// From times and the ratio of the decelerations at the ends of the ramp out; with none above `limit`, where the
    /// times leave it.
    ///
    /// `a1_peak = 2*velocity/(ratio*t_in+(1+ratio)*t_out)`: what is lost in both ramps is the velocity.
    pub(super) fn of_ratio(velocity: f64, t_in: f64, t_out: f64, ratio: f64, limit: f64) -> Self {
        let weight = ratio * t_in + (1.0 + ratio) * t_out;
        let a1_peak = (2.0 * velocity / weight).min(limit);
        let v1_diff = velocity * (ratio * t_in / weight);
        let a1_in = ratio * a1_peak;
        // not as the difference of the other two, which loses its digits where v1_diff is almost all
        let v1_out = velocity * ((1.0 + ratio) * t_out / weight);
        let d1_in = fly_axis::d1_in(t_in, velocity, v1_diff);
        Self { velocity, v1_diff, v1_out, t_in, t_out, a1_in, a1_peak, d1_in, d1_out: d1_out(t_out, a1_in, a1_peak) }
    }

    /// From units of a problem.
    pub(super) fn outside(&self, units: Units) -> Self {
        Self {
            velocity: units.outside(self.velocity, 1, -1),
            v1_diff: units.outside(self.v1_diff, 1, -1),
            v1_out: units.outside(self.v1_out, 1, -1),
            t_in: units.outside(self.t_in, 0, 1),
            t_out: units.outside(self.t_out, 0, 1),
            a1_in: units.outside(self.a1_in, 1, -2),
            a1_peak: units.outside(self.a1_peak, 1, -2),
            d1_in: units.outside(self.d1_in, 1, 0),
            d1_out: units.outside(self.d1_out, 1, 0),
        }
    }

    /// The ratio of the decelerations at the ends of the ramp out, from 0 to 1.
    pub(super) fn ratio(&self) -> f64 {
        self.a1_in / self.a1_peak
    }

    /// In s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.t_in + self.t_out
    }
}

/// Distance to rest: the kernel `fly_axis::turn_out` has the same by velocities, but not at the edge, where both
/// decelerations are one.
fn d1_out(t_out: f64, a1_in: f64, a1_peak: f64) -> f64 {
    t_out * t_out * (a1_in + 2.0 * a1_peak) / 6.0
}

/// A half in its place: how far beyond the end of the line its ramp in starts, its ramp out starts, and it rests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reach {
    pub(super) half: Half,
    pub(super) at: [f64; 3],
}

impl Reach {
    /// At the end of a line.
    pub(super) fn from_line(half: Half, ramps: Ramps) -> Self {
        let at = match ramps {
            Ramps::Outside => [0.0, half.d1_in, half.d1_in + half.d1_out],
            Ramps::Inside => [-half.d1_in, 0.0, half.d1_out],
        };
        Self { half, at }
    }

    /// To or from rest where another half rests.
    pub(super) fn opposite(half: Half, other: &Self) -> Self {
        if half == other.half {
            return *other;
        }
        let rest = other.at[2];
        let out = rest - half.d1_out;
        Self { half, at: [out - half.d1_in, out, rest] }
    }

    /// Where it leaves its constant velocity: negative before the end of the line.
    pub(super) fn line(&self) -> f64 {
        self.at[0]
    }
}

/// A turn-around of both axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// From the line to rest.
    pub leaving: Half,
    /// Rest of the fly axis, for the step axis to catch up, in s. Half of it lengthens each ramp out of the step axis.
    pub t_edge: f64,
    /// From rest to the line, as it would be from the line to rest.
    pub entering: Half,
    /// Velocity of the step axis in the middle, its largest, in m/s.
    pub v2: f64,
    /// Its acceleration at the end of the ramp in, the largest, in m/s².
    pub a2_leaving: f64,
    /// Its deceleration at the start of the last ramp, the largest, in m/s².
    pub a2_entering: f64,
    pub(super) leaving_at: [f64; 3],
    pub(super) entering_at: [f64; 3],
}

impl Turn {
    /// With the step, in the least time; `t_edge` is a multiple of the tick.
    pub(super) fn with_step(scan: &DerivedRaster, leaving: Reach, entering: Reach) -> Self {
        let still = Self::still(leaving, edge(scan, &leaving.half, &entering.half), entering);
        let half_edge = still.t_edge / 2.0;
        let way = |half: &Half| step_time(half, half_edge);
        let v2 = scan.d2_step / (way(&still.leaving) + way(&still.entering));
        let acceleration = |half: &Half| (2.0 * v2 / (half.time() + half_edge)).min(scan.a2_max);
        Self { v2, a2_leaving: acceleration(&still.leaving), a2_entering: acceleration(&still.entering), ..still }
    }

    /// With the step axis at rest.
    pub(super) fn without_step(leaving: Reach, entering: Reach) -> Self {
        Self::still(leaving, 0.0, entering)
    }

    fn still(leaving: Reach, t_edge: f64, entering: Reach) -> Self {
        Self {
            leaving: leaving.half,
            t_edge,
            entering: entering.half,
            v2: 0.0,
            a2_leaving: 0.0,
            a2_entering: 0.0,
            leaving_at: leaving.at,
            entering_at: entering.at,
        }
    }

    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.leaving.time() + self.t_edge + self.entering.time()
    }

    /// The mean of both halves' time beyond that of the line, in s.
    #[must_use]
    pub fn overhead(&self) -> f64 {
        let half = |h: &Half| fly_axis::overhead(h.t_out, self.t_edge, h.t_in, h.v1_diff, h.velocity);
        (half(&self.leaving) + half(&self.entering)) / 2.0
    }

    /// Distance that the step axis makes in the ramp in, in m: how far it leaves the line with the ramps inside.
    #[must_use]
    pub fn d2_in(&self) -> f64 {
        self.step(&self.leaving, self.a2_leaving)[0].position
    }

    /// Whether the second half mirrors the first.
    pub(super) fn is_symmetric(&self) -> bool {
        is_symmetric(&self.leaving, &self.entering)
    }

    /// The step axis after the ramp in, after the ramp out of the fly axis, and in the middle of the rest, from rest at
    /// 0: of the first half, or of the second seen backwards in time.
    pub(super) fn step(&self, half: &Half, a2: f64) -> [State; 3] {
        if a2 == 0.0 {
            return [State::rest(0.0); 3];
        }
        let rest = self.t_edge / 2.0;
        let way = self.v2 * step_time(half, rest);
        let ramp = turnaround::ramp_in(a2, half.t_in);
        let middle = State::cruise(way, self.v2);
        let jerk = a2 / (half.t_out + rest);
        // forwards from the ramp in, where nothing cancels
        let (t, slower) = (half.t_out, jerk * half.t_out / 2.0);
        let out = State {
            position: ramp.d2_in + t * (ramp.v2_in + t * (a2 / 2.0 - slower / 3.0)),
            velocity: ramp.v2_in + t * (a2 - slower),
            acceleration: (jerk * rest).min(a2),
        };
        let out = if rest == 0.0 { middle } else { out };
        [State { position: ramp.d2_in, velocity: ramp.v2_in, acceleration: a2 }, out, middle]
    }
}

/// Distance of the step axis in a half by its velocity in the middle, in s.
fn step_time(half: &Half, half_edge: f64) -> f64 {
    (half.t_in + 2.0 * (half.t_out + half_edge)) / 3.0
}

fn is_symmetric(a: &Half, b: &Half) -> bool {
    a.t_in == b.t_in && a.t_out == b.t_out
}

/// The least rest with which the step keeps `a2_max`.
fn edge(scan: &DerivedRaster, a: &Half, b: &Half) -> f64 {
    let slower = a.time().min(b.time());
    let ways = step_time(a, 0.0) + step_time(b, 0.0);
    if 2.0 * scan.d2_step / (ways * slower) <= scan.a2_max * (1.0 + SLACK) {
        return 0.0;
    }
    let delta = scan.d2_step / scan.a2_max;
    let symmetric = is_symmetric(a, b);
    let t_edge =
        if symmetric { turnaround::t_edge_of_t_in(a.t_in, a.t_out, delta) } else { uneven(ways, slower, delta) };
    match scan.tick {
        None => t_edge,
        // the middle of an uneven turn-around is a knot
        Some(tick) => super::quantise::up(t_edge, if symmetric { tick } else { 2.0 * tick }),
    }
}

/// The rest between halves of different times: twice the positive root x of `(slower+x)*(ways+4*x/3) = 2*delta`.
fn uneven(ways: f64, slower: f64, delta: f64) -> f64 {
    let missing = 2.0 * delta - slower * ways;
    let linear = ways + 4.0 * slower / 3.0;
    4.0 * missing / (linear + (linear * linear + 16.0 * missing / 3.0).sqrt())
}
