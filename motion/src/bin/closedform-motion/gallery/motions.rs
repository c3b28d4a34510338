//! The motions of the README's pictures.

use closedform_motion::plan::raster_scan::RasterScan;
use closedform_motion::plan::step_move::{StepMove, StepShape};
use closedform_motion::plan::waypoints::{Problem, Timing, Waypoints};
use closedform_motion::{Limits, Motion};

use crate::error::{Failure, Outcome};

/// Four points in the plane, and the path of a problem through them.
pub fn waypoints(letter: char) -> Outcome<(Motion, Vec<Vec<f64>>)> {
    let points = vec![vec![0.0, 0.0], vec![0.2, 0.4], vec![0.7, 0.5], vec![1.0, 0.1]];
    let problem = Problem::of_letter(letter).ok_or_else(|| Failure(format!("no problem ({letter})")))?;
    let plan = Waypoints::new(problem, points.clone(), Timing::Speed(1.0)).plan()?;
    Ok((plan.motion(), points))
}

/// The case of 4.1.2.
pub fn step() -> Outcome<Motion> {
    let plan = StepMove::new(1e-3, StepShape::Quarter { a3: -0.25, t1: 0.015 }).plan()?;
    Ok(plan.motion().clone())
}

/// Two lines with the fastest turn-around.
pub fn scan() -> Outcome<Motion> {
    let limits = |acceleration, jerk| Limits { velocity: f64::INFINITY, acceleration, jerk };
    Ok(RasterScan::new(0.1, 5e-3, 2e-4, 2, limits(50.0, 2e4), limits(2.0, 1e3)).plan()?.motion(2)?)
}
