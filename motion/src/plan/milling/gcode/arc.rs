//! The arc of a block: by its centre (I, J, K) or by its radius (R).

use std::f64::consts::TAU;

use super::block::Block;
use super::error::Problem;
use crate::plan::milling::Arc;

/// How far apart the distances of both ends from the centre may be, in mm; LinuxCNC allows as much.
const SLACK: f64 = 0.005;
/// Or by which part of the radius.
const SLACK_PART: f64 = 0.001;

/// What is in force for arcs.
pub(super) struct Frame {
    /// The axis across the plane.
    pub(super) plane: usize,
    /// Millimetres in a unit.
    pub(super) unit: f64,
    /// Whether I, J, K are coordinates, not distances from the start.
    pub(super) absolute_centre: bool,
}

/// The arc from one point to the other.
pub(super) fn arc(block: &Block, frame: &Frame, from: [f64; 3], to: [f64; 3], clockwise: bool) -> Result<Arc, Problem> {
    if block.word('P').is_some_and(|turns| turns != 1.0) {
        return Err(Problem::Arc { why: "has several turns (P): write each as an arc" });
    }
    // The plane's axes in the order in which a turn from the first to the second is counter-clockwise.
    let (first, second) = ((frame.plane + 1) % 3, (frame.plane + 2) % 3);
    let chord = [to[first] - from[first], to[second] - from[second]];
    let (radius, angle) = match block.word('R') {
        Some(_) if block.any("IJK").is_some() => {
            return Err(Problem::Arc { why: "has a radius and a centre: give one of them" });
        }
        Some(radius) => by_radius(radius * frame.unit, chord)?,
        None => by_centre(centre(block, frame, from, [first, second])?, chord, clockwise)?,
    };
    Ok(Arc { radius, angle, height: (to[frame.plane] - from[frame.plane]).abs(), axis: frame.plane })
}

/// From the start to the centre.
fn centre(block: &Block, frame: &Frame, from: [f64; 3], axes: [usize; 2]) -> Result<[f64; 2], Problem> {
    let word = |axis: usize| block.word(['I', 'J', 'K'][axis]).map(|value| value * frame.unit);
    match axes.map(word) {
        [None, None] => Err(Problem::Arc { why: "has neither centre nor radius: give I, J, K of its plane, or R" }),
        words => {
            let offset = |(axis, word): (usize, Option<f64>)| match word {
                None => 0.0,
                Some(value) if frame.absolute_centre => value - from[axis],
                Some(value) => value,
            };
            Ok([offset((axes[0], words[0])), offset((axes[1], words[1]))])
        }
    }
}

/// Radius and angle. Ends that are the same are the ends of a whole circle.
fn by_centre(centre: [f64; 2], chord: [f64; 2], clockwise: bool) -> Result<(f64, f64), Problem> {
    let start = [-centre[0], -centre[1]];
    let end = [chord[0] - centre[0], chord[1] - centre[1]];
    let radius = start[0].hypot(start[1]);
    let apart = (end[0].hypot(end[1]) - radius).abs();
    if radius == 0.0 {
        return Err(Problem::Arc { why: "starts at its own centre: correct I, J, K" });
    }
    if apart > SLACK && apart > SLACK_PART * radius {
        return Err(Problem::Arc { why: "ends at another distance from its centre than it starts: correct I, J, K" });
    }
    let cross = start[0] * end[1] - start[1] * end[0];
    let dot = start[0] * end[0] + start[1] * end[1];
    let turn = if clockwise { -cross } else { cross }.atan2(dot);
    Ok((radius, if turn > 0.0 { turn } else { turn + TAU }))
}

/// Radius and angle, at most half a circle; more with a negative radius.
fn by_radius(radius: f64, chord: [f64; 2]) -> Result<(f64, f64), Problem> {
    let half = chord[0].hypot(chord[1]) / 2.0;
    if half == 0.0 {
        return Err(Problem::Arc { why: "ends where it starts, which with R has no one centre: give I, J, K" });
    }
    let short = half - radius.abs();
    if short > SLACK && short > SLACK_PART * half {
        return Err(Problem::Arc { why: "has a radius that is less than half the distance of its ends: correct R" });
    }
    let least = radius.abs().max(half);
    let angle = 2.0 * (half / least).asin();
    Ok((least, if radius < 0.0 { TAU - angle } else { angle }))
}
