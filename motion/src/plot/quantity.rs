//! What is drawn over time: one of the four quantities of a profile.

use crate::extremes::Quantity;
use crate::motion::Limits;
use crate::profile::Profile;
use crate::segment::Segment;

/// A segment is drawn by no more straight lines than this.
const MOST_LINES: f64 = 256.0;

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

    /// Times and values of a profile, so close that straight lines between them are off by no more than `tolerance`;
    /// two values where it jumps.
    pub(super) fn points(self, profile: &Profile, tolerance: f64) -> Vec<(f64, f64)> {
        let segments = profile.segments().iter().zip(profile.times()).filter(|(segment, _)| segment.duration > 0.0);
        let points = segments.flat_map(|(segment, start)| {
            let value = move |time| (start + time, self.of(&segment.at(time)));
            self.times(segment, tolerance).map(value)
        });
        points.collect()
    }

    /// From 0 to its duration: |y''|*h^2/8 is how far a straight line of the duration h is off.
    pub(super) fn times(self, segment: &Segment, tolerance: f64) -> impl Iterator<Item = f64> {
        let count = segment.duration * (self.bend(segment) / tolerance / 8.0).sqrt();
        let count = count.ceil().clamp(1.0, MOST_LINES);
        let duration = segment.duration;
        (0..=count as u32).map(move |index| duration * (f64::from(index) / count))
    }

    /// No smaller than its largest second derivative.
    fn bend(self, segment: &Segment) -> f64 {
        let last = segment.jerk + segment.snap * segment.duration;
        match self {
            Self::Position => {
                let ends = segment.start.acceleration.abs().max(segment.end.acceleration.abs());
                ends + segment.snap.abs() * segment.duration * segment.duration / 8.0
            }
            Self::Velocity => segment.jerk.abs().max(last.abs()),
            Self::Acceleration => segment.snap.abs(),
            Self::Jerk => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segment::State;

    #[test]
    fn straight_lines_are_as_close_as_asked() {
        let segment = Segment::with_snap(State { acceleration: 2.0, ..State::rest(1.0) }, 3.0, -4.0, 5.0);
        for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk] {
            let times: Vec<f64> = quantity.times(&segment, 1e-2).collect();
            assert_eq!((times[0], times[times.len() - 1]), (0.0, 3.0));
            for pair in times.windows(2) {
                let value = |time: f64| quantity.of(&segment.at(time));
                let off = value((pair[0] + pair[1]) / 2.0) - (value(pair[0]) + value(pair[1])) / 2.0;
                assert!(off.abs() <= 1e-2 * 1.001, "{quantity:?}: {off}");
            }
        }
        assert_eq!(Quantity::Jerk.times(&segment, 1e-2).count(), 2);
    }

    #[test]
    fn a_jump_is_two_values_at_one_time() {
        let flat = |from: f64, speed| Segment::with_jerk(State::cruise(from, speed), 1.0, 0.0);
        let profile = Profile::new(vec![flat(0.0, 1.0), flat(1.0, -2.0)]).expect("a profile");
        let points = Quantity::Velocity.points(&profile, 1e-3);
        assert_eq!(points, [(0.0, 1.0), (1.0, 1.0), (1.0, -2.0), (2.0, -2.0)]);
    }
}
