//! The fastest timing of a path under limits: one factor for all durations, and then, if they may change, each by itself.
//!
//! With all durations k times as long a path is the same, and velocities are k times smaller, accelerations k^2 and jerks k^3
//! times. So the least k that keeps all limits is known from the peaks of any timing, and the whole time, k times the sum of
//! the durations, depends on their ratios only: a search changes one after the other.

use super::{Freedom, WaypointPlan};
use crate::error::PlanError;

/// By how much the search changes a duration at first, and when it stops.
const STEPS: (f64, f64) = (0.3, 1e-4);

/// So many segments are looked at, at most, in all of the search.
const MOST: usize = 4_000_000;

/// The plan of the durations that take the least time.
pub(super) fn durations(
    first: Vec<f64>,
    freedom: Freedom,
    shaped: impl Fn(&[f64]) -> Result<WaypointPlan, PlanError>,
) -> Result<WaypointPlan, PlanError> {
    let best = match freedom {
        Freedom::Factor => first,
        Freedom::Segments => searched(first, &shaped)?,
    };
    let mut factor = shaped(&best)?.factor()?;
    // the peaks of the scaled path are rounded in another way
    for _ in 0..8 {
        let scaled: Vec<f64> = best.iter().map(|time| time * factor).collect();
        let plan = shaped(&scaled)?;
        if plan.factor()? <= 1.0 {
            return Ok(plan);
        }
        factor *= 1.0 + 4.0 * f64::EPSILON;
    }
    let scaled: Vec<f64> = best.iter().map(|time| time * factor * (1.0 + 1e-12)).collect();
    shaped(&scaled)
}

/// Durations whose ratios take less time, by trying each longer and shorter.
fn searched(
    mut best: Vec<f64>,
    shaped: &impl Fn(&[f64]) -> Result<WaypointPlan, PlanError>,
) -> Result<Vec<f64>, PlanError> {
    let whole = |times: &[f64]| Ok::<f64, PlanError>(shaped(times)?.factor()? * times.iter().sum::<f64>());
    let mut least = whole(&best)?;
    let (mut step, mut left) = (STEPS.0, MOST / best.len().max(1));
    while step > STEPS.1 && left > 0 {
        let before = least;
        for index in 0..best.len() {
            for by in [1.0 + step, 1.0 / (1.0 + step)] {
                let kept = best[index];
                best[index] = kept * by;
                let time = whole(&best)?;
                left = left.saturating_sub(1);
                if time < least { least = time } else { best[index] = kept }
            }
        }
        if least > before * (1.0 - 1e-3 * step) {
            step /= 2.0;
        }
    }
    Ok(best)
}

impl WaypointPlan {
    /// How many times as long it must take to keep all limits, or may.
    fn factor(&self) -> Result<f64, PlanError> {
        let mut factor = 0.0_f64;
        for axis in self.motion().axes() {
            let (peaks, smoothness) = (axis.peaks(), axis.profile.smoothness());
            if smoothness.velocity.size != 0.0 && axis.limits.acceleration.min(axis.limits.jerk).is_finite() {
                let remedy =
                    "the velocity jumps at each inner point: give only velocities as limits, or another problem";
                let needed = f64::INFINITY;
                return Err(PlanError::Limit {
                    name: "acceleration",
                    limit: axis.limits.acceleration,
                    needed,
                    unit: "m/s^2",
                    remedy,
                });
            }
            super::check_jump(axis)?;
            let share = [peaks.velocity.share(), peaks.acceleration.share().sqrt(), peaks.jerk.share().cbrt()];
            factor = share.into_iter().fold(factor, f64::max);
        }
        if factor > 0.0 && factor.is_finite() {
            Ok(factor)
        } else {
            Err(PlanError::Range { what: "the time of the path" })
        }
    }
}
