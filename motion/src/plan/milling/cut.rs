//! A cut: a way along which the limits of the speed do not change.
//!
//! On one cut an axis counts by its limit divided by its component of the direction, a/n: the axis with the least a/n
//! is the one that limits, in every step (maxima-ref/milling_time.mac, "Along one cut"). So a cut is one axis.

use closedform_kernels::milling_time;

use super::arc::{Arc, Component};
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
    /// Unit vectors at its begin and at its end; none where only other axes than X, Y and Z move.
    pub(super) direction: Option<[[f64; 3]; 2]>,
}

/// Which of [`Move::others`] turn, are straight, and push.
const TURNING: std::ops::Range<usize> = 0..3;
const STRAIGHT: std::ops::Range<usize> = 3..6;
const EXTRUDER: usize = 6;

impl Cut {
    /// Of a move; none of a move without length.
    pub(super) fn of(cut: &Move, machine: &Machine) -> Result<Option<Self>, PlanError> {
        match cut.path {
            Path::Straight => Self::straight(cut, machine),
            Path::Arc(arc) => Self::arc(cut, &arc, machine),
        }
    }

    /// The straight way of X, Y and Z, or of other axes where those rest.
    pub(super) fn straight(cut: &Move, machine: &Machine) -> Result<Option<Self>, PlanError> {
        let way = [0, 1, 2].map(|axis| cut.to[axis] - cut.from[axis]);
        let Some((length, shares)) = direction(way)? else { return Self::others(cut, machine) };
        let components = [0, 1, 2].map(|axis| (shares[axis], machine.acceleration[axis], machine.speed[axis]));
        let towards = [0, 1, 2].map(|axis| shares[axis].copysign(way[axis]));
        let speed = speed(cut.feed, machine, length)?;
        let most = machine.path_acceleration[usize::from(cut.feed.is_rapid())];
        Self::limited(length, speed, most, &components, cut, machine, Some([towards, towards])).map(Some)
    }

    fn arc(cut: &Move, arc: &Arc, machine: &Machine) -> Result<Option<Self>, PlanError> {
        let Some((length, [share, along_axis, _])) = direction([arc.radius * arc.angle, arc.height, 0.0])? else {
            return Self::others(cut, machine);
        };
        let speed = speed(cut.feed, machine, length)?;
        let (components, speed) = arc.limits(machine, [share, along_axis], speed);
        let ends = [0.0, 1.0].map(|share| arc.direction(cut.from, cut.to, share));
        let most = machine.path_acceleration[usize::from(cut.feed.is_rapid())];
        Self::limited(length, speed, most, &components, cut, machine, Some(ends)).map(Some)
    }

    /// Where X, Y and Z rest, the way is that of U, V, W; where those rest too, of A, B, C; or of E.
    fn others(cut: &Move, machine: &Machine) -> Result<Option<Self>, PlanError> {
        let of = |range: std::ops::Range<usize>| {
            let mut way = [0.0; 3];
            way.copy_from_slice(&cut.others[range]);
            direction(way)
        };
        let (length, most) = match (of(STRAIGHT)?, of(TURNING)?) {
            (Some((length, _)), _) | (None, Some((length, _))) => (length, f64::INFINITY),
            _ if cut.others[EXTRUDER] != 0.0 => (cut.others[EXTRUDER].abs(), machine.path_acceleration[2]),
            _ => return Ok(None),
        };
        let speed = speed(cut.feed, machine, length)?;
        Self::limited(length, speed, most, &[], cut, machine, None).map(Some)
    }

    /// What the axis that limits allows, and the largest speed of all.
    fn limited(
        length: f64,
        speed: f64,
        most: f64,
        components: &[Component],
        of: &Move,
        machine: &Machine,
        direction: Option<[[f64; 3]; 2]>,
    ) -> Result<Self, PlanError> {
        let mut cut = Self { length, acceleration: most, speed, direction };
        let others = of.others.iter().zip(machine.other_acceleration).zip(machine.other_speed);
        let others = others.map(|((way, acceleration), speed)| (way.abs() / length, acceleration, speed));
        let all = components.iter().copied().chain(others);
        for (share, acceleration, limit) in all.filter(|component| component.0 > 0.0) {
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

/// The speed that is asked for along a way of this length.
fn speed(feed: Feed, machine: &Machine, length: f64) -> Result<f64, PlanError> {
    let positive = |value: f64| match value > 0.0 {
        true => Ok(value.min(machine.feed)),
        false => Err(PlanError::Input { name: "feed", value, remedy: "make it positive" }),
    };
    match feed {
        Feed::Rapid => Ok(machine.rapid),
        Feed::Unknown => Ok(machine.rapid.min(machine.feed)),
        Feed::RapidAt(feed) | Feed::Speed(feed) => positive(feed),
        Feed::Within(time) => positive(length / time),
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
