//! `RasterScan`: lines along the fly axis at one velocity, with the fastest turn-arounds that the limits of both axes allow.
//!
//! On a line the fly axis has the scan velocity and the step axis rests. Between two lines the fly axis turns around, and
//! the step axis makes its step; each does so in the least time under its limits of velocity, acceleration and jerk, and
//! the slower one sets the time. So no turn-around under these limits is faster. The other axis is stretched to that time,
//! and is gentler.
//!
//! Without a limit of the jerk accelerations jump, as in a trapezoid. [`crate::plan::derived_raster`] has the turn-arounds of the
//! derivation, whose accelerations are continuous on the line and which take longer.
//!
//! ```
//! use closedform_motion::Limits;
//! use closedform_motion::plan::raster_scan::RasterScan;
//!
//! # fn main() -> Result<(), closedform_motion::PlanError> {
//! let limits = |acceleration| Limits { velocity: f64::INFINITY, acceleration, jerk: f64::INFINITY };
//! let plan = RasterScan::new(0.1, 0.005, 2e-4, 100, limits(50.0), limits(2.0)).plan()?;
//! // twice the square root of the step by its acceleration
//! assert!((plan.turn_time - 0.02).abs() < 1e-15);
//! assert!((plan.period - 0.07).abs() < 1e-15);
//! # Ok(())
//! # }
//! ```

mod gap;
mod input;
mod pattern;
mod planned;
mod rows;
mod trigger;

pub use input::{Order, RasterScan};
pub use planned::{RasterPlan, Slower};
pub use trigger::Trigger;
