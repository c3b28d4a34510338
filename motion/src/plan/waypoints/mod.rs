//! Waypoints: polynomials in time, segment after segment, through four points or more.
//!
//! The printed derivation's problems (a) to (f) go through four points in three segments; (a) and (e) are as clear with
//! two, (f) with three. With more points, the first and the last segment are what the problem says, and those between are
//! cubics; what the four points leave open is settled so that four points are no special case, [`Problem`] says how. Each
//! coordinate is planned by itself, on one clock.

mod fastest;
mod four;
mod input;
mod spline;

use crate::error::PlanError;
use crate::extremes::Quantity;
use crate::motion::{Axis, Limits, Motion};
use crate::profile::Profile;

/// What the segments are and what is continuous, by the letters of the printed derivation.
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
    /// between two points that is the linear segment of the printed derivation. The acceleration jumps at the second and
    /// the last but one point.
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

    /// The printed derivation's letter.
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

    /// By the printed derivation's letter.
    #[must_use]
    pub fn of_letter(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|problem| problem.letter() == letter)
    }

    /// The fewest points that say what the segments are.
    #[must_use]
    pub const fn fewest(self) -> usize {
        match self {
            Self::Linear | Self::CubicsAtRest => 2,
            Self::QuarticCubicQuarticAtRest => 3,
            _ => 4,
        }
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
    /// As soon as the limits of the axes allow: those of [`Waypoints::limits`].
    Fastest(Freedom),
}

/// What of a path may change to make it faster.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Freedom {
    /// One factor for all segments, whose times are as the distances of their points: the path stays what it is at a constant
    /// mean speed.
    #[default]
    Factor,
    /// The time of each segment, by a search: the points stay, and the path between them changes with the times.
    Segments,
}

/// A path through points.
///
/// ```
/// use closedform_motion::plan::waypoints::{Problem, Timing, Waypoints};
///
/// let points = vec![vec![0.0, 0.0], vec![3.0, 4.0], vec![6.0, 0.0], vec![9.0, 4.0]];
/// let plan = Waypoints::new(Problem::CubicsAtRest, points, Timing::Speed(2.0)).plan()?;
/// assert_eq!(plan.durations(), [2.5, 2.5, 2.5]);
/// assert_eq!(plan.motion().duration(), 7.5);
/// assert_eq!(plan.profiles()[1].at(2.5).position, 4.0);
/// # Ok::<(), closedform_motion::PlanError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Waypoints {
    /// What the segments are.
    pub problem: Problem,
    /// As many as the problem needs or more, each with the same number of coordinates, in m.
    pub points: Vec<Vec<f64>>,
    /// When they are passed.
    pub timing: Timing,
    /// What the axes may do: none, one for all, or one an axis.
    pub limits: Vec<Limits>,
    /// Velocities at the first and at the last point, a number an axis, in m/s; none for rest. Only cubics, problem (e),
    /// have them to choose.
    pub ends: [Vec<f64>; 2],
}

impl Waypoints {
    /// Without limits, and with the ends that the problem has.
    #[must_use]
    pub fn new(problem: Problem, points: Vec<Vec<f64>>, timing: Timing) -> Self {
        Self { problem, points, timing, limits: Vec::new(), ends: [Vec::new(), Vec::new()] }
    }

    /// The path.
    ///
    /// # Errors
    ///
    /// Too few points for the problem; not all points with as many coordinates; a number that is not finite; a speed or
    /// duration that is not positive; not one duration a segment; two points in a row that are the same, with a speed; a
    /// limit that the path passes, or that no timing of it keeps; numbers so large or small that the plan leaves the range
    /// of 64-bit numbers. Nothing else: the equations of all problems have one solution for all positive times.
    pub fn plan(&self) -> Result<WaypointPlan, PlanError> {
        let dimension = input::dimension(&self.points, self.problem)?;
        let ends = input::ends(&self.ends, dimension, self)?;
        let limits = input::limits(&self.limits, dimension)?;
        let shaped = |durations: &[f64]| self.shaped(durations, &ends, &limits);
        match &self.timing {
            Timing::Fastest(freedom) => {
                input::can_be_timed(self)?;
                let durations = input::by_distance(&self.points, 1.0)?;
                fastest::durations(durations, *freedom, shaped)
            }
            Timing::Speed(speed) => shaped(&input::by_distance(&self.points, *speed)?),
            Timing::Durations(durations) => shaped(&input::given(self.points.len() - 1, durations)?),
        }
        .and_then(|plan| plan.checked(&self.timing))
    }

    /// With these durations, whatever the limits.
    fn shaped(&self, durations: &[f64], ends: &[Vec<f64>; 2], limits: &[Limits]) -> Result<WaypointPlan, PlanError> {
        let profile = |axis: usize| self.profile(axis, durations, [ends[0][axis], ends[1][axis]]);
        let profiles = (0..limits.len()).map(profile).collect::<Result<_, _>>()?;
        Ok(WaypointPlan { problem: self.problem, durations: durations.to_vec(), profiles, limits: limits.to_vec() })
    }

    fn profile(&self, axis: usize, durations: &[f64], ends: [f64; 2]) -> Result<Profile, PlanError> {
        let positions: Vec<f64> = self.points.iter().map(|point| point[axis]).collect();
        let four = if ends == [0.0; 2] { four::segments(self.problem, &positions, durations) } else { None };
        let segments = four.unwrap_or_else(|| spline::segments(self.problem, &positions, durations, ends));
        // The positions meet: only a number that left the range remains.
        Profile::new(segments).map_err(|_| PlanError::Range { what: "the path through the waypoints" })
    }
}

/// The names of the axes, as far as machines have names for them.
const NAMES: [&str; 9] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];

/// A path through points, as polynomials.
#[derive(Debug, Clone, PartialEq)]
pub struct WaypointPlan {
    problem: Problem,
    durations: Vec<f64>,
    profiles: Vec<Profile>,
    limits: Vec<Limits>,
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

    /// The axes X, Y, Z, A and so on, as many as the points have coordinates.
    #[must_use]
    pub fn motion(&self) -> Motion {
        let axis = |(index, (profile, limits)): (usize, (&Profile, &Limits))| Axis {
            name: NAMES.get(index).map_or_else(|| format!("axis {}", index + 1), |name| (*name).to_owned()),
            profile: profile.clone(),
            limits: *limits,
        };
        Motion::new(self.profiles.iter().zip(&self.limits).enumerate().map(axis).collect())
    }
}

/// That an axis with a limited jerk has no jump of the acceleration.
fn check_jump(axis: &Axis) -> Result<(), PlanError> {
    let jump = axis.profile.acceleration_jump();
    if axis.limits.jerk == f64::INFINITY || jump.size == 0.0 {
        return Ok(());
    }
    let remedy = "no jerk makes a jump: leave out the limit of the jerk, or give problem f, which has none";
    Err(PlanError::Jump { limit: axis.limits.jerk, jump: jump.size.abs(), time: jump.time, remedy })
}

impl WaypointPlan {
    /// That it keeps the limits of its axes.
    fn checked(self, timing: &Timing) -> Result<Self, PlanError> {
        let remedy = match timing {
            Timing::Speed(_) => "give a smaller speed, or none for the fastest timing",
            _ => "give longer durations, or none for the fastest timing",
        };
        for axis in self.motion().axes() {
            let peaks = axis.peaks();
            let quantities = [
                (peaks.velocity, "velocity", "m/s"),
                (peaks.acceleration, "acceleration", "m/s^2"),
                (peaks.jerk, "jerk", "m/s^3"),
            ];
            for (peak, name, unit) in quantities {
                let needed = peak.at.value.abs();
                if needed > peak.limit * (1.0 + 64.0 * f64::EPSILON) {
                    return Err(PlanError::Limit { name, limit: peak.limit, needed, unit, remedy });
                }
            }
            check_jump(axis)?;
        }
        Ok(self)
    }

    /// How far each axis goes beyond its points: below the least of them, and above the largest, in m.
    #[must_use]
    pub fn overshoot(&self, points: &[Vec<f64>]) -> Vec<[f64; 2]> {
        let beyond = |(index, profile): (usize, &Profile)| {
            let at =
                |better: fn(f64, f64) -> f64| points.iter().map(|point| point[index]).reduce(better).unwrap_or(0.0);
            let extremes = profile.extremes(Quantity::Position);
            [at(f64::min) - extremes.least.value, extremes.largest.value - at(f64::max)]
        };
        self.profiles.iter().enumerate().map(beyond).collect()
    }
}
