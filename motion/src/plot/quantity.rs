//! What is drawn over time: one of the four quantities of a profile, as the polynomial pieces it is made of.

use crate::extremes::Quantity;
use crate::motion::Limits;
use crate::profile::Profile;
use crate::segment::Segment;

/// A stretch of a curve: values and slopes at both ends. Between them it is the cubic that these determine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub from: f64,
    pub to: f64,
    pub values: (f64, f64),
    pub slopes: (f64, f64),
}

impl Piece {
    /// In other units of time and value.
    pub(super) fn scaled(self, time: f64, value: f64) -> Self {
        Self {
            from: self.from / time,
            to: self.to / time,
            values: (self.values.0 / value, self.values.1 / value),
            slopes: (self.slopes.0 * time / value, self.slopes.1 * time / value),
        }
    }

    /// At a share of its time.
    pub(super) fn at(&self, share: f64) -> f64 {
        let (a, b, left) = (self.values.0, self.values.1, 1.0 - share);
        let step = self.to - self.from;
        let ends = a * left * left * (1.0 + 2.0 * share) + b * share * share * (1.0 + 2.0 * left);
        ends + step * share * left * (self.slopes.0 * left - self.slopes.1 * share)
    }
}

impl Quantity {
    pub(super) fn title(self) -> &'static str {
        match self {
            Self::Position => "Position",
            Self::Velocity => "Velocity",
            Self::Acceleration => "Acceleration",
            Self::Jerk => "Jerk",
        }
    }

    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Position => "m",
            Self::Velocity => "m/s",
            Self::Acceleration => "m/s²",
            Self::Jerk => "m/s³",
        }
    }

    pub(super) fn limit(self, limits: Limits) -> Option<f64> {
        let limit = match self {
            Self::Position => return None,
            Self::Velocity => limits.velocity,
            Self::Acceleration => limits.acceleration,
            Self::Jerk => limits.jerk,
        };
        limit.is_finite().then_some(limit)
    }

    /// How fast it changes.
    fn slope(self, segment: &Segment, time: f64) -> f64 {
        let sample = segment.at(time);
        match self {
            Self::Position => sample.velocity,
            Self::Velocity => sample.acceleration,
            Self::Acceleration => sample.jerk,
            Self::Jerk => segment.snap,
        }
    }

    /// The curve of a profile. A position of the fourth degree is divided until the cubics are off by no more than
    /// `tolerance`; all else is of the third degree at most.
    pub(super) fn pieces(self, profile: &Profile, tolerance: f64) -> Vec<Piece> {
        let starts = profile.times();
        let with_time = |(segment, start): (&Segment, &f64)| self.pieces_of(segment, *start, tolerance);
        profile
            .segments()
            .iter()
            .zip(starts)
            .filter(|(segment, _)| segment.duration > 0.0)
            .flat_map(with_time)
            .collect()
    }

    fn pieces_of(self, segment: &Segment, start: f64, tolerance: f64) -> Vec<Piece> {
        let count = if self == Self::Position { cubics(segment, tolerance) } else { 1 };
        let time = |index: usize| segment.duration * (index as f64 / count as f64);
        let piece = |index: usize| {
            let (from, to) = (time(index), time(index + 1));
            let values = (segment.at(from).get(self), segment.at(to).get(self));
            let slopes = (self.slope(segment, from), self.slope(segment, to));
            Piece { from: start + from, to: start + to, values, slopes }
        };
        (0..count).map(piece).collect()
    }
}

/// Into how many cubics a segment is divided: |snap|*h^4/384 is how far one of the duration h is off.
fn cubics(segment: &Segment, tolerance: f64) -> usize {
    if segment.snap == 0.0 {
        return 1;
    }
    let count = segment.duration * (segment.snap.abs() / tolerance / 384.0).sqrt().sqrt();
    (count.ceil() as usize).clamp(1, 64)
}
