//! Limits of an axis, as flags.

use closedform_motion::{AxisPeaks, Limits, Motion, Peak};

use crate::error::{Failure, Outcome};

/// Limits of the flags `v-max`, `a-max` and `j-max`, behind what their names begin with: none where none is given.
pub fn limits(prefix: &str, velocity: Option<f64>, acceleration: Option<f64>, jerk: Option<f64>) -> Outcome<Limits> {
    let or_none = |name: &str, limit: Option<f64>| match limit {
        Some(limit) if limit.is_nan() || limit <= 0.0 => {
            Err(Failure(format!("{prefix}{name} is {limit}: give a positive limit, or leave it out for none")))
        }
        limit => Ok(limit.unwrap_or(f64::INFINITY)),
    };
    Ok(Limits {
        velocity: or_none("v-max", velocity)?,
        acceleration: or_none("a-max", acceleration)?,
        jerk: or_none("j-max", jerk)?,
    })
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
