//! Waypoints: polynomials in time, segment after segment, through four points or more.
//!
//! The seed's problems (a) to (f) go through four points in three segments. With more points, the first and the last
//! segment are what the problem says, and those between are cubics; what the four points leave open is settled so that
//! four points are no special case, [`Problem`] says how. Each coordinate is planned by itself, on one clock.

mod four;
mod input;
mod spline;

use crate::error::PlanError;
use crate::motion::{Axis, Limits, Motion};
use crate::profile::Profile;

/// The fewest points that a plan goes through: the seed's four.
pub const FEWEST: usize = 4;

/// What the segments are and what is continuous, by the letters of the seed.
///
/// Positions are continuous in all problems, and the waypoints are met exactly. With more than four points, all
/// segments between the first and the last are cubics with continuous velocity and acceleration where they meet each
/// other (in [`Problem::Linear`] they are linear).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Problem {
    /// (a) Linear segments: the velocity jumps at each inner point.
    Linear,
    /// (b) Quadratic, linear, quadratic: the velocity is continuous.
    ///
    /// With more points, the segments between are the natural cubic spline, without acceleration at its two ends;
    /// between two points that is the linear segment of the seed. The acceleration jumps at the second and the last but
    /// one point.
    QuadraticLinearQuadratic,
    /// (c) Quadratic, cubic, quadratic: the velocity is continuous, and zero at both ends.
    ///
    /// Each outer segment follows from its own two points, as with four. With more points, the segments between are the
    /// cubic spline with the velocities that the outer ones have where they meet it. The acceleration jumps there.
    QuadraticCubicQuadraticAtRest,
    /// (d) Quadratic, cubic, quadratic: velocity and acceleration are continuous.
    QuadraticCubicQuadratic,
    /// (e) Cubics: velocity and acceleration are continuous, and the velocity is zero at both ends.
    CubicsAtRest,
    /// (f) Quartic, cubic, quartic: velocity and acceleration are continuous, and both are zero at both ends.
    QuarticCubicQuarticAtRest,
}

impl Problem {
    /// All of them, (a) to (f).
    pub const ALL: [Self; 6] = [
        Self::Linear,
        Self::QuadraticLinearQuadratic,
        Self::QuadraticCubicQuadraticAtRest,
        Self::QuadraticCubicQuadratic,
        Self::CubicsAtRest,
        Self::QuarticCubicQuarticAtRest,
    ];

    /// The seed's letter.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Linear => 'a',
            Self::QuadraticLinearQuadratic => 'b',
            Self::QuadraticCubicQuadraticAtRest => 'c',
            Self::QuadraticCubicQuadratic => 'd',
            Self::CubicsAtRest => 'e',
            Self::QuarticCubicQuarticAtRest => 'f',
        }
    }

    /// By the seed's letter.
    #[must_use]
    pub fn of_letter(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|problem| problem.letter() == letter)
    }

    /// Degree of the first and last segment, and of those between.
    #[must_use]
    pub const fn degrees(self) -> (usize, usize) {
        match self {
            Self::Linear => (1, 1),
            Self::QuadraticLinearQuadratic | Self::QuadraticCubicQuadraticAtRest | Self::QuadraticCubicQuadratic => {
                (2, 3)
            }
            Self::CubicsAtRest => (3, 3),
            Self::QuarticCubicQuarticAtRest => (4, 3),
        }
    }
}

/// How long each segment takes.
#[derive(Debug, Clone, PartialEq)]
pub enum Timing {
    /// The straight distance between its two points by this speed, in m/s (seed: equations 17 to 19, there with the
    /// speed 1): the mean speed along the chord.
    Speed(f64),
    /// This long, in s, one time a segment. Here two points in a row may be the same: the plan may leave and return.
    Durations(Vec<f64>),
}

/// A path through points.
///
/// ```
/// use closedform_motion::plan::waypoints::{Problem, Timing, Waypoints};
///
/// let points = vec![vec![0.0, 0.0], vec![3.0, 4.0], vec![6.0, 0.0], vec![9.0, 4.0]];
/// let plan = Waypoints { problem: Problem::CubicsAtRest, points, timing: Timing::Speed(2.0) }.plan()?;
/// assert_eq!(plan.durations(), [2.5, 2.5, 2.5]);
/// assert_eq!(plan.motion().duration(), 7.5);
/// assert_eq!(plan.profiles()[1].at(2.5).position, 4.0);
/// # Ok::<(), closedform_motion::PlanError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Waypoints {
    /// What the segments are.
    pub problem: Problem,
    /// Four or more, each with the same one, two or three coordinates, in m.
    pub points: Vec<Vec<f64>>,
    /// When they are passed.
    pub timing: Timing,
}

impl Waypoints {
    /// The path.
    ///
    /// # Errors
    ///
    /// Fewer than four points; not one to three coordinates, or not all points as many; a number that is not finite; a
    /// speed or duration that is not positive; not one duration a segment; two points in a row that are the same, with
    /// a speed; numbers so large or small that the plan leaves the range of 64-bit numbers. Nothing else: the equations
    /// of all problems have one solution for all positive times.
    pub fn plan(&self) -> Result<WaypointPlan, PlanError> {
        let dimension = input::dimension(&self.points)?;
        let durations = input::durations(&self.points, &self.timing)?;
        let profiles = (0..dimension).map(|axis| self.profile(axis, &durations)).collect::<Result<_, _>>()?;
        Ok(WaypointPlan { problem: self.problem, durations, profiles })
    }

    fn profile(&self, axis: usize, durations: &[f64]) -> Result<Profile, PlanError> {
        let positions: Vec<f64> = self.points.iter().map(|point| point[axis]).collect();
        let segments = match four::segments(self.problem, &positions, durations) {
            Some(segments) => segments,
            None => spline::segments(self.problem, &positions, durations),
        };
        // The positions meet: only a number that left the range remains.
        Profile::new(segments).map_err(|_| PlanError::Range { what: "the path through the waypoints" })
    }
}

/// A path through points, as polynomials.
#[derive(Debug, Clone, PartialEq)]
pub struct WaypointPlan {
    problem: Problem,
    durations: Vec<f64>,
    profiles: Vec<Profile>,
}

impl WaypointPlan {
    /// What the segments are.
    #[must_use]
    pub fn problem(&self) -> Problem {
        self.problem
    }

    /// How long each segment takes, in s.
    #[must_use]
    pub fn durations(&self) -> &[f64] {
        &self.durations
    }

    /// One a coordinate. A knot is exactly its waypoint, and what the problem promises to be continuous is there the
    /// same number on both sides.
    #[must_use]
    pub fn profiles(&self) -> &[Profile] {
        &self.profiles
    }

    /// The axes X, Y and Z, as many as the points have coordinates, without limits.
    #[must_use]
    pub fn motion(&self) -> Motion {
        let axis = |(name, profile): (&str, &Profile)| Axis {
            name: name.to_owned(),
            profile: profile.clone(),
            limits: Limits::NONE,
        };
        Motion::new(["X", "Y", "Z"].into_iter().zip(&self.profiles).map(axis).collect())
    }
}
