//! A move stretched to a given time: from rest to rest the same, slower; between velocities with another velocity between.

use super::between::Course;
use super::ramp::Ramp;
use super::single::Fastest;
use crate::error::PlanError;
use crate::motion::Limits;
use crate::plan::check::positive;

impl Fastest {
    /// The same move in a given time, which must not be shorter.
    ///
    /// From rest to rest velocities, accelerations and jerks are all smaller. Between velocities the move goes on for
    /// longer at another velocity, between 0 and that of the fastest move.
    ///
    /// # Errors
    ///
    /// The time is shorter than the fastest move, or no velocity between makes the move take it.
    pub fn stretched(&self, time: f64) -> Result<Self, PlanError> {
        positive("time", time)?;
        let fastest = self.duration();
        if time < fastest {
            let remedy = "the limits allow no shorter time: give this much or more, or raise a limit";
            return Err(PlanError::Limit { name: "time", limit: time, needed: fastest, unit: "s", remedy });
        }
        if time == fastest {
            return Ok(*self);
        }
        let within = self.units.within(time, 0, 1);
        let is_resting = self.start.velocity == 0.0 && self.end.velocity == 0.0;
        let course = if is_resting {
            self.course.slower(within / self.course.time())
        } else {
            let none = PlanError::Input {
                name: "time",
                value: time,
                remedy: "a move between these velocities cannot be stretched to this time: give another, or other velocities",
            };
            self.between(within).ok_or(none)?
        };
        Ok(Self { course, ..*self })
    }

    /// With a velocity between 0 and the largest that makes the move take this time, in the units.
    fn between(&self, time: f64) -> Option<Course> {
        let way = self.units.within(self.end.position - self.start.position, 1, 0);
        let [v0, v1] = [self.start.velocity, self.end.velocity].map(|v| self.units.within(v, 1, -1));
        let limits = Limits {
            velocity: f64::INFINITY,
            acceleration: self.units.within(self.limits.acceleration, 1, -2),
            jerk: self.units.within(self.limits.jerk, 1, -3),
        };
        let at = |velocity: f64| {
            let (first, last) = (Ramp::fastest(v0, velocity, &limits), Ramp::fastest(velocity, v1, &limits));
            let cruise = (way - first.way() - last.way()) / velocity;
            Course { first, cruise, last }
        };
        let (mut slow, mut fast) = (0.0, self.course.first.to);
        loop {
            let middle = slow + (fast - slow) / 2.0;
            let course = at(middle);
            if middle == slow || middle == fast || course.time() == time {
                // where the time jumps, or the way would have to be gone back, there is no such move
                let is_near = (course.time() - time).abs() <= 1e-9 * time;
                return (is_near && course.cruise >= 0.0).then_some(Course { cruise: course.cruise, ..course });
            }
            if course.time() < time { fast = middle } else { slow = middle }
        }
    }
}
