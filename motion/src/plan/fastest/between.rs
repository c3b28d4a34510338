//! The largest velocity of the fastest move along a way between two velocities, without acceleration at its ends.
//!
//! The move speeds up in one ramp, may go on at the largest velocity of the limits, and slows down in another. Its way D
//! by its largest velocity v is convex where it falls (worksheet `s_curve`), so beyond the way of the direct ramp one v
//! has D(v) = d: that where D - d changes its sign. Kernels say it where the jerk has no limit, where both ramps come to the
//! largest acceleration, and between equal velocities where neither does; elsewhere it is enclosed between two numbers, in
//! this file alone.

use closedform_kernels::s_curve;

use super::ramp::Ramp;
use crate::motion::Limits;

/// What rounding may add to a way by the time of a ramp and the mean of two velocities, and to that of two positions: the
/// kernels are good to 3 ulp, and some roundings follow.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A move from one velocity to another: ramp, time at the velocity between, and ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Course {
    pub first: Ramp,
    pub cruise: f64,
    pub last: Ramp,
}

impl Course {
    /// By way of a velocity.
    fn by_way_of(v0: f64, v1: f64, peak: f64, limits: &Limits) -> Self {
        Self { first: Ramp::fastest(v0, peak, limits), cruise: 0.0, last: Ramp::fastest(peak, v1, limits) }
    }

    /// By way of a velocity that exceeds the larger one of both by so much.
    fn above(v0: f64, v1: f64, rise: f64, limits: &Limits) -> Self {
        let base = v0.max(v1);
        let ramp = |v: f64| Ramp::of_change(v, base + rise, rise + (base - v), limits);
        Self { first: ramp(v0), cruise: 0.0, last: ramp(v1).reversed() }
    }

    /// In s.
    pub(crate) fn time(&self) -> f64 {
        self.first.time() + self.cruise + self.last.time()
    }

    /// In m.
    pub(crate) fn way(&self) -> f64 {
        self.first.way() + self.first.to * self.cruise + self.last.way()
    }

    /// The fastest along `d`, which is known but for `noise`: what is no more off the way of the direct ramp is that ramp,
    /// for a way that misses it by the least bit may take much longer.
    pub(crate) fn fastest(d: f64, v0: f64, v1: f64, noise: f64, limits: &Limits) -> Self {
        let ramp = Ramp::fastest(v0, v1, limits);
        let direct = ramp.way();
        if (d - direct).abs() <= ROUNDING * (noise + v0.abs().max(v1.abs()) * ramp.time()) {
            return Self::by_way_of(v0, v1, v1, limits);
        }
        // The other direction is this one, mirrored.
        if d < direct { Self::beyond(-d, -v0, -v1, limits).mirrored() } else { Self::beyond(d, v0, v1, limits) }
    }

    /// Along a way that is longer than that of the direct ramp.
    fn beyond(d: f64, v0: f64, v1: f64, limits: &Limits) -> Self {
        if limits.velocity.is_finite() {
            let most = Self::by_way_of(v0, v1, limits.velocity, limits);
            let left = d - most.way();
            if left >= 0.0 {
                return Self { cruise: left / limits.velocity, ..most };
            }
        }
        let rise = known_rise(d, v0.max(v1), (v0 - v1).abs(), limits);
        Self::above(v0, v1, rise.unwrap_or_else(|| enclosed_rise(d, v0, v1, limits)), limits)
    }

    pub(super) fn mirrored(self) -> Self {
        Self { first: self.first.mirrored(), cruise: self.cruise, last: self.last.mirrored() }
    }

    /// In so many times the time, from rest to rest.
    pub(super) fn slower(self, times: f64) -> Self {
        Self { first: self.first.slower(times), cruise: self.cruise * times, last: self.last.slower(times) }
    }
}

/// By how much the largest velocity exceeds the larger one of both ends, where a kernel says it. Outside of its domain it
/// gives no number.
fn known_rise(d: f64, v: f64, w: f64, limits: &Limits) -> Option<f64> {
    let (a, j) = (limits.acceleration, limits.jerk);
    if j == f64::INFINITY {
        return Some(s_curve::triangle_rise(v, w, d, a)).filter(|rise| rise.is_finite());
    }
    let flat = s_curve::flat_rise(v, w, d, a, j);
    if flat >= a * (a / j) {
        return Some(flat);
    }
    let t = if w == 0.0 { s_curve::pointed_move(v, d, j) } else { f64::NAN };
    (t * j <= a).then_some(j * t * t)
}

/// The same by a sign that changes: Newton's steps where they stay between the bounds and at least halve, and else halves
/// of what lies between the bounds, until no number does.
fn enclosed_rise(d: f64, v0: f64, v1: f64, limits: &Limits) -> f64 {
    let missing = |rise: f64| {
        let course = Course::above(v0, v1, rise, limits);
        (course.way() - d, course.first.growth(limits) + course.last.reversed().growth(limits))
    };
    let (mut low, mut high) = (0.0, rise_above(d, v0.max(v1), limits, |rise| missing(rise).0 >= 0.0));
    let (mut rise, mut last) = (high, high);
    loop {
        let (off, slope) = missing(rise);
        if off < 0.0 {
            low = rise
        } else {
            high = rise
        }
        let (newton, middle) = (rise - off / slope, low + (high - low) / 2.0);
        let is_good = newton > low && newton < high && (newton - rise).abs() <= last / 2.0;
        let next = if is_good { newton } else { middle };
        if off == 0.0 || next == rise || middle <= low || middle >= high {
            return rise;
        }
        last = (next - rise).abs();
        rise = next;
    }
}

/// A rise with which the move makes its way, or more.
fn rise_above(d: f64, base: f64, limits: &Limits, makes: impl Fn(f64) -> bool) -> f64 {
    if limits.velocity.is_finite() {
        return limits.velocity - base;
    }
    let alone = (limits.acceleration * d.abs()).sqrt().min((limits.jerk * d.abs() * d.abs()).cbrt());
    let mut rise = base.abs().max(alone);
    while !makes(rise) {
        rise *= 2.0;
    }
    rise
}
