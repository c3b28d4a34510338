//! Limits of an axis, as flags.

use closedform_motion::{AxisPeaks, Limits, Motion, Peak};

/// Limits of flags: none where none is given.
pub fn limits(velocity: Option<f64>, acceleration: Option<f64>, jerk: Option<f64>) -> Limits {
    let or_none = |limit: Option<f64>| limit.unwrap_or(f64::INFINITY);
    Limits { velocity: or_none(velocity), acceleration: or_none(acceleration), jerk: or_none(jerk) }
}

/// Which limits a motion comes to, for people.
pub fn moved(motion: &Motion) -> String {
    let share = |of: fn(&AxisPeaks) -> Peak| motion.peaks().iter().map(of).any(|peak| peak.share() > FULL);
    let reached = [
        ("velocity", share(|axis| axis.velocity)),
        ("acceleration", share(|axis| axis.acceleration)),
        ("jerk", share(|axis| axis.jerk)),
    ];
    let names: Vec<&str> = reached.into_iter().filter(|(_, is_reached)| *is_reached).map(|(name, _)| name).collect();
    match names.as_slice() {
        [] => "below all limits".to_owned(),
        names => format!("at the limit of {}", names.join(", ")),
    }
}

/// What share of a limit comes to it, but for rounding.
const FULL: f64 = 1.0 - 1e-12;
