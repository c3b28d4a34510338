//! Planners: what is known of a move and the limits of its axes become a plan.

mod check;
mod clock;
pub mod derived_raster;
pub mod fastest;
pub mod five_segment;
pub mod milling;
pub mod raster_scan;
mod single;
pub mod step_move;
mod units;
pub mod waypoints;
