//! Several axes that set out and arrive together: in the time of the slowest, or in a given one.

use super::single::Fastest;
use crate::error::PlanError;
use crate::motion::{Axis, Limits, Motion};
use crate::profile::Profile;
use crate::segment::{Segment, State};

/// What one of several axes has to do.
#[derive(Debug, Clone, PartialEq)]
pub struct Together {
    /// As tables and pictures call it.
    pub name: String,
    /// Without acceleration.
    pub start: State,
    /// Without acceleration.
    pub end: State,
    /// What it may do.
    pub limits: Limits,
}

/// The moves of axes that arrive together, as soon as all of them can, or at a given time.
///
/// # Errors
///
/// As of [`Fastest::new`] and [`Fastest::stretched`]; no axis moves.
pub fn together(axes: &[Together], time: Option<f64>) -> Result<Motion, PlanError> {
    let moves: Vec<Fastest> =
        axes.iter().map(|axis| Fastest::new(axis.start, axis.end, axis.limits)).collect::<Result<_, _>>()?;
    let slowest = moves.iter().map(Fastest::duration).fold(0.0, f64::max);
    let time = time.unwrap_or(slowest);
    let axis = |(axis, fastest): (&Together, &Fastest)| {
        let profile =
            if fastest.duration() == 0.0 { still(axis.start, time)? } else { fastest.stretched(time)?.profile()? };
        Ok(Axis { name: axis.name.clone(), profile, limits: axis.limits })
    };
    Ok(Motion::new(axes.iter().zip(&moves).map(axis).collect::<Result<_, _>>()?))
}

/// An axis that stays where it is.
fn still(state: State, time: f64) -> Result<Profile, PlanError> {
    let segment = Segment::between(state, state, time);
    Profile::new(vec![segment]).map_err(|_| PlanError::Range { what: "the time of the move" })
}
