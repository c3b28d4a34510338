//! `Fastest`: the fastest move of one axis under limits of velocity, acceleration and jerk, and of several together.
//!
//! Both ends are states without acceleration: at rest, or at a velocity. Nothing else is given but the limits. The move
//! speeds up in one ramp, goes on at the largest velocity if it comes to it, and slows down in another. Where the jerk has
//! no limit, the acceleration jumps; where the acceleration has none, it is what the jerk makes of it.
//!
//! ```
//! use closedform_motion::plan::fastest::Fastest;
//! use closedform_motion::{Limits, State};
//!
//! let limits = Limits { velocity: 0.1, acceleration: 2.0, jerk: 200.0 };
//! let step = Fastest::new(State::rest(0.0), State::rest(1e-3), limits)?;
//! // ten milliseconds of jerk, and what the acceleration needs for the rest
//! assert!((step.duration() - (0.01 + 0.0021_f64.sqrt())).abs() < 1e-15);
//! # Ok::<(), closedform_motion::PlanError>(())
//! ```

mod axes;
mod between;
mod ramp;
mod rest;
mod single;
mod stretch;

pub use axes::{Together, together};
pub(crate) use ramp::Ramp;
pub use single::Fastest;
