//! Peaks: the largest velocity, acceleration and jerk of each axis against its limits.

use crate::extremes::{Extremum, Quantity};
use crate::motion::{Axis, Motion};
use crate::smoothness::Jump;

/// The largest magnitude of a quantity, and what it may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// With its sign, in the unit of the quantity, and when.
    pub at: Extremum,
    /// In the same unit; infinite where there is no limit.
    pub limit: f64,
}

impl Peak {
    /// The magnitude as a share of the limit; 0 where there is no limit.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.at.value.abs() / self.limit
    }
}

/// The peaks of one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisPeaks {
    /// Of the axis.
    pub name: String,
    /// In m/s.
    pub velocity: Peak,
    /// In m/s².
    pub acceleration: Peak,
    /// In m/s³, where the acceleration does not jump.
    pub jerk: Peak,
    /// The largest jump of the acceleration, in m/s²: between segments, and from and to rest at both ends.
    pub jump: Jump,
}

impl Axis {
    /// Its peaks against its limits.
    #[must_use]
    pub fn peaks(&self) -> AxisPeaks {
        let peak = |quantity, limit| Peak { at: self.profile.extremes(quantity).peak(), limit };
        AxisPeaks {
            name: self.name.clone(),
            velocity: peak(Quantity::Velocity, self.limits.velocity),
            acceleration: peak(Quantity::Acceleration, self.limits.acceleration),
            jerk: peak(Quantity::Jerk, self.limits.jerk),
            jump: self.profile.acceleration_jump(),
        }
    }
}

impl Motion {
    /// The peaks of all axes, in their order.
    #[must_use]
    pub fn peaks(&self) -> Vec<AxisPeaks> {
        self.axes().iter().map(Axis::peaks).collect()
    }
}
