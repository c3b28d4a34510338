//! The arc of a block: by its centre (I, J, K) or by its radius (R).
//!
//! **Hand-written**: the angle of an arc needs an arc tangent, which no kernel has yet. This file alone computes one for a
//! path; it is to be replaced by a kernel once there are such functions.

use std::f64::consts::TAU;

use super::block::Block;
use super::error::Problem;
use super::offsets::{AXES, turned};
use crate::plan::milling::Arc;

/// How far apart the distances of both ends from the centre may be, in mm and in inches: 2*0.01*sqrt(2) mm, and in inches
/// 2*0.001*sqrt(2), as LinuxCNC has it.
const SLACK: f64 = 0.02 * std::f64::consts::SQRT_2;
const SLACK_INCH: f64 = 25.4 * 0.002 * std::f64::consts::SQRT_2;
/// What is beyond that, and no more than this, in mm, is told: programs that round to a twentieth of a millimetre have it.
const TOLD: f64 = 0.1;
/// Or by which part of the radius, as LinuxCNC's manual and grbl have it.
const SLACK_PART: f64 = 0.001;
/// Ends that differ more than this are those of a spiral, whose radius is that in its middle; grbl has this number.
const SPIRAL: f64 = 0.005;
/// More turns than this are a slip.
const MOST_TURNS: f64 = 1e6;

/// What is in force for arcs.
pub(super) struct Frame {
    /// The axis across the plane.
    pub(super) plane: usize,
    /// Millimetres in a unit.
    pub(super) unit: f64,
    /// Where the origin is, if I, J, K are coordinates, not distances from the start.
    pub(super) centre_from: Option<[f64; 3]>,
    /// Printers do not compare the distances of the ends from the centre.
    pub(super) prints: bool,
    /// By how many degrees the coordinate system is turned about Z.
    pub(super) turn: f64,
}

impl Frame {
    fn slack(&self) -> f64 {
        match (self.prints, self.unit == 1.0) {
            (true, _) => f64::INFINITY,
            (false, true) => SLACK,
            (false, false) => SLACK_INCH,
        }
    }
}

/// A circle, and how far the arc goes on it.
struct Circle {
    /// From the start.
    centre: [f64; 2],
    radius: f64,
    angle: f64,
    /// By how much its ends differ, where that is to be told.
    apart: Option<f64>,
}

/// The arc from one point to the other, and by how much its ends differ, where that is more than controllers allow.
pub(super) fn arc(
    block: &Block,
    frame: &Frame,
    from: [f64; 3],
    to: [f64; 3],
    clockwise: bool,
) -> Result<(Arc, Option<f64>), Problem> {
    // The plane's axes in the order in which a turn from the first to the second is counter-clockwise.
    let (first, second) = ((frame.plane + 1) % 3, (frame.plane + 2) % 3);
    let chord = [to[first] - from[first], to[second] - from[second]];
    let mut circle = match block.word('R') {
        Some(_) if block.any("IJK").is_some() => {
            return Err(Problem::Arc { why: "has a radius and a centre: give one of them" });
        }
        Some(radius) => by_radius(radius * frame.unit, chord, clockwise, frame)?,
        None => by_centre(centre(block, frame, from, [first, second])?, chord, clockwise, frame)?,
    };
    if let Some(turns) = block.word('P') {
        if turns.round() != turns || !(1.0..=MOST_TURNS).contains(&turns) {
            return Err(Problem::Arc { why: "has a number of turns (P) that is not whole and positive: correct it" });
        }
        circle.angle += (turns - 1.0) * TAU;
    }
    let mut centre = from;
    centre[first] += circle.centre[0];
    centre[second] += circle.centre[1];
    let height = (to[frame.plane] - from[frame.plane]).abs();
    let arc = Arc { radius: circle.radius, angle: circle.angle, height, axis: frame.plane, centre, clockwise };
    Ok((arc, circle.apart))
}

/// From the start to the centre.
fn centre(block: &Block, frame: &Frame, from: [f64; 3], axes: [usize; 2]) -> Result<[f64; 2], Problem> {
    let word = |axis: usize| block.word(['I', 'J', 'K'][axis]).map(|value| value * frame.unit);
    if axes.map(word) == [None, None] {
        return Err(Problem::Arc { why: "has neither centre nor radius: give I, J, K of its plane, or R" });
    }
    let mut offset = [0.0; AXES];
    for axis in axes {
        offset[axis] = word(axis).unwrap_or(0.0);
    }
    turned(&mut offset, frame.turn);
    let from_start = |axis: usize| match (frame.centre_from, word(axis)) {
        (Some(origin), Some(_)) => origin[axis] + offset[axis] - from[axis],
        _ => offset[axis],
    };
    Ok(axes.map(from_start))
}

/// Ends that are the same are the ends of a whole circle.
fn by_centre(centre: [f64; 2], chord: [f64; 2], clockwise: bool, frame: &Frame) -> Result<Circle, Problem> {
    let start = [-centre[0], -centre[1]];
    let end = [chord[0] - centre[0], chord[1] - centre[1]];
    let (near, far) = (start[0].hypot(start[1]), end[0].hypot(end[1]));
    let apart = (far - near).abs();
    if near == 0.0 {
        return Err(Problem::Arc { why: "starts at its own centre: correct I, J, K" });
    }
    let is_told = apart > frame.slack() && apart > SLACK_PART * near.max(far);
    if is_told && apart > TOLD {
        return Err(Problem::Arc { why: "ends at another distance from its centre than it starts: correct I, J, K" });
    }
    let cross = start[0] * end[1] - start[1] * end[0];
    let dot = start[0] * end[0] + start[1] * end[1];
    let turn = if clockwise { -cross } else { cross }.atan2(dot);
    let radius = if apart > SPIRAL { near + (far - near) / 2.0 } else { near };
    let apart = is_told.then_some(apart);
    Ok(Circle { centre, radius, angle: if turn > 0.0 { turn } else { turn + TAU }, apart })
}

/// At most half a circle; more with a negative radius.
fn by_radius(radius: f64, chord: [f64; 2], clockwise: bool, frame: &Frame) -> Result<Circle, Problem> {
    let half = chord[0].hypot(chord[1]) / 2.0;
    if half == 0.0 {
        return Err(Problem::Arc { why: "ends where it starts, which with R has no one centre: give I, J, K" });
    }
    let short = half - radius.abs();
    if short > frame.slack() && short > SLACK_PART * half {
        return Err(Problem::Arc { why: "has a radius that is less than half the distance of its ends: correct R" });
    }
    let least = radius.abs().max(half);
    let angle = 2.0 * (half / least).asin();
    // From the middle of the chord to the centre: to the left of the way for a short arc that turns left.
    let aside = ((least - half) * (least + half)).sqrt() / (2.0 * half);
    let aside = if (radius < 0.0) == clockwise { aside } else { -aside };
    let centre = [chord[0] / 2.0 - aside * chord[1], chord[1] / 2.0 + aside * chord[0]];
    Ok(Circle { centre, radius: least, angle: if radius < 0.0 { TAU - angle } else { angle }, apart: None })
}
