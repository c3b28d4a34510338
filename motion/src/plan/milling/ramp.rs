//! Ramps between two speeds along a cut, with and without a jerk limit.

use closedform_kernels::look_ahead;

/// Halvings of an interval that holds the largest speed under a jerk limit: more change nothing in 64-bit numbers.
const HALVINGS: u32 = 60;

/// What limits a ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ramp {
    /// In mm/s².
    pub(super) acceleration: f64,
    /// In mm/s³; may be infinite.
    pub(super) jerk: f64,
}

impl Ramp {
    /// The speed after a length; backward in time the one from which the length is enough to brake.
    pub(super) fn reachable(&self, speed: f64, length: f64) -> f64 {
        let Self { acceleration, jerk } = *self;
        if jerk == f64::INFINITY {
            return look_ahead::reachable_speed(speed, acceleration, length);
        }
        // The kernel of the long ramp is none where the length is too short for it.
        let long = look_ahead::jerk_reachable_long(speed, acceleration, jerk, length);
        if long.is_nan() {
            let half = look_ahead::jerk_reachable_short(speed, jerk, length);
            return speed + jerk * half * half;
        }
        long
    }

    /// Time and largest speed of a way between two speeds, of which each can be reached from the other.
    pub(super) fn time(&self, entry: f64, exit: f64, feed: f64, length: f64) -> (f64, f64) {
        if self.jerk == f64::INFINITY {
            // A speed without limit is none to the kernel; more than a ramp all the way reaches is the same.
            let feed = feed.min(look_ahead::reachable_speed(entry.max(exit), self.acceleration, length));
            let peak = look_ahead::peak_speed(entry, exit, self.acceleration, length, feed).max(entry).max(exit);
            return (look_ahead::block_time(entry, exit, peak, self.acceleration, length), peak);
        }
        let both = |peak: f64| {
            let (up, down) = (self.jerked(entry, peak), self.jerked(exit, peak));
            (up.0 + down.0, up.1 + down.1)
        };
        let least = entry.max(exit);
        let most = feed.min(self.reachable(least, length)).max(least);
        let (time, way) = both(most);
        if way <= length {
            return (time + (length - way) / most, most);
        }
        let (mut low, mut high) = (least, most);
        for _ in 0..HALVINGS {
            let middle = low + (high - low) / 2.0;
            if both(middle).1 <= length { low = middle } else { high = middle }
        }
        let (time, way) = both(low);
        (time + (length - way).max(0.0) / low.max(f64::MIN_POSITIVE), low)
    }

    /// Time and way of a ramp with a jerk limit.
    fn jerked(&self, from: f64, to: f64) -> (f64, f64) {
        let Self { acceleration, jerk } = *self;
        if (to - from).abs() * jerk >= acceleration * acceleration {
            let ramp = look_ahead::jerk_ramp_long(from, to, acceleration, jerk);
            return (ramp.time, ramp.way);
        }
        let ramp = look_ahead::jerk_ramp_short(from, to, jerk);
        (ramp.time, ramp.way)
    }
}
