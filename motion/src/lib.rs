//! Motion: plans of moves on top of the kernels, as profiles, tables and pictures.
//!
//! A planner takes what is known of a move and the limits of its axes, and returns a plan or an error that names the limit
//! that fails and by how much. A plan becomes a [`Motion`]: one [`Profile`] an axis, on one clock.

pub mod controller;
pub mod error;
pub mod extremes;
mod file;
pub mod motion;
pub mod peaks;
pub mod plan;
pub mod plot;
pub mod profile;
pub mod sampling;
mod scale;
pub mod segment;
pub mod smoothness;
pub mod table;

pub use error::PlanError;
pub use extremes::{Extremes, Extremum, Quantity};
#[cfg(feature = "command")]
#[doc(hidden)]
pub use file::remove_begun;
pub use motion::{Axis, Knot, Limits, Motion};
pub use peaks::{AxisPeaks, Peak};
pub use profile::Profile;
pub use segment::{Sample, Segment, State};
pub use smoothness::{Jump, Smoothness};
