//! Moves of one axis: states and times between them become a motion, checked against limits.

use crate::error::PlanError;
use crate::motion::{Axis, Limits, Motion};
use crate::peaks::Peak;
use crate::plan::check::segments_in_range;
use crate::profile::Profile;
use crate::segment::{Segment, State};

/// What kernels (at most 17 ulp) and evaluation of the polynomial may add to a value that meets its limit exactly.
const SLACK: f64 = 24.0 * f64::EPSILON;

/// Segments between given states, as the profile of one axis; an error if it passes a limit.
pub(crate) fn motion(name: &str, pieces: &[(f64, State, State)], limits: Limits) -> Result<Motion, PlanError> {
    let what = "a time, velocity, acceleration or jerk of the move";
    let segment = |&(duration, start, end): &(f64, State, State)| Segment::between(start, end, duration);
    let segments: Vec<Segment> = pieces.iter().map(segment).collect();
    segments_in_range(what, &segments)?;
    let profile = Profile::new(segments).map_err(|_| PlanError::Range { what })?;
    let axis = Axis { name: name.into(), profile, limits };
    check(&axis)?;
    Ok(Motion::new(vec![axis]))
}

fn check(axis: &Axis) -> Result<(), PlanError> {
    let peaks = axis.peaks();
    let quantities = [
        (peaks.velocity, "velocity", "m/s", "give it more time or less distance"),
        (peaks.acceleration, "acceleration", "m/s^2", "give it more time or less distance"),
        (peaks.jerk, "jerk", "m/s^3", "give its ramps more time"),
    ];
    for (Peak { at, limit }, name, unit, remedy) in quantities {
        let needed = at.value.abs();
        if needed > limit * (1.0 + SLACK) {
            return Err(PlanError::Limit { name, limit, needed, unit, remedy });
        }
    }
    if axis.limits.jerk.is_finite() && peaks.jump.size != 0.0 {
        let (limit, jump, time) = (axis.limits.jerk, peaks.jump.size.abs(), peaks.jump.time);
        let remedy = "no jerk makes a jump: leave out the limit of the jerk, or take a shape without jumps";
        return Err(PlanError::Jump { limit, jump, time, remedy });
    }
    Ok(())
}

/// That limits are positive or infinite.
pub(crate) fn check_limits(limits: &Limits) -> Result<(), PlanError> {
    let all = [("velocity", limits.velocity), ("acceleration", limits.acceleration), ("jerk", limits.jerk)];
    match all.into_iter().find(|(_, value)| value.is_nan() || *value <= 0.0) {
        Some((name, value)) => {
            Err(PlanError::Input { name, value, remedy: "give a positive limit, or an infinite one for none" })
        }
        None => Ok(()),
    }
}
