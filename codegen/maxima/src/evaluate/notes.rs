//! `Notes`: what an evaluation says of itself beside its value.

use std::cell::Cell;

/// What is noted of an evaluation beside its value.
#[derive(Default)]
pub(super) struct Notes {
    /// How far the values of functions that are no roots are from 1 at most, as a power of two.
    pub reach: Cell<u32>,
    /// Whether numbers near a step of `floor` and the like are taken for numbers there, and numbers near one another for equal.
    pub takes_near_for_equal: bool,
    /// The binary exponent below which a difference is taken for what rounding left of nothing.
    pub noise: i64,
    /// Whether one was.
    pub is_near_step: Cell<bool>,
    /// Whether a number had too few bits behind the point to tell.
    pub lost_fraction: Cell<bool>,
}
