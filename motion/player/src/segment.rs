//! A segment: a stretch of one axis along one polynomial, of the fourth degree at most.

/// Where an axis is, how fast, and how that changes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// In m, or the unit of length of the plan.
    pub position: f64,
    /// In m/s.
    pub velocity: f64,
    /// In m/s².
    pub acceleration: f64,
}

impl State {
    /// At rest.
    #[must_use]
    pub const fn rest(position: f64) -> Self {
        Self { position, velocity: 0.0, acceleration: 0.0 }
    }

    /// At constant velocity.
    #[must_use]
    pub const fn cruise(position: f64, velocity: f64) -> Self {
        Self { position, velocity, acceleration: 0.0 }
    }

    /// The state after `time` (before, where it is negative) with this jerk at its begin and this constant snap.
    fn after(self, time: f64, jerk: f64, snap: f64) -> Self {
        let acceleration = self.acceleration + time * (jerk + time * (snap / 2.0));
        let velocity = self.velocity + time * (self.acceleration + time * (jerk / 2.0 + time * (snap / 6.0)));
        let rise = self.acceleration / 2.0 + time * (jerk / 6.0 + time * (snap / 24.0));
        Self { position: self.position + time * (self.velocity + time * rise), velocity, acceleration }
    }
}

/// A state and its jerk, at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    /// In m, or the unit of length of the plan.
    pub position: f64,
    /// In m/s.
    pub velocity: f64,
    /// In m/s².
    pub acceleration: f64,
    /// In m/s³.
    pub jerk: f64,
}

impl From<Sample> for State {
    fn from(sample: Sample) -> Self {
        Self { position: sample.position, velocity: sample.velocity, acceleration: sample.acceleration }
    }
}

/// A stretch of one axis along one polynomial: its states at both ends, and between them constant snap, mostly none.
///
/// Both states are kept, and a time is evaluated from the nearer one: the ends are exactly what the planner said.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// In s, not negative.
    pub duration: f64,
    /// At time 0.
    pub start: State,
    /// At time `duration`: what the polynomial reaches, up to rounding.
    pub end: State,
    /// In m/s³, at time 0.
    pub jerk: f64,
    /// In m/s⁴: how the jerk changes.
    pub snap: f64,
}

impl Segment {
    /// From a state, with constant jerk.
    #[must_use]
    pub fn with_jerk(start: State, duration: f64, jerk: f64) -> Self {
        Self::with_snap(start, duration, jerk, 0.0)
    }

    /// From a state, with constant snap.
    #[must_use]
    pub fn with_snap(start: State, duration: f64, jerk: f64, snap: f64) -> Self {
        Self { duration, start, end: start.after(duration, jerk, snap), jerk, snap }
    }

    /// Between two states that constant jerk joins, as the planner has them: the jerk is what the accelerations need.
    #[must_use]
    pub fn between(start: State, end: State, duration: f64) -> Self {
        let jerk = if duration > 0.0 { (end.acceleration - start.acceleration) / duration } else { 0.0 };
        Self { duration, start, end, jerk, snap: 0.0 }
    }

    /// What the polynomial reaches from the start: `end`, up to rounding.
    #[must_use]
    pub fn reached(&self) -> State {
        self.start.after(self.duration, self.jerk, self.snap)
    }

    /// The state and jerk at a time from 0 to `duration`.
    #[must_use]
    pub fn at(&self, time: f64) -> Sample {
        let left = self.duration - time;
        let jerk = self.jerk + self.snap * time;
        let state = if time <= left {
            self.start.after(time, self.jerk, self.snap)
        } else {
            self.end.after(-left, self.jerk + self.snap * self.duration, self.snap)
        };
        Sample { position: state.position, velocity: state.velocity, acceleration: state.acceleration, jerk }
    }
}
