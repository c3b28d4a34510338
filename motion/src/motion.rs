//! A motion: several axes on one clock.

use crate::profile::Profile;
use crate::segment::State;

/// What an axis may do; `f64::INFINITY` where there is no limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// In m/s.
    pub velocity: f64,
    /// In m/s².
    pub acceleration: f64,
    /// In m/s³.
    pub jerk: f64,
}

impl Limits {
    /// No limits.
    pub const NONE: Self = Self { velocity: f64::INFINITY, acceleration: f64::INFINITY, jerk: f64::INFINITY };
}

/// One axis of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// As tables and pictures call it.
    pub name: String,
    /// What it does.
    pub profile: Profile,
    /// What it may do.
    pub limits: Limits,
}

/// The states of all axes at one time: a row of a PVT table.
#[derive(Debug, Clone, PartialEq)]
pub struct Knot {
    /// In s.
    pub time: f64,
    /// In the order of the axes.
    pub states: Vec<State>,
}

/// Several axes on one clock.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    axes: Vec<Axis>,
}

impl Motion {
    /// Axes that start together. One that ends before the others stays where it is.
    #[must_use]
    pub fn new(axes: Vec<Axis>) -> Self {
        Self { axes }
    }

    /// The axes.
    #[must_use]
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Of the axis that takes longest, in s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.axes.iter().map(|axis| axis.profile.duration()).fold(0.0, f64::max)
    }

    /// The states of all axes at a time, each as [`Profile::at`].
    #[must_use]
    pub fn at(&self, time: f64) -> Knot {
        let state = |axis: &Axis| State::from(axis.profile.at(time));
        Knot { time, states: self.axes.iter().map(state).collect() }
    }

    /// The times at which a segment of any axis starts or ends, in order, each once, in s.
    ///
    /// Times closer than 4 units in the last place of the duration are one: the sums of durations differ by no more
    /// where axes are meant to go on together.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.axes.iter().flat_map(|axis| axis.profile.times()).copied().collect();
        times.sort_by(f64::total_cmp);
        let same = 4.0 * f64::EPSILON * self.duration();
        times.dedup_by(|later, kept| {
            let repeated = later == kept || (*kept > 0.0 && *later - *kept <= same);
            if repeated {
                *kept = *later;
            }
            repeated
        });
        times
    }
}
