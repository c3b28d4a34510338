//! The choice of a turn-around: least overhead, as a whole or with one number given.
//!
//! In the units v1_scan and v1_scan/a1_max, with t for t_in, s for t_out, w for s/t and u for v1_diff/v1_scan, the two
//! axes meet where `(t+s)*(t+2*s) = q`, and the fly axis gives `u = t*(2-s)/(2*(s+t))`. The overhead is
//! `s + t*u/3 = s + t^2*(2-s)/(6*(s+t))`. Along the meeting its derivative has the sign of
//!
//! ```text
//! t*2*(1+w)*(1-w-4*w^2) - 2*(1+w)*(9*w^2+7*w+1)
//! ```
//!
//! which rises with t, for w falls: there is one minimum, at `t = (9*w^2+7*w+1)/(1-w-4*w^2)`. With this t,
//! `q = t^2*(1+w)*(1+2*w)` rises with w from 1 at w = 0 without limit, as w tends to (sqrt(17)-1)/8: one w for every q.
//!
//! Two conditions cut it off. 0 <= u, that is s <= 2: for q above 56+12*sqrt(21) = 111 the best is u = 0. And 2*u <= t,
//! the deceleration in t_in: below q = 3.74 the best is the edge, 2*u = t = q-2. There it holds only while the overhead
//! does not fall any more with u along 2*u = t, where the step axis has time to spare: `1 - u + 2*u^2/3` falls until u
//! = 3/4, which is q = 7/2.

use closedform_kernels::{fly_axis, optimum, turnaround};

use super::{Choice, DerivedRaster, Half};
use crate::error::PlanError;
use crate::plan::check::{in_range, not_negative, positive};
use crate::plan::units::Units;
use crate::scale::{exponent, scale};

/// What the choice depends on; velocity and accelerations lie between 1 and 2.
#[derive(Clone, Copy)]
struct Problem {
    v: f64,
    a: f64,
    d2_step: f64,
    a2_max: f64,
    delta: f64,
    units: Units,
    /// In m.
    given_step: f64,
}

/// A half with the least overhead that a choice leaves.
pub(super) fn half(scan: &DerivedRaster, v: f64, choice: Choice) -> Result<Half, PlanError> {
    let units = Units::of_motion(v, scan.a1_max);
    let a2 = exponent(scan.a2_max);
    let (d2_step, a2_max) = (units.within(scale(scan.d2_step, -a2), 0, 2), scale(scan.a2_max, -a2));
    in_range("delta, d2_step/a2_max, in units of v1_scan and a1_max,", &[d2_step])?;
    let [v, a] = [units.within(v, 1, -1), units.within(scan.a1_max, 1, -2)];
    let problem = Problem { v, a, d2_step, a2_max, delta: d2_step / a2_max, units, given_step: scan.d2_step };
    let half = match choice {
        Choice::Fastest => problem.fastest(),
        Choice::V1Diff(v1_diff) => problem.with_v1_diff(v1_diff)?,
        Choice::TOut(t_out) => problem.with_t_out(t_out)?,
        Choice::Ramp { v1_diff, t_in } => problem.with_ramp(v1_diff, t_in)?,
    };
    Ok(half.outside(units))
}

/// The half with the least overhead of the fly axis alone.
pub(super) fn alone(v: f64, a: f64) -> Half {
    Half::new(v, 0.75 * v, 1.5 * v / a, 0.25 * v / a, a)
}

impl Problem {
    fn fastest(&self) -> Half {
        let &Self { v, a, .. } = self;
        let q = 3.0 * (a / v) * (a / v) * self.delta;
        if q <= 3.5 {
            return alone(v, a);
        }
        if let Some(half) = self.without_ramp().filter(|_| q >= 56.0 + 12.0 * 21_f64.sqrt()) {
            return half;
        }
        let w = stationary(q);
        let t = (1.0 + w * (7.0 + 9.0 * w)) / (1.0 - w * (1.0 + 4.0 * w));
        if t * (1.0 + 2.0 * w) < 2.0 {
            return Half::new(v, v * (q / 2.0 - 1.0), (q - 2.0) * (v / a), (2.0 - q / 2.0) * (v / a), a);
        }
        self.meeting((2.0 - w * t) / (2.0 * (1.0 + w)) * v)
    }

    /// With no velocity lost in `t_in`, if the ramps out alone do not make the step.
    fn without_ramp(&self) -> Option<Half> {
        let t_out = 2.0 * (self.v / self.a);
        let t_in = turnaround::t_in(t_out, 0.0, self.a2_max, self.d2_step);
        t_in.is_finite().then(|| Half::new(self.v, 0.0, t_in, t_out, self.a))
    }

    /// Where both axes meet, or, if that is later, where `t_in` has the deceleration `a` at its end.
    fn meeting(&self, v1_diff: f64) -> Half {
        let &Self { v, a, .. } = self;
        let t_in = optimum::t_in(v, v1_diff, a, self.delta);
        if t_in.is_nan() { self.constant(v1_diff) } else { self.ramp(v1_diff, t_in) }
    }

    /// With the same deceleration all through `t_out`.
    fn constant(&self, v1_diff: f64) -> Half {
        let &Self { v, a, .. } = self;
        Half::new(v, v1_diff, 2.0 * v1_diff / a, (v - v1_diff) / a, a)
    }

    /// From a `t_in` that keeps the limit, but for rounding.
    fn ramp(&self, v1_diff: f64, t_in: f64) -> Half {
        let &Self { v, a, .. } = self;
        let t_out = fly_axis::turn_out(t_in, v, v1_diff, a).t_out;
        if t_out.is_nan() { self.constant(v1_diff) } else { Half::new(v, v1_diff, t_in, t_out, a) }
    }

    /// A given `v1_diff`, in the units of the problem.
    fn checked_v1_diff(&self, given: f64) -> Result<f64, PlanError> {
        not_negative("v1_diff", given)?;
        let v1_diff = self.units.within(given, 1, -1);
        if v1_diff < self.v {
            return Ok(v1_diff);
        }
        let remedy = "the fly axis cannot lose more than it has: give a v1_diff below v1_scan";
        Err(PlanError::Limit {
            name: "v1_diff",
            limit: self.units.outside(self.v, 1, -1),
            needed: given,
            unit: "m/s",
            remedy,
        })
    }

    fn with_v1_diff(&self, given: f64) -> Result<Half, PlanError> {
        let v1_diff = self.checked_v1_diff(given)?;
        if v1_diff > 0.0 {
            return Ok(self.meeting(v1_diff));
        }
        let t_out = 2.0 * (self.v / self.a);
        let remedy = "with v1_diff = 0 the ramps out alone make this step, no t_in is best: give a v1_diff above 0, \
                      a t_in too, a larger step or a smaller a2_max";
        self.without_ramp().ok_or(self.too_short(t_out, remedy))
    }

    /// That the ramps out of this time alone make more than the step.
    fn too_short(&self, t_out: f64, remedy: &'static str) -> PlanError {
        let ratio = 2.0 * t_out * t_out / (3.0 * self.delta);
        let limit = self.given_step;
        PlanError::Limit { name: "d2_step", limit, needed: limit * ratio, unit: "m", remedy }
    }

    fn with_t_out(&self, given: f64) -> Result<Half, PlanError> {
        positive("t_out", given)?;
        let t_out = self.units.within(given, 0, 1);
        let &Self { v, a, .. } = self;
        let longest = 2.0 * (v / a);
        if t_out > longest {
            let remedy = "the fly axis comes to rest sooner than this: give a smaller t_out or a smaller a1_max";
            return Err(PlanError::Limit {
                name: "t_out",
                limit: self.units.outside(longest, 0, 1),
                needed: given,
                unit: "s",
                remedy,
            });
        }
        let meeting = turnaround::t_in(t_out, 0.0, self.a2_max, self.d2_step);
        // v - a*t_out is lost with the deceleration a at the end of t_in
        let lost = (-a).mul_add(t_out, v);
        let shortest = 2.0 * lost / a;
        if lost > 0.0 && (meeting.is_nan() || meeting <= shortest) {
            return Ok(Half::of_times(v, lost, shortest, t_out, a));
        }
        if meeting.is_nan() {
            let remedy = "the ramps out of this t_out alone make this step, no t_in is best: give a smaller t_out, a \
                          larger step or a smaller a2_max";
            return Err(self.too_short(t_out, remedy));
        }
        let v1_diff = fly_axis::v1_diff(meeting, t_out, v, a);
        // NaN only where rounding puts t_out beyond its longest
        Ok(Half::of_times(v, if v1_diff.is_nan() { 0.0 } else { v1_diff }, meeting, t_out, a))
    }

    fn with_ramp(&self, v1_diff: f64, t_in: f64) -> Result<Half, PlanError> {
        positive("t_in", t_in)?;
        let t_in = self.units.within(t_in, 0, 1);
        let v1_diff = self.checked_v1_diff(v1_diff)?;
        let needed = 2.0 * v1_diff / t_in;
        if needed > self.a {
            let [limit, needed] = [self.a, needed].map(|a| self.units.outside(a, 1, -2));
            let remedy = "v1_diff is lost too fast: give a longer t_in or a smaller v1_diff";
            return Err(PlanError::Limit { name: "a1_max", limit, needed, unit: "m/s^2", remedy });
        }
        Ok(self.ramp(v1_diff, t_in))
    }
}

/// The w of the minimum: where `(9*w^2+7*w+1)^2*(1+w)*(1+2*w) = q*(1-w-4*w^2)^2`, by bisection to a float.
fn stationary(q: f64) -> f64 {
    let (mut low, mut high) = (0.0, (17_f64.sqrt() - 1.0) / 8.0);
    loop {
        let w = low + (high - low) / 2.0;
        if w <= low || w >= high {
            return w;
        }
        let (rising, falling) = (1.0 + w * (7.0 + 9.0 * w), 1.0 - w * (1.0 + 4.0 * w));
        if rising * rising * (1.0 + w) * (1.0 + 2.0 * w) < q * falling * falling { low = w } else { high = w }
    }
}
