//! Checks that planners share: inputs that must be positive, results that must be numbers.

use crate::error::PlanError;
use crate::scale::largest;
use crate::segment::{Segment, State};

/// An input that must be positive and finite; one so small that it has lost digits is out of range.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<(), PlanError> {
    if value.is_subnormal() && value > 0.0 {
        return Err(PlanError::Range { what: name });
    }
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(PlanError::Input { name, value, remedy: "give a positive, finite number" })
}

/// An input that must be finite and not negative.
pub(crate) fn not_negative(name: &'static str, value: f64) -> Result<(), PlanError> {
    if value == 0.0 || positive(name, value).is_ok() {
        return Ok(());
    }
    Err(PlanError::Input { name, value, remedy: "give a finite number, 0 or more" })
}

/// An input that must be finite.
pub(crate) fn finite(name: &'static str, value: f64) -> Result<(), PlanError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(PlanError::Input { name, value, remedy: "give a finite number" })
}

/// Results that must be positive and finite, or a number on the way overflowed or underflowed.
pub(crate) fn in_range(what: &'static str, values: &[f64]) -> Result<(), PlanError> {
    if values.iter().all(|value| *value > 0.0 && value.is_normal()) {
        return Ok(());
    }
    Err(PlanError::Range { what })
}

/// Segments whose numbers have all their digits: none overflowed and none underflowed, jerks included, and none was
/// made from numbers that did, for each segment reaches its end.
pub(crate) fn segments_in_range(what: &'static str, segments: &[Segment]) -> Result<(), PlanError> {
    let digits = |x: f64| x.is_normal() || x == 0.0;
    let state = |s: &State| [s.position, s.velocity, s.acceleration].into_iter().all(digits);
    let reach = largest(segments.iter().flat_map(|s| [s.start.position, s.end.position, fastest(s) * s.duration]));
    let speed = largest(segments.iter().map(fastest));
    let segment = |s: &Segment| {
        let jerk = s.jerk.is_normal() || (s.jerk == 0.0 && s.start.acceleration == s.end.acceleration);
        s.duration.is_normal() && state(&s.start) && state(&s.end) && jerk && closes(s, reach, speed)
    };
    if segments.iter().all(segment) { Ok(()) } else { Err(PlanError::Range { what }) }
}

/// The larger velocity of its ends.
fn fastest(segment: &Segment) -> f64 {
    segment.start.velocity.abs().max(segment.end.velocity.abs())
}

/// That a segment reaches its end, but for 32 units in the last place of the largest number that its states are made of
/// (positions are sums of those of the whole `reach`, and of ways between them that may be longer; velocities are sums of
/// those of the whole move): kernels are good to 17, and the cut of an acceleration at its
/// limit is one of 20 at most.
fn closes(segment: &Segment, reach: f64, speed: f64) -> bool {
    const CLOSING: f64 = 32.0 * f64::EPSILON;
    let (start, end, reached, t) = (segment.start, segment.end, segment.reached(), segment.duration);
    let acceleration = start.acceleration.abs().max(end.acceleration.abs());
    let velocity = speed.max(acceleration * t);
    let position = reach.max(velocity * t);
    (reached.acceleration - end.acceleration).abs() <= CLOSING * acceleration
        && (reached.velocity - end.velocity).abs() <= CLOSING * velocity
        && (reached.position - end.position).abs() <= CLOSING * position
}
