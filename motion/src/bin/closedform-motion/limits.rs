//! Limits of an axis, as flags.

use closedform_motion::Limits;

/// Limits of flags: none where none is given.
pub fn limits(velocity: Option<f64>, acceleration: Option<f64>, jerk: Option<f64>) -> Limits {
    let or_none = |limit: Option<f64>| limit.unwrap_or(f64::INFINITY);
    Limits { velocity: or_none(velocity), acceleration: or_none(acceleration), jerk: or_none(jerk) }
}
