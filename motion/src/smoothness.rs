//! Smoothness: which derivatives of a profile jump from segment to segment, and how well its segments close.

use crate::profile::Profile;
use crate::segment::{Segment, State};

/// A step of a quantity between two segments.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Jump {
    /// Later minus earlier, in the unit of the quantity; 0 where nothing jumps.
    pub size: f64,
    /// When, in s.
    pub time: f64,
}

/// What kernels (at most 17 ulp) and the cut of an acceleration at its limit may leave between two accelerations that are
/// meant to be one.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl Jump {
    fn or_larger(self, before: f64, after: f64, time: f64) -> Self {
        let size = after - before;
        if size.abs() > self.size.abs() { Self { size, time } } else { self }
    }
}

/// How a profile goes on from segment to segment. Positions always meet.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Smoothness {
    /// The largest jump of velocity between segments, in m/s.
    pub velocity: Jump,
    /// The largest jump of acceleration between segments, in m/s².
    pub acceleration: Jump,
    /// The largest difference, each by itself, between the end of a segment and what its polynomial reaches from its
    /// start: the rounding of the planner.
    pub closing: State,
}

impl Smoothness {
    /// The highest derivative that is continuous everywhere: 0 position, 1 velocity, 2 acceleration.
    #[must_use]
    pub fn order(&self) -> u32 {
        match (self.velocity.size == 0.0, self.acceleration.size == 0.0) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => 2,
        }
    }
}

impl Profile {
    /// The largest jump of the acceleration, with what the axis does before and after counted as none; none where it is
    /// rounding.
    #[must_use]
    pub fn acceleration_jump(&self) -> Jump {
        let accelerations = |segment: &Segment| [segment.start.acceleration.abs(), segment.end.acceleration.abs()];
        let largest = self.segments().iter().flat_map(accelerations).fold(0.0, f64::max);
        let inner = self.smoothness().acceleration;
        let found = inner.or_larger(0.0, self.start().acceleration, 0.0).or_larger(
            self.end().acceleration,
            0.0,
            self.duration(),
        );
        if found.size.abs() <= ROUNDING * largest { Jump::default() } else { found }
    }

    /// Jumps between segments, and how well segments close.
    #[must_use]
    pub fn smoothness(&self) -> Smoothness {
        let mut found = Smoothness::default();
        for (pair, &time) in self.segments().windows(2).zip(&self.times()[1..]) {
            let (end, start) = (pair[0].end, pair[1].start);
            found.velocity = found.velocity.or_larger(end.velocity, start.velocity, time);
            found.acceleration = found.acceleration.or_larger(end.acceleration, start.acceleration, time);
        }
        for segment in self.segments() {
            let (reached, stated) = (segment.reached(), segment.end);
            let larger = |most: f64, a: f64, b: f64| most.max((a - b).abs());
            found.closing = State {
                position: larger(found.closing.position, reached.position, stated.position),
                velocity: larger(found.closing.velocity, reached.velocity, stated.velocity),
                acceleration: larger(found.closing.acceleration, reached.acceleration, stated.acceleration),
            };
        }
        found
    }
}
