//! Any number of points: the accelerations at the points, from a tridiagonal system in linear time.
//!
//! Where two cubics meet at point i with continuous velocity and acceleration, with segment i of the duration `t[i]`
//! and the mean velocity `s[i]` after it, the accelerations `a` obey
//!
//! ```text
//! t[i-1]*a[i-1] + 2*(t[i-1] + t[i])*a[i] + t[i]*a[i+1] = 6*(s[i] - s[i-1])
//! ```
//!
//! A first segment of another kind knows `a[i-1]` itself, or has no need of it: it brings `k*t[i-1]` into the diagonal
//! and `-6*c*s[i-1]` to the right side, [`Outer`]; the last one likewise. The matrix is symmetric, all its entries are
//! positive, and on the diagonal is at least twice the sum of the others in the row, so it is positive definite:
//! elimination without pivoting is stable, no number grows. And the pivots keep all their digits, [`eliminate`].
//!
//! With the accelerations rather than the velocities as unknowns, a path that is nearly uniform motion has small
//! unknowns, and only the right side cancels: it is computed with twice the digits.

use super::Problem;
use crate::segment::{Segment, State};

/// A first or last segment as its neighbour sees it.
#[derive(Clone, Copy)]
struct Outer {
    /// Its duration counts this often in the diagonal.
    diagonal: f64,
    /// Its mean velocity counts this often on the right side.
    rise: f64,
}

/// Between two cubics.
const CUBIC: Outer = Outer { diagonal: 2.0, rise: 1.0 };

/// The segments through the points, one coordinate.
pub(super) fn segments(problem: Problem, p: &[f64], t: &[f64], ends: [f64; 2]) -> Vec<Segment> {
    let path = Path {
        problem,
        p,
        t,
        ends,
        s: p.windows(2).zip(t).map(|(pair, t)| Slope::new(pair[0], pair[1], *t)).collect(),
    };
    match problem {
        Problem::Linear => path.linear(),
        _ => path.smooth(),
    }
}

/// A mean velocity, with a second number for what the first one rounds off.
#[derive(Clone, Copy)]
struct Slope {
    high: f64,
    low: f64,
}

impl Slope {
    fn new(from: f64, to: f64, time: f64) -> Self {
        let (rise, lost) = two_sum(to, -from);
        let high = rise / time;
        Self { high, low: ((-high).mul_add(time, rise) + lost) / time }
    }

    /// `right*self - left*other`, for factors 0, 1 and 2: where the first numbers cancel, their difference is exact.
    fn less(self, right: f64, left: f64, other: Self) -> f64 {
        (right * self.high - left * other.high) + (right * self.low - left * other.low)
    }
}

/// The sum, and what it rounds off.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

struct Path<'a> {
    problem: Problem,
    /// Positions.
    p: &'a [f64],
    /// Durations.
    t: &'a [f64],
    /// Mean velocities.
    s: Vec<Slope>,
    /// Velocities at the ends, of cubics.
    ends: [f64; 2],
}

impl Path<'_> {
    fn linear(&self) -> Vec<Segment> {
        let segment = |i: usize| {
            let [start, end] = [i, i + 1].map(|point| State::cruise(self.p[point], self.s[i].high));
            Segment { duration: self.t[i], start, end, jerk: 0.0, snap: 0.0 }
        };
        (0..self.t.len()).map(segment).collect()
    }

    fn smooth(&self) -> Vec<Segment> {
        let acceleration = self.accelerations();
        let velocity = self.velocities(&acceleration);
        let state = |i: usize| State { position: self.p[i], velocity: velocity[i], acceleration: acceleration[i] };
        let mut segments: Vec<Segment> =
            (0..self.t.len()).map(|i| Segment::between(state(i), state(i + 1), self.t[i])).collect();
        let last = segments.len() - 1;
        match self.problem.degrees().0 {
            2 => {
                segments[0] = self.quadratic(segments[0], true);
                segments[last] = self.quadratic(segments[last], false);
            }
            4 => {
                let (slope, a) = (self.s[0].high, acceleration[1]);
                quartic(&mut segments[0], 12.0 * slope - a * self.t[0], a - 6.0 * slope / self.t[0]);
                let (slope, a, t) = (self.s[last].high, acceleration[last], self.t[last]);
                quartic(&mut segments[last], -12.0 * slope - 3.0 * a * t, a + 6.0 * slope / t);
            }
            _ => {}
        }
        segments
    }

    /// What the problem knows of its first and last segment, and the points between whose accelerations are unknown.
    fn unknown(&self) -> (Outer, std::ops::Range<usize>) {
        let points = self.p.len();
        match self.problem {
            // Natural: the accelerations at the second point and the last but one are 0.
            Problem::Linear | Problem::QuadraticLinearQuadratic => (CUBIC, 2..points - 2),
            // The quadratic at rest ends with twice its mean velocity.
            Problem::QuadraticCubicQuadraticAtRest => (Outer { diagonal: 0.0, rise: 2.0 }, 1..points - 1),
            // Its acceleration is that at its end: a[0] = a[1].
            Problem::QuadraticCubicQuadratic => (Outer { diagonal: 3.0, rise: 1.0 }, 1..points - 1),
            // No segment before, and no velocity.
            Problem::CubicsAtRest => (Outer { diagonal: 0.0, rise: 0.0 }, 0..points),
            // The quartic from rest without acceleration ends with twice its mean velocity and a[1]*t[0]/6.
            Problem::QuarticCubicQuarticAtRest => (Outer { diagonal: 1.0, rise: 2.0 }, 1..points - 1),
        }
    }

    fn accelerations(&self) -> Vec<f64> {
        let (outer, unknown) = self.unknown();
        let mut acceleration = vec![0.0; self.p.len()];
        if unknown.is_empty() {
            return acceleration;
        }
        let row = |i: usize| {
            let before = if i == unknown.start { outer } else { CUBIC };
            let after = if i + 1 == unknown.end { outer } else { CUBIC };
            self.row(i, before, after)
        };
        let rows: Vec<Row> = unknown.clone().map(row).collect();
        eliminate(&rows, &self.t[unknown.start..unknown.end - 1], &mut acceleration[unknown.clone()]);
        if self.problem == Problem::QuadraticCubicQuadratic {
            acceleration[0] = acceleration[1];
            acceleration[unknown.end] = acceleration[unknown.end - 1];
        }
        acceleration
    }

    /// The equation of point `i`.
    fn row(&self, i: usize, before: Outer, after: Outer) -> Row {
        const NONE: Slope = Slope { high: 0.0, low: 0.0 };
        let (time_before, slope_before) = if i == 0 { (0.0, NONE) } else { (self.t[i - 1], self.s[i - 1]) };
        let (time_after, slope_after) = if i == self.t.len() { (0.0, NONE) } else { (self.t[i], self.s[i]) };
        let right = match (self.problem, i) {
            // a velocity at an end is a mean velocity of the segment that is not there
            (Problem::CubicsAtRest, 0) => 6.0 * slope_after.less(1.0, 1.0, Slope { high: self.ends[0], low: 0.0 }),
            (Problem::CubicsAtRest, i) if i == self.t.len() => {
                6.0 * Slope { high: self.ends[1], low: 0.0 }.less(1.0, 1.0, slope_before)
            }
            _ => 6.0 * slope_after.less(after.rise, before.rise, slope_before),
        };
        Row { before: before.diagonal * time_before, after: after.diagonal * time_after, right }
    }

    /// Where the problem says what they are, exactly that; elsewhere by the cubics.
    fn velocities(&self, acceleration: &[f64]) -> Vec<f64> {
        let last = self.t.len();
        let mut velocity: Vec<f64> = (0..=last).map(|i| self.velocity(acceleration, i)).collect();
        let twice = |i: usize, less: f64| 2.0 * self.s[i].high - less;
        let ends = match self.problem {
            Problem::QuadraticCubicQuadraticAtRest => {
                (velocity[1], velocity[last - 1]) = (twice(0, 0.0), twice(last - 1, 0.0));
                (0.0, 0.0)
            }
            Problem::CubicsAtRest => (self.ends[0], self.ends[1]),
            Problem::QuarticCubicQuarticAtRest => {
                if last == 2 {
                    // where both segments are quartics, from rest, twice the mean velocity and a*t/6
                    velocity[1] = twice(0, -acceleration[1] * self.t[0] / 6.0);
                }
                (0.0, 0.0)
            }
            _ => (twice(0, velocity[1]), twice(last - 1, velocity[last - 1])),
        };
        (velocity[0], velocity[last]) = ends;
        velocity
    }

    /// By the cubic after the point, or before it where there is none after.
    fn velocity(&self, acceleration: &[f64], i: usize) -> f64 {
        let by_cubic = |segment: usize, other: usize, sign: f64| {
            let change = (2.0 * acceleration[i] + acceleration[other]) / 6.0;
            self.s[segment].high + sign * self.t[segment] * change
        };
        let outer = usize::from(self.problem.degrees().0 != 3);
        if i < self.t.len() - outer { by_cubic(i, i + 1, -1.0) } else { by_cubic(i - 1, i - 1, 1.0) }
    }

    /// Constant acceleration to the velocity at its inner end, or from it.
    fn quadratic(&self, segment: Segment, first: bool) -> Segment {
        let i = if first { 0 } else { self.t.len() - 1 };
        let acceleration = match self.problem {
            Problem::QuadraticCubicQuadratic => segment.end.acceleration,
            _ if first => 2.0 * (segment.end.velocity - self.s[i].high) / self.t[i],
            _ => 2.0 * (self.s[i].high - segment.start.velocity) / self.t[i],
        };
        let [start, end] = [segment.start, segment.end].map(|state| State { acceleration, ..state });
        Segment { start, end, jerk: 0.0, ..segment }
    }
}

/// Makes a segment one of the fourth degree, by its jerk at the begin times t², and its snap times t²/4.
fn quartic(segment: &mut Segment, jerk: f64, snap: f64) {
    let t = segment.duration;
    (segment.jerk, segment.snap) = (jerk / t / t, 4.0 * snap / t / t);
}

/// One equation: its diagonal entry in two parts.
struct Row {
    /// Of the segment before.
    before: f64,
    /// Of the segment after.
    after: f64,
    right: f64,
}

/// Gaussian elimination downward and back: `rows` with `beside` above and below the diagonal.
///
/// A pivot is `before + after - beside*factor` with `factor = beside/pivot_before`. That is at most 1/2, because the
/// pivot before contains `2*beside`; and `before` is `2*beside`, so the difference `beside*(2 - factor)` loses no
/// digit, nor does the sum with `after`, which is positive.
fn eliminate(rows: &[Row], beside: &[f64], solution: &mut [f64]) {
    let mut pivot = rows[0].before + rows[0].after;
    let mut pivots = vec![pivot];
    solution[0] = rows[0].right;
    for i in 1..rows.len() {
        let factor = beside[i - 1] / pivot;
        pivot = beside[i - 1] * (2.0 - factor) + rows[i].after;
        pivots.push(pivot);
        solution[i] = rows[i].right - factor * solution[i - 1];
    }
    let last = rows.len() - 1;
    solution[last] /= pivots[last];
    for i in (0..last).rev() {
        solution[i] = (solution[i] - beside[i] * solution[i + 1]) / pivots[i];
    }
}

#[cfg(test)]
mod tests {
    use super::super::four;
    use super::*;

    /// Largest difference of what the two solutions say of the same numbers, relative to the largest of them.
    fn apart(one: &[Segment], other: &[Segment], number: impl Fn(&Segment) -> Vec<f64>) -> f64 {
        let pairs: Vec<(f64, f64)> =
            one.iter().zip(other).flat_map(|(one, other)| number(one).into_iter().zip(number(other))).collect();
        let most = pairs.iter().fold(f64::MIN_POSITIVE, |most, (a, b)| most.max(a.abs()).max(b.abs()));
        pairs.iter().fold(0.0, |apart: f64, (a, b)| apart.max((a - b).abs())) / most
    }

    type Numbers = fn(&Segment) -> Vec<f64>;

    #[test]
    fn four_points_agree_with_the_kernels() {
        let paths = [
            ([0.0, 1.0, 3.0, 4.0], [1.0, 2.0, 1.0]),
            ([0.0, 3.0, -1.0, 0.5], [0.3, 1.7, 0.9]),
            ([5.0, 5.0, 5.0, 6.0], [1.0, 1.0, 4.0]),
            ([1e6, 1e6 + 1.0, 1e6 + 2.5, 1e6 - 1.0], [1e-3, 2e-3, 1.5e-3]),
        ];
        for problem in Problem::ALL {
            for (p, t) in &paths {
                let kernels = four::segments(problem, p, t).unwrap();
                let general = segments(problem, p, t, [0.0; 2]);
                let numbers: [(&str, Numbers); 4] = [
                    ("velocity", |s| vec![s.start.velocity, s.end.velocity]),
                    ("acceleration", |s| vec![s.start.acceleration, s.end.acceleration]),
                    ("jerk", |s| vec![s.jerk]),
                    ("snap", |s| vec![s.snap]),
                ];
                for (what, number) in numbers {
                    // Some thirty operations, each of half an ulp of the largest number, in times that differ by 6.
                    let apart = apart(&kernels, &general, number);
                    assert!(apart < 1e-14, "{problem:?} {p:?} {t:?} {what}: {apart:e}");
                }
            }
        }
    }
}
