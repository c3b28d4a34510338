//! Arcs, of circles and helices.

use std::f64::consts::FRAC_1_SQRT_2;

use closedform_kernels::look_ahead;

use super::machine::Machine;

/// An arc of a circle in the plane of two axes, or of a helix about the third.
///
/// Driven as a whole, it is one cut of its own length. In its plane the acceleration has a part along the path and one
/// across it, v²/r, and both turn through both axes. Each part is kept within the smaller limit a of the two axes divided by
/// sqrt(2), so their sum, at most a, exceeds the limit of no axis wherever the path points. That is not the shortest time
/// that the limits allow, but one that every machine can keep.
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
    /// Of the circle, in mm; its coordinate of the third axis means nothing.
    pub centre: [f64; 3],
    /// Seen from the positive end of the third axis.
    pub clockwise: bool,
}

/// A component of the direction, not negative, and its limits of acceleration and speed.
pub(super) type Component = (f64, f64, f64);

/// No arc has more chords: more would be a slip.
const MOST_CHORDS: f64 = 1e6;

impl Arc {
    /// What limits the acceleration along the path, and its largest speed. `shares` are the components of the direction
    /// in the plane and along the third axis.
    pub(super) fn limits(&self, machine: &Machine, shares: [f64; 2], speed: f64) -> ([Component; 2], f64) {
        let least = |limits: [f64; 3]| limits[(self.axis + 1) % 3].min(limits[(self.axis + 2) % 3]);
        let acceleration = least(machine.acceleration) * FRAC_1_SQRT_2;
        let across = look_ahead::centripetal_speed(acceleration, self.radius) / shares[0];
        let in_plane = (shares[0], acceleration, least(machine.speed));
        let along_axis = (shares[1], machine.acceleration[self.axis], machine.speed[self.axis]);
        ([in_plane, along_axis], if shares[0] > 0.0 { speed.min(across) } else { speed })
    }

    /// How many chords are as near to it as the tolerance, at least one; rounded down, as grbl does.
    pub(super) fn chords_within(&self, tolerance: f64) -> u32 {
        if self.radius <= tolerance {
            return 1;
        }
        self.chords_of(look_ahead::chord(self.radius, tolerance))
    }

    /// How many chords of this length it has, at least one.
    pub(super) fn chords_of(&self, length: f64) -> u32 {
        // Not more than there are: the cast of what is not a number is 0.
        (self.radius * self.angle / length).floor().clamp(1.0, MOST_CHORDS) as u32
    }

    /// The point of the arc at a share of its angle, between its ends.
    #[must_use]
    pub fn at(&self, from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
        let (first, second) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (x, y) = (from[first] - self.centre[first], from[second] - self.centre[second]);
        let angle = if self.clockwise { -self.angle } else { self.angle } * share;
        let (sine, cosine) = angle.sin_cos();
        // The ends of a spiral are not equally far from its centre.
        let begin = x.hypot(y);
        let end = (to[first] - self.centre[first]).hypot(to[second] - self.centre[second]);
        let grown = if begin > 0.0 { 1.0 + share * (end - begin) / begin } else { 1.0 };
        let mut point = from;
        point[first] = self.centre[first] + grown * (x * cosine - y * sine);
        point[second] = self.centre[second] + grown * (x * sine + y * cosine);
        point[self.axis] = from[self.axis] + share * (to[self.axis] - from[self.axis]);
        point
    }

    /// The direction of the path at a share of its angle, as a unit vector.
    pub(super) fn direction(&self, from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
        let (first, second) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (x, y) = (from[first] - self.centre[first], from[second] - self.centre[second]);
        let turn = if self.clockwise { -1.0 } else { 1.0 };
        let (sine, cosine) = (turn * self.angle * share).sin_cos();
        let (along_x, along_y) = (x * cosine - y * sine, x * sine + y * cosine);
        let round = self.radius * self.angle;
        let length = round.hypot(self.height);
        let flat = turn * round / length / along_x.hypot(along_y).max(f64::MIN_POSITIVE);
        let mut direction = [0.0; 3];
        direction[first] = -flat * along_y;
        direction[second] = flat * along_x;
        direction[self.axis] = (to[self.axis] - from[self.axis]) / length;
        direction
    }
}
