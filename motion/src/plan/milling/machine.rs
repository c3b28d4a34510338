//! What a milling machine can do.

use crate::error::PlanError;

/// The limits of a machine. Every speed limit may be `f64::INFINITY`, where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// Largest acceleration of the axes X, Y and Z, in mm/s².
    pub acceleration: [f64; 3],
    /// Largest speed of the axes X, Y and Z, in mm/s.
    pub speed: [f64; 3],
    /// Speed along the path of a rapid move (G0), in mm/s, where the axes allow it.
    pub rapid: f64,
    /// Largest feed along the path, in mm/s; a larger one (F) is cut to it.
    pub feed: f64,
}

impl Default for Machine {
    /// A small router: 500 mm/s² in all axes, rapid moves with 100 mm/s (6 m/min), and no limit of the feed.
    fn default() -> Self {
        Self { acceleration: [500.0; 3], speed: [f64::INFINITY; 3], rapid: 100.0, feed: f64::INFINITY }
    }
}

impl Machine {
    /// Whether all limits are positive.
    pub(super) fn check(&self) -> Result<(), PlanError> {
        for (index, value) in self.acceleration.into_iter().enumerate() {
            if !(value > 0.0 && value.is_finite()) {
                let remedy = "make it positive and finite";
                return Err(PlanError::Item { item: "axis", index, name: "acceleration limit", value, remedy });
            }
        }
        for (index, value) in self.speed.into_iter().enumerate() {
            if value.is_nan() || value <= 0.0 {
                let remedy = "make it positive, or infinite where there is none";
                return Err(PlanError::Item { item: "axis", index, name: "speed limit", value, remedy });
            }
        }
        for (name, value) in [("rapid speed", self.rapid), ("feed limit", self.feed)] {
            if value.is_nan() || value <= 0.0 {
                let remedy = "make it positive, or infinite where there is none";
                return Err(PlanError::Input { name, value, remedy });
            }
        }
        Ok(())
    }
}
