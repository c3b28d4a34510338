//! What judges of profiles share: exact integration of jerk, and a repeatable source of numbers.

#![allow(dead_code, reason = "every test uses a part")]

use closedform_motion::{Motion, Profile, Segment};
use rug::Float;

/// Bits of the exact integration: products of five 53-bit numbers fit.
const PRECISION: u32 = 320;

pub const EPS: f64 = f64::EPSILON;

/// What a boundary state may differ from the integral of jerk since the boundary before, in `EPS` of the scale of the
/// segment: kernels give times to 5 ulp and distances to 14, an acceleration at its limit is cut by 20 ulp at most, and
/// a handful of roundings are added.
pub const CLOSING: f64 = 32.0;

fn float(x: f64) -> Float {
    Float::with_val(PRECISION, x)
}

/// Acceleration, velocity and position of exact integration.
struct Exact([Float; 3]);

impl Exact {
    fn after(&self, time: f64, jerk: f64) -> Self {
        let [a, v, x] = &self.0;
        let (t, j) = (float(time), float(jerk));
        let tt = float(time) * &t;
        let ttt = float(time) * &tt;
        let acceleration = float(0.0) + a + float(0.0) + &t * &j;
        let velocity = float(0.0) + v + Float::with_val(PRECISION, &t * a) + Float::with_val(PRECISION, &tt * &j) / 2;
        let mut position = float(0.0) + x + Float::with_val(PRECISION, &t * v);
        position += Float::with_val(PRECISION, &tt * a) / 2;
        position += Float::with_val(PRECISION, &ttt * &j) / 6;
        Self([acceleration, velocity, position])
    }

    /// Differences from a state.
    fn minus(&self, state: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|n| (float(0.0) + &self.0[n] - float(state[n])).to_f64().abs())
    }
}

/// The largest numbers that a segment's states are made of.
fn scales(segment: &Segment) -> [f64; 3] {
    let (s, e, t) = (segment.start, segment.end, segment.duration);
    let a = s.acceleration.abs().max(e.acceleration.abs());
    let v = s.velocity.abs().max(e.velocity.abs()).max(a * t);
    let x = s.position.abs().max(e.position.abs()).max(v * t);
    [a, v, x]
}

/// Integrates the jerk of a profile from its start, exactly, with the jumps of acceleration it declares, and compares
/// every boundary state: each segment may add `CLOSING` units, and what was added goes on in time.
pub fn integrates(profile: &Profile, what: &str) {
    integrates_within(profile, [0.0; 3], what);
}

/// The same, with units of the largest numbers of the whole profile: those of a state between two knots of its own axis are
/// sums of theirs.
pub fn integrates_in_reach(profile: &Profile, what: &str) {
    let largest = |most: [f64; 3], one: [f64; 3]| std::array::from_fn(|n| most[n].max(one[n]));
    let [a, v, x] = profile.segments().iter().map(scales).fold([0.0; 3], largest);
    // a time has the rounding of the whole, 8 times where it is a difference of sums, and makes as much of a velocity
    integrates_within(profile, [a, v.max(a * profile.duration() * 8.0 / CLOSING), x], what);
}

fn integrates_within(profile: &Profile, least: [f64; 3], what: &str) {
    let start = profile.start();
    let mut exact = Exact([float(start.acceleration), float(start.velocity), float(start.position)]);
    let mut allowed = [0.0; 3];
    for (index, segment) in profile.segments().iter().enumerate() {
        exact.0[0] = float(segment.start.acceleration);
        exact = exact.after(segment.duration, segment.jerk);
        let own = scales(segment);
        let unit: [f64; 3] = std::array::from_fn(|n| CLOSING * EPS * own[n].max(least[n]));
        let t = segment.duration;
        allowed = [unit[0], allowed[1] + unit[1], allowed[2] + allowed[1] * t + unit[2]];
        let end = segment.end;
        let off = exact.minus([end.acceleration, end.velocity, end.position]);
        for n in 0..3 {
            assert!(off[n] <= allowed[n], "{what}: segment {index}: {n}: off by {} > {}", off[n], allowed[n]);
        }
    }
}

/// No sample passes a limit by more than 8 ulp: an acceleration between two knots is one product and one sum away from
/// the nearer one, with a jerk good to 1 ulp; a velocity two of each.
pub fn keeps_limits(motion: &Motion, points: u32, what: &str) {
    for axis in motion.axes() {
        let (profile, limits) = (&axis.profile, axis.limits);
        let rate = f64::from(points) / profile.duration();
        for (time, sample) in profile.samples(rate).expect("a positive rate") {
            let (v, a) = (sample.velocity.abs(), sample.acceleration.abs());
            assert!(v <= limits.velocity * (1.0 + 8.0 * EPS), "{what}: {}: v = {v} at {time}", axis.name);
            assert!(a <= limits.acceleration * (1.0 + 8.0 * EPS), "{what}: {}: a = {a} at {time}", axis.name);
        }
    }
}

/// The closing of a profile's segments as its own arithmetic sees it, in units of `EPS` of their scale.
pub fn closing(profile: &Profile) -> f64 {
    closing_within(profile, 0.0)
}

/// The same, with positions in units of `EPS` of the largest: what is added to a large one has its rounding.
pub fn closing_in_reach(profile: &Profile) -> f64 {
    let positions = profile.segments().iter().flat_map(|s| [s.start.position, s.end.position]);
    closing_within(profile, positions.fold(0.0, |most, x| x.abs().max(most)))
}

fn closing_within(profile: &Profile, reach: f64) -> f64 {
    let mut worst = 0.0_f64;
    for segment in profile.segments() {
        let again = Segment::with_jerk(segment.start, segment.duration, segment.jerk).end;
        let [a, v, x] = scales(segment);
        let scale = [a, v, x.max(reach)];
        let off = [
            again.acceleration - segment.end.acceleration,
            again.velocity - segment.end.velocity,
            again.position - segment.end.position,
        ];
        for n in 0..3 {
            if off[n] != 0.0 {
                worst = worst.max(off[n].abs() / (scale[n] * EPS));
            }
        }
    }
    worst
}

/// Numbers that repeat: splitmix64.
pub struct Random(pub u64);

impl Random {
    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Log-uniform over decades.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }
}

/// How many random problems: 10^5, or what `CLOSEDFORM_PROBLEMS` says.
pub fn problems() -> u64 {
    std::env::var("CLOSEDFORM_PROBLEMS").ok().and_then(|text| text.parse().ok()).unwrap_or(100_000)
}
