//! How hard to look: set by `CLOSEDFORM_BUDGET`, one of `quick` (the default), `full`, `extensive`.

use std::env;

/// The variable that chooses.
pub const VARIABLE: &str = "CLOSEDFORM_BUDGET";

/// How many points the judges look at.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Points for each kernel and input maker.
    pub points: usize,
    /// Points for each kernel to decide whether they are inside the domain: a cheap question.
    pub edges: usize,
    /// Starts of a climb for each kernel.
    pub climbs: usize,
    /// Steps of a climb.
    pub steps: usize,
    /// Points of a sweep for each kernel.
    pub sweep: usize,
    /// Points for each kernel and law.
    pub laws: usize,
}

const QUICK: Budget = Budget { points: 160, edges: 1_000, climbs: 6, steps: 100, sweep: 1_500, laws: 100 };
const FULL: Budget = Budget { points: 2_000, edges: 20_000, climbs: 24, steps: 500, sweep: 30_000, laws: 1_000 };
const EXTENSIVE: Budget =
    Budget { points: 100_000, edges: 1_000_000, climbs: 400, steps: 4_000, sweep: 1_500_000, laws: 20_000 };

/// The budget that the environment asks for.
pub fn budget() -> Budget {
    match env::var(VARIABLE).as_deref() {
        Err(_) | Ok("quick") => QUICK,
        Ok("full") => FULL,
        Ok("extensive") => EXTENSIVE,
        Ok(other) => panic!("{VARIABLE}={other}: give `quick`, `full` or `extensive`"),
    }
}
