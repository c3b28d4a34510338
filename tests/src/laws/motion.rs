//! Moves integrated forward, segment by segment, from their start to their end.

use closedform_maxima::Expr;
use rug::Rational;

use crate::rational::Names;

use super::chain::{Claim, Run, parse, value};

/// What a state is made of, in order.
const PARTS: [&str; 3] = ["position", "velocity", "acceleration"];

/// A move: where it starts, and for each of its segments how the acceleration goes and what state it must end in. All
/// of it is Maxima text in inputs and results; a state is a position, a velocity and an acceleration.
///
/// Each segment begins in the state that the one before it really led to, whatever that should have been.
#[derive(Clone, Debug)]
pub struct Motion {
    start: [Expr; 3],
    segments: Vec<Segment>,
}

#[derive(Clone, Debug)]
struct Segment {
    /// The acceleration that it begins with, where the acceleration jumps.
    jump: Option<Expr>,
    time: Expr,
    course: Course,
    end: [Expr; 3],
}

/// How the acceleration goes in a segment.
#[derive(Clone, Debug)]
enum Course {
    /// In a line to what it must be at the end.
    Ramp,
    /// From a jerk by a constant snap.
    Jerk(Expr, Expr),
}

impl Motion {
    /// A move from this state.
    pub fn from(state: [&str; 3]) -> Self {
        Motion { start: state.map(parse), segments: Vec::new() }
    }

    /// A segment that takes the acceleration linearly to that of `end`.
    pub fn ramp(self, time: &str, end: [&str; 3]) -> Self {
        self.segment(time, Course::Ramp, end)
    }

    /// A segment of constant jerk.
    pub fn jerk(self, time: &str, jerk: &str, end: [&str; 3]) -> Self {
        self.snap(time, jerk, "0", end)
    }

    /// A segment of constant snap, from this jerk.
    pub fn snap(self, time: &str, jerk: &str, snap: &str, end: [&str; 3]) -> Self {
        self.segment(time, Course::Jerk(parse(jerk), parse(snap)), end)
    }

    /// The segment added last begins with this acceleration, not with the one that the segment before ends with.
    ///
    /// # Panics
    ///
    /// There is none yet.
    pub fn after_jump_to(mut self, acceleration: &str) -> Self {
        self.segments.last_mut().expect("a segment").jump = Some(parse(acceleration));
        self
    }

    fn segment(mut self, time: &str, course: Course, end: [&str; 3]) -> Self {
        self.segments.push(Segment { jump: None, time: parse(time), course, end: end.map(parse) });
        self
    }

    /// How far each segment ends from where it must, in position, velocity and acceleration.
    fn gaps(&self, names: &Names) -> Vec<Option<Rational>> {
        let state = self.start.each_ref().map(|part| value(part, names));
        let [Some(x), Some(v), Some(a)] = state else { return vec![None; 3 * self.segments.len()] };
        let mut state = Some([x, v, a]);
        let mut gaps = Vec::new();
        for segment in &self.segments {
            state = state.and_then(|state| segment.integrated(state, names));
            for (part, end) in segment.end.iter().enumerate() {
                gaps.push(state.as_ref().and_then(|state| Some(&state[part] - value(end, names)?)));
            }
        }
        gaps
    }
}

impl Segment {
    /// The state after the segment.
    fn integrated(&self, [x, v, mut a]: [Rational; 3], names: &Names) -> Option<[Rational; 3]> {
        if let Some(jump) = &self.jump {
            a = value(jump, names)?;
        }
        let t = value(&self.time, names)?;
        match &self.course {
            Course::Ramp => {
                let to = value(&self.end[2], names)?;
                let gained = Rational::from(&a + &to) * &t / 2;
                let travelled = (v.clone() + (a * 2_u32 + &to) * &t / 6) * &t;
                Some([x + travelled, v + gained, to])
            }
            Course::Jerk(jerk, snap) => {
                let (j, s) = (value(jerk, names)?, value(snap, names)?);
                let integral = |low: &[&Rational]| {
                    let over = low.iter().enumerate().rev();
                    over.fold(Rational::new(), |sum, (n, term)| *term + sum * &t / (n as u32 + 1))
                };
                Some([integral(&[&x, &v, &a, &j, &s]), integral(&[&v, &a, &j, &s]), integral(&[&a, &j, &s])])
            }
        }
    }
}

impl Claim for Motion {
    fn broken(&self, run: &Run) -> Option<String> {
        let both = |names: &Names| {
            let gaps = self.gaps(names);
            let back: Vec<_> = gaps.iter().map(|gap| gap.as_ref().map(|gap| Rational::from(-gap))).collect();
            [gaps, back].concat()
        };
        let (position, what) = run.exceeding(both)?;
        let gap = position % (3 * self.segments.len());
        Some(format!("{} after segment {} {what}", PARTS[gap % 3], gap / 3 + 1))
    }
}
