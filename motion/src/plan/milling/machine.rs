//! What a milling machine can do.

use crate::error::PlanError;

/// The limits of a machine. Every speed limit may be `f64::INFINITY`, where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// Largest acceleration of the axes X, Y and Z, in mm/s².
    pub acceleration: [f64; 3],
    /// Largest speed of the axes X, Y and Z, in mm/s.
    pub speed: [f64; 3],
    /// Largest acceleration of the axes A, B, C (in degrees/s²), U, V, W and E (in mm/s²).
    pub other_acceleration: [f64; 7],
    /// Their largest speed, in degrees/s and mm/s.
    pub other_speed: [f64; 7],
    /// Largest acceleration along the path, in mm/s²: of moves that cut or print, of rapid ones, and of E alone. Infinite
    /// where the axes alone limit it.
    pub path_acceleration: [f64; 3],
    /// Speed along the path of a rapid move (G0), in mm/s, where the axes allow it.
    pub rapid: f64,
    /// Largest feed along the path, in mm/s; a larger one (F) is cut to it.
    pub feed: f64,
    /// How long a tool change takes, in s.
    pub tool_change: f64,
    /// How long the spindle takes to come to its speed, in s.
    pub spindle_start: f64,
}

impl Default for Machine {
    /// A small router: 500 mm/s² (degrees/s²) in all axes, rapid moves with 100 mm/s (6 m/min), no limit of the feed, and
    /// no time for tools and spindle.
    fn default() -> Self {
        Self {
            acceleration: [500.0; 3],
            speed: [f64::INFINITY; 3],
            other_acceleration: [500.0; 7],
            other_speed: [f64::INFINITY; 7],
            path_acceleration: [f64::INFINITY; 3],
            rapid: 100.0,
            feed: f64::INFINITY,
            tool_change: 0.0,
            spindle_start: 0.0,
        }
    }
}

impl Machine {
    /// Marlin's default settings: 3000 mm/s² along the path, 100 mm/s² in Z, 10,000 mm/s² of E; 300 mm/s, 5 mm/s in Z, 25
    /// mm/s of E.
    #[must_use]
    pub fn printer() -> Self {
        let mut printer = Self {
            acceleration: [3000.0, 3000.0, 100.0],
            speed: [300.0, 300.0, 5.0],
            path_acceleration: [3000.0; 3],
            rapid: 300.0,
            ..Self::default()
        };
        (printer.other_acceleration[6], printer.other_speed[6]) = (10_000.0, 25.0);
        printer
    }

    /// Whether all limits are positive.
    pub(super) fn check(&self) -> Result<(), PlanError> {
        for (index, value) in self.acceleration.into_iter().chain(self.other_acceleration).enumerate() {
            if !(value > 0.0 && value.is_finite()) {
                let remedy = "make it positive and finite";
                return Err(PlanError::Item { item: "axis", index, name: "acceleration limit", value, remedy });
            }
        }
        let remedy = "make it positive, or infinite where there is none";
        for (index, value) in self.speed.into_iter().chain(self.other_speed).enumerate() {
            if value.is_nan() || value <= 0.0 {
                return Err(PlanError::Item { item: "axis", index, name: "speed limit", value, remedy });
            }
        }
        let [print, travel, retract] = self.path_acceleration;
        let others = [
            ("rapid speed", self.rapid),
            ("feed limit", self.feed),
            ("acceleration along the path", print),
            ("acceleration of rapid moves", travel),
            ("acceleration of E", retract),
        ];
        for (name, value) in others {
            if value.is_nan() || value <= 0.0 {
                return Err(PlanError::Input { name, value, remedy });
            }
        }
        for (name, value) in [("time of a tool change", self.tool_change), ("time of the spindle", self.spindle_start)]
        {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(PlanError::Input { name, value, remedy: "make it 0 or positive, and finite" });
            }
        }
        Ok(())
    }
}
