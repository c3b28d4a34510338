//! Arcs, of circles and helices.

use std::f64::consts::FRAC_1_SQRT_2;

use super::cut::Component;
use super::machine::Machine;

/// An arc of a circle in the plane of two axes, or of a helix about the third.
///
/// It is one cut, from rest to rest, of its own length; no chords are drawn. In its plane the acceleration has a part
/// along the path and one across it, v²/r, and both turn through both axes. Each part is kept within the smaller limit
/// a of the two axes divided by sqrt(2), so their sum, at most a, exceeds the limit of no axis wherever the path
/// points. That is not the shortest time that the limits allow, but one that every machine can keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Of the circle, in mm.
    pub radius: f64,
    /// Through which it goes, positive, in radians; 2*pi is the whole circle.
    pub angle: f64,
    /// How far it goes along the third axis, in mm.
    pub height: f64,
    /// The third axis: 0, 1, 2 for X, Y, Z.
    pub axis: usize,
}

impl Arc {
    /// What limits the acceleration along the path, and its largest speed. `shares` are the components of the direction
    /// in the plane and along the third axis.
    pub(super) fn limits(&self, machine: &Machine, shares: [f64; 2], speed: f64) -> ([Component; 2], f64) {
        let least = |limits: [f64; 3]| limits[(self.axis + 1) % 3].min(limits[(self.axis + 2) % 3]);
        let acceleration = least(machine.acceleration) * FRAC_1_SQRT_2;
        let across = (self.radius * acceleration).sqrt() / shares[0];
        let in_plane = (shares[0], acceleration, least(machine.speed));
        let along_axis = (shares[1], machine.acceleration[self.axis], machine.speed[self.axis]);
        ([in_plane, along_axis], if shares[0] > 0.0 { speed.min(across) } else { speed })
    }
}
