//! `FiveSegment`: a step in five segments, symmetric in time, whose acceleration is linear in each.
//!
//! ```text
//!    a0    /\
//!    a1   /  `--.
//!     0 _/       \        _
//!   -a1           `--.  /
//!   -a0               \/
//!       t0  t1  t2  t1 t0
//! ```

use closedform_kernels::five_segment;

use super::check::{finite, in_range, positive};
use super::single;
use super::units::Units;
use crate::error::PlanError;
use crate::motion::{Limits, Motion};
use crate::segment::State;

/// A step to plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FiveSegment {
    /// The whole travel, in m.
    pub delta_x: f64,
    /// Twice the travel of the first segment, as a fraction of the whole.
    pub ki: f64,
    /// What else is given.
    pub given: FiveSegmentBy,
    /// What the axis may do.
    pub limits: Limits,
}

/// What else is given of a step in five segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FiveSegmentBy {
    /// Accelerations after the first and the second segment, and the time of the second.
    Accelerations {
        /// In m/s², positive.
        a0: f64,
        /// In m/s², of either sign.
        a1: f64,
        /// In s.
        t1: f64,
    },
    /// The times of the first three segments.
    Times {
        /// In s.
        t0: f64,
        /// In s.
        t1: f64,
        /// In s.
        t2: f64,
    },
}

/// A planned step.
#[derive(Debug, Clone, PartialEq)]
pub struct FiveSegmentPlan {
    /// Time of the first and of the last segment, in s.
    pub t0: f64,
    /// Time of the second and of the fourth segment, in s.
    pub t1: f64,
    /// Time of the segment in the middle, in s.
    pub t2: f64,
    /// Acceleration after the first segment, in m/s².
    pub a0: f64,
    /// Acceleration after the second segment, in m/s².
    pub a1: f64,
    /// Velocity after the first segment, in m/s.
    pub v0: f64,
    /// Velocity after the second segment, in m/s.
    pub v1: f64,
    /// Twice the travel of the first segment, as a fraction of the whole.
    pub ki: f64,
    /// Twice the travel of the first two segments, as a fraction of the whole.
    pub ko: f64,
    motion: Motion,
}

impl FiveSegmentPlan {
    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.motion.duration()
    }

    /// One axis, `step`.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }
}

impl FiveSegment {
    /// A step without limits.
    #[must_use]
    pub fn new(delta_x: f64, ki: f64, given: FiveSegmentBy) -> Self {
        Self { delta_x, ki, given, limits: Limits::NONE }
    }

    /// Plans it.
    ///
    /// # Errors
    ///
    /// An input that is not a positive (`a1`: any) finite number; accelerations or times with which the first segments
    /// make more than half the travel or the axis would run backwards; a limit that the move passes; numbers beyond the
    /// range of `f64`.
    pub fn plan(&self) -> Result<FiveSegmentPlan, PlanError> {
        positive("delta_x", self.delta_x)?;
        positive("ki", self.ki)?;
        single::check_limits(&self.limits)?;
        match self.given {
            FiveSegmentBy::Accelerations { a0, a1, t1 } => self.by_accelerations(a0, a1, t1),
            FiveSegmentBy::Times { t0, t1, t2 } => self.by_times(t0, t1, t2),
        }
    }

    fn by_accelerations(&self, a0: f64, a1: f64, t1: f64) -> Result<FiveSegmentPlan, PlanError> {
        positive("a0", a0)?;
        finite("a1", a1)?;
        positive("t1", t1)?;
        let units = Units::of(self.delta_x, t1);
        let [b0, b1] = [a0, a1].map(|a| units.within(a, 1, -2));
        let [delta_x, t] = [units.within(self.delta_x, 1, 0), units.within(t1, 0, 1)];
        // the kernel multiplies such products with each other
        in_range("the square of ki*a0*t1^2/delta_x", &[self.ki * b0 * (self.ki * b0)])?;
        let m = five_segment::by_accelerations(delta_x, self.ki, b0, b1, t);
        if m.t2.is_nan() {
            return Err(self.no_accelerations(a0, a1, t1));
        }
        let [t0, t2] = [m.t0, m.t2].map(|t| units.outside(t, 0, 1));
        self.planned([t0, t1, t2], [a0, a1], [m.v0, m.v1].map(|v| units.outside(v, 1, -1)), m.ko)
    }

    /// Why there is no move of these accelerations.
    fn no_accelerations(&self, a0: f64, a1: f64, t1: f64) -> PlanError {
        let s = (3.0 * self.delta_x * self.ki * a0).sqrt();
        let first = self.delta_x * self.ki + t1 * ((a1 + 2.0 * a0) * t1 + 3.0 * s) / 3.0;
        let v1 = ((a0 + a1) * t1 + s) / 2.0;
        if v1 <= 0.0 {
            let remedy =
                "the axis would run backwards after the second segment: give a larger a1 or ki, or a smaller t1";
            return PlanError::Limit { name: "a1", limit: a1, needed: -(a0 + s / t1), unit: "m/s^2", remedy };
        }
        if first >= self.delta_x {
            let remedy =
                "the first and the last two segments alone make this: give more travel, or a smaller ki, a0 or t1";
            return PlanError::Limit { name: "delta_x", limit: self.delta_x, needed: first, unit: "m", remedy };
        }
        let needed = -1.5 * v1 * v1 / (self.delta_x - first);
        let remedy = "the axis would stop before the middle of the travel: give a larger a1 or ki, or less travel";
        PlanError::Limit { name: "a1", limit: a1, needed, unit: "m/s^2", remedy }
    }

    fn by_times(&self, t0: f64, t1: f64, t2: f64) -> Result<FiveSegmentPlan, PlanError> {
        positive("t0", t0)?;
        positive("t1", t1)?;
        positive("t2", t2)?;
        let units = Units::of(self.delta_x, t0);
        let [s0, s1, s2] = [t0, t1, t2].map(|t| units.within(t, 0, 1));
        in_range("the square of (t1+t2)/t0", &[(s1 + s2) * (s1 + s2), s1, s2])?;
        let m = five_segment::by_times(units.within(self.delta_x, 1, 0), self.ki, s0, s1, s2);
        if m.a0.is_nan() {
            let limit = 2.0 * (t0 / (t0 + t1)) * (t0 / (2.0 * (t0 + t1) + t2));
            let remedy = "the axis would run backwards in the middle: give a smaller ki, or a longer t0";
            return Err(PlanError::Limit { name: "ki", limit, needed: self.ki, unit: "", remedy });
        }
        let accelerations = [m.a0, m.a1].map(|a| units.outside(a, 1, -2));
        self.planned([t0, t1, t2], accelerations, [m.v0, m.v1].map(|v| units.outside(v, 1, -1)), m.ko)
    }

    fn planned(&self, t: [f64; 3], a: [f64; 2], v: [f64; 2], ko: f64) -> Result<FiveSegmentPlan, PlanError> {
        let (delta_x, ki) = (self.delta_x, self.ki);
        in_range("a time of the step", &t)?;
        in_range("a velocity or acceleration of the step", &[a[0], v[0], v[1]])?;
        let [x0, x1] = [delta_x * (ki / 2.0), delta_x * (ko / 2.0)];
        let state = |position, velocity, acceleration| State { position, velocity, acceleration };
        let states = [
            State::rest(0.0),
            state(x0, v[0], a[0]),
            state(x1, v[1], a[1]),
            state(delta_x - x1, v[1], -a[1]),
            state(delta_x - x0, v[0], -a[0]),
            State::rest(delta_x),
        ];
        let times = [t[0], t[1], t[2], t[1], t[0]];
        let pieces: Vec<_> =
            times.iter().zip(states.windows(2)).map(|(&time, pair)| (time, pair[0], pair[1])).collect();
        let motion = single::motion("step", &pieces, self.limits)?;
        Ok(FiveSegmentPlan { t0: t[0], t1: t[1], t2: t[2], a0: a[0], a1: a[1], v0: v[0], v1: v[1], ki, ko, motion })
    }
}
