//! A cut: a way from rest to rest, and what limits the speed along it.
//!
//! On one cut an axis counts by its limit divided by its component of the direction, a/n: the axis with the least a/n
//! is the one that limits, in every step (maxima-ref/milling_time.mac, "Along one cut"). So a cut is one axis.

use closedform_kernels::milling_time;

use super::arc::Arc;
use super::machine::Machine;
use super::row::{Feed, Move, Path};
use crate::error::PlanError;
use crate::scale::{exponent, largest, scale};

/// A cut of positive length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    /// In mm.
    pub(super) length: f64,
    /// Acceleration limit along the cut, in mm/s²: the least a/n.
    pub(super) acceleration: f64,
    /// Largest speed along the cut, in mm/s; may be infinite.
    pub(super) speed: f64,
}

/// A component of the direction, not negative, and its limits of acceleration and speed.
pub(super) type Component = (f64, f64, f64);

impl Cut {
    /// Of a move; none of a move without length.
    pub(super) fn of(cut: &Move, machine: &Machine) -> Result<Option<Self>, PlanError> {
        let speed = match cut.feed {
            Feed::Rapid => machine.rapid,
            Feed::Speed(feed) if feed > 0.0 => feed.min(machine.feed),
            Feed::Speed(value) => return Err(PlanError::Input { name: "feed", value, remedy: "make it positive" }),
        };
        match cut.path {
            Path::Straight => Self::straight(cut, machine, speed),
            Path::Arc(arc) => Self::arc(&arc, machine, speed),
        }
    }

    fn straight(cut: &Move, machine: &Machine, speed: f64) -> Result<Option<Self>, PlanError> {
        let way = [0, 1, 2].map(|axis| cut.to[axis] - cut.from[axis]);
        let Some((length, shares)) = direction(way)? else { return Ok(None) };
        let components = [0, 1, 2].map(|axis| (shares[axis], machine.acceleration[axis], machine.speed[axis]));
        Self::limited(length, speed, &components).map(Some)
    }

    fn arc(arc: &Arc, machine: &Machine, speed: f64) -> Result<Option<Self>, PlanError> {
        let Some((length, [share, along_axis, _])) = direction([arc.radius * arc.angle, arc.height, 0.0])? else {
            return Ok(None);
        };
        let (components, speed) = arc.limits(machine, [share, along_axis], speed);
        Self::limited(length, speed, &components).map(Some)
    }

    /// What the axis that limits allows, and the largest speed of all.
    fn limited(length: f64, speed: f64, components: &[Component]) -> Result<Self, PlanError> {
        let mut cut = Self { length, acceleration: f64::INFINITY, speed };
        for (share, acceleration, limit) in components.iter().copied().filter(|component| component.0 > 0.0) {
            cut.speed = cut.speed.min(limit / share);
            cut.acceleration = cut.acceleration.min(acceleration / share);
        }
        // Squares of a speed and of a time: in range, all that follows is.
        if (cut.acceleration * length).is_normal() && (length / cut.acceleration).is_normal() {
            return Ok(cut);
        }
        Err(PlanError::Range { what: "the time of a cut" })
    }
}

/// Length and components of the direction, mirrored so that none is negative; none of no way. The kernel gets the way
/// near 1, so that no square overflows.
fn direction(way: [f64; 3]) -> Result<Option<(f64, [f64; 3])>, PlanError> {
    let most = largest(way);
    if most == 0.0 {
        return Ok(None);
    }
    let far = exponent(most);
    let [x, y, z] = way.map(|way| scale(way.abs(), -far));
    let direction = milling_time::direction(x, y, z);
    let length = scale(direction.length, far);
    if !length.is_finite() {
        return Err(PlanError::Range { what: "the length of a cut" });
    }
    Ok(Some((length, [direction.n_x, direction.n_y, direction.n_z])))
}
