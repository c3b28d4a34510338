//! The time of a cut in steps, the derivation's model.
//!
//! From rest, the axis that limits has after k steps the speed `a*T`, with T the time so far, and the next step takes
//! `T' - T = L/X = c/T'` with `c = n*L/a` (maxima-ref/milling_time.mac). In the unit `sqrt(c)` of time, and
//! `sqrt(a*L/n)` of speed along the cut, that is one sequence for all cuts of all machines, from rest: speed and time
//! after k steps are the same number. [`Steps`] holds it, so a long cut, or a million of short ones, costs a search each
//! instead of a loop over its steps.

use closedform_kernels::milling_time;

use super::cut::Cut;
use super::sum::Sum;
use crate::error::PlanError;

/// The most steps in which a cut may speed up: more would be a slip, 2 km in steps of 1 mm.
const MOST: usize = 1 << 20;

/// Speeding up from rest in steps of the length 1 with the acceleration 1: the time after each step, which is the speed
/// in it.
#[derive(Debug, Clone)]
pub(super) struct Steps {
    times: Vec<f64>,
    last: Sum,
}

impl Steps {
    pub(super) fn new() -> Self {
        Self { times: vec![0.0], last: Sum::default() }
    }

    /// Time of the cut in steps of this length at most, and its largest speed.
    pub(super) fn time(&mut self, cut: &Cut, step: f64) -> Result<(f64, f64), PlanError> {
        let half = cut.length / 2.0;
        let steps = (half / step).ceil().max(1.0);
        let length = half / steps;
        let unit_time = (length / cut.acceleration).sqrt();
        let unit_speed = (cut.acceleration * length).sqrt();
        if !(unit_time.is_normal() && unit_speed.is_normal()) {
            return Err(PlanError::Range { what: "the time of a step" });
        }
        let Some(speeding) = self.steps_to(cut.speed / unit_speed, steps) else {
            let remedy = "make it longer, or limit the speed: cuts of this length would take more than a million steps";
            return Err(PlanError::Input { name: "step", value: step, remedy });
        };
        let time = unit_time * self.times[speeding];
        let left = steps - speeding as f64;
        if left > 0.0 {
            return Ok((2.0 * (time + left * milling_time::step_time(length, cut.speed)), cut.speed));
        }
        Ok((2.0 * time, (unit_speed * self.times[speeding]).min(cut.speed)))
    }

    /// How many of the first `steps` steps are not faster than `speed`; none where more are asked for than are allowed.
    fn steps_to(&mut self, speed: f64, steps: f64) -> Option<usize> {
        while self.times[self.times.len() - 1] <= speed && (self.times.len() as f64) <= steps {
            if self.times.len() > MOST {
                return None;
            }
            self.last.add(step(self.last.value()));
            self.times.push(self.last.value());
        }
        let within = self.times.partition_point(|time| *time <= speed) - 1;
        Some(if within as f64 > steps { steps as usize } else { within })
    }
}

/// The time of the next step: as fast as the acceleration allows after a step of the speed `before`.
fn step(before: f64) -> f64 {
    milling_time::step_time(1.0, milling_time::step_speed(1.0, before, 1.0, 1.0))
}
