//! Least and largest values of a profile: at the ends of its segments and where a derivative passes zero between them.

use crate::profile::Profile;
use crate::segment::{Sample, Segment};

/// What of a motion is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quantity {
    /// In m, or the unit of length of the plan.
    Position,
    /// In m/s.
    Velocity,
    /// In m/s².
    Acceleration,
    /// In m/s³.
    Jerk,
}

impl Quantity {
    /// All, each the derivative of the one before.
    pub const ALL: [Self; 4] = [Self::Position, Self::Velocity, Self::Acceleration, Self::Jerk];

    /// The next one, whose zeros are the stationary points of this one.
    fn derivative(self) -> Option<Self> {
        match self {
            Self::Position => Some(Self::Velocity),
            Self::Velocity => Some(Self::Acceleration),
            Self::Acceleration => Some(Self::Jerk),
            Self::Jerk => None,
        }
    }
}

impl Quantity {
    /// Of a sample.
    #[must_use]
    pub const fn of(self, sample: &Sample) -> f64 {
        match self {
            Self::Position => sample.position,
            Self::Velocity => sample.velocity,
            Self::Acceleration => sample.acceleration,
            Self::Jerk => sample.jerk,
        }
    }
}

/// A value and when it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum {
    /// In the unit of its quantity.
    pub value: f64,
    /// In s; the first time, where there are several.
    pub time: f64,
}

/// Where a quantity is least and where it is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// The least value.
    pub least: Extremum,
    /// The largest value.
    pub largest: Extremum,
}

impl Extremes {
    /// The one of larger magnitude; of two of the same, the earlier.
    #[must_use]
    pub fn peak(&self) -> Extremum {
        let (a, b) = (self.least, self.largest);
        let (least, largest) = (a.value.abs(), b.value.abs());
        if largest > least || (largest == least && b.time <= a.time) { b } else { a }
    }

    fn include(&mut self, candidate: Extremum) {
        if candidate.value < self.least.value {
            self.least = candidate;
        }
        if candidate.value > self.largest.value {
            self.largest = candidate;
        }
    }
}

impl Profile {
    /// Least and largest value of a quantity: of what [`Profile::at`] returns, and of both sides where it jumps.
    ///
    /// Stationary points inside a segment are found by bisection between those of the next derivative, down to
    /// neighbouring floats; an error of the time there enters the value by its square only.
    #[must_use]
    pub fn extremes(&self, quantity: Quantity) -> Extremes {
        let start = Extremum { value: quantity.of(&self.segments()[0].at(0.0)), time: 0.0 };
        let mut extremes = Extremes { least: start, largest: start };
        for (segment, begin) in self.segments().iter().zip(self.times()) {
            let inside = quantity.derivative().map_or_else(Vec::new, |next| zeros(segment, next));
            for time in [0.0].into_iter().chain(inside).chain([segment.duration]) {
                extremes.include(Extremum { value: quantity.of(&segment.at(time)), time: begin + time });
            }
        }
        extremes
    }
}

/// The times inside a segment where a quantity changes sign, in order.
fn zeros(segment: &Segment, quantity: Quantity) -> Vec<f64> {
    let value = |time: f64| quantity.of(&segment.at(time));
    // Between the zeros of its derivative it is monotonic: it changes sign once at most. The highest, jerk, is linear.
    let mut found = Vec::new();
    let mut low = 0.0;
    let turning = quantity.derivative().map_or_else(Vec::new, |next| zeros(segment, next));
    for high in turning.into_iter().chain([segment.duration]) {
        if value(low) * value(high).signum() < 0.0 {
            found.push(bisect(value, low, high));
        } else if value(high) == 0.0 && high < segment.duration {
            found.push(high);
        }
        low = high;
    }
    found
}

/// Where a function that changes sign between two times changes it, to a float.
fn bisect(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let rising = value(low) < 0.0;
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return high;
        }
        if (value(middle) < 0.0) == rising { low = middle } else { high = middle }
    }
}
