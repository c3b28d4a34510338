//! Units of length and time that are powers of two: a planner computes in them near 1, where squares neither overflow
//! nor underflow, and no digit changes.

use crate::scale::{exponent, scale};

/// Powers of two that are 1 where a planner computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Units {
    length: i32,
    time: i32,
}

impl Units {
    /// A length and a time that come to lie between 1 and 2.
    pub(crate) fn of(length: f64, time: f64) -> Self {
        Self { length: exponent(length), time: exponent(time) }
    }

    /// A velocity and an acceleration that come to lie between 1 and 2.
    pub(crate) fn of_motion(velocity: f64, acceleration: f64) -> Self {
        let time = exponent(velocity) - exponent(acceleration);
        Self { length: exponent(velocity) + time, time }
    }

    /// A number of the unit m^length*s^time in these units.
    pub(crate) fn within(self, x: f64, length: i32, time: i32) -> f64 {
        scale(x, -(length * self.length + time * self.time))
    }

    /// A number of these units in the unit m^length*s^time.
    pub(crate) fn outside(self, x: f64, length: i32, time: i32) -> f64 {
        scale(x, length * self.length + time * self.time)
    }
}
