//! The fastest move from rest to rest: which limits it comes to, and its times, as the kernels have them.

use closedform_kernels::s_curve;

use super::between::Course;
use super::ramp::Ramp;
use crate::motion::Limits;

/// The fastest along a positive way.
pub(super) fn course(d: f64, limits: &Limits) -> Course {
    let times = if limits.jerk == f64::INFINITY { trapezoid(d, limits) } else { s_curve_times(d, limits) };
    let Times { t_jerk, t_constant, cruise, peak } = times;
    let acceleration = (peak / (t_jerk + t_constant)).min(limits.acceleration);
    let first = Ramp { from: 0.0, to: peak, t_jerk, t_constant, acceleration };
    Course { first, cruise, last: Ramp { from: peak, to: 0.0, acceleration: -acceleration, ..first } }
}

/// Of a ramp, and between both.
struct Times {
    t_jerk: f64,
    t_constant: f64,
    cruise: f64,
    peak: f64,
}

/// Outside of its domain a kernel gives no number: the case that has numbers is the case of the move.
fn trapezoid(d: f64, limits: &Limits) -> Times {
    let (v, a) = (limits.velocity, limits.acceleration);
    let whole = s_curve::trapezoid_at_rest(d, v, a);
    if whole.t_cruise >= 0.0 {
        return Times { t_jerk: 0.0, t_constant: whole.t_ramp, cruise: whole.t_cruise, peak: v };
    }
    let t = s_curve::triangle_at_rest(d, a);
    Times { t_jerk: 0.0, t_constant: t, cruise: 0.0, peak: (d / t).min(v) }
}

fn s_curve_times(d: f64, limits: &Limits) -> Times {
    let Limits { velocity: v, acceleration: a, jerk: j } = *limits;
    let full = s_curve::full_move(d, v, a, j);
    if full.t_cruise >= 0.0 {
        return Times { t_jerk: full.t_jerk, t_constant: full.t_constant, cruise: full.t_cruise, peak: v };
    }
    let flat = s_curve::flat_move(d, a, j);
    if flat.t_constant >= 0.0 && flat.v_peak <= v {
        return Times { t_jerk: flat.t_jerk, t_constant: flat.t_constant, cruise: 0.0, peak: flat.v_peak };
    }
    let fast = s_curve::fast_move(d, v, j);
    if fast.t_cruise >= 0.0 {
        return Times { t_jerk: fast.t_jerk, t_constant: 0.0, cruise: fast.t_cruise, peak: v };
    }
    let t_jerk = s_curve::short_move(d, j);
    Times { t_jerk, t_constant: 0.0, cruise: 0.0, peak: (d / (2.0 * t_jerk)).min(v) }
}
