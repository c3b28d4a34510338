//! `StepMove`: a step in four segments, with its largest acceleration early and the settling late.
//!
//! ```text
//!    a0    |\
//!   a00   /| \
//!     0 _/    \             _
//!    a3        \       _.--'
//!   -a0         \.---''
//!       t0   t1    t1    t4
//! ```

use closedform_kernels::step_move;

use super::check::{finite, in_range, positive};
use super::single;
use super::units::Units;
use crate::error::PlanError;
use crate::motion::{Limits, Motion};
use crate::segment::State;

/// A step to plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepMove {
    /// The whole travel, in m.
    pub travel: f64,
    /// What shapes it.
    pub shape: StepShape,
    /// What the axis may do.
    pub limits: Limits,
}

/// What shapes a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepShape {
    /// First and last segment make a quarter of the travel each. The acceleration jumps after the first from `a00` to
    /// `a0`.
    Quarter {
        /// Acceleration with which the settling begins, in m/s², negative.
        a3: f64,
        /// Time of the second and of the third segment, in s.
        t1: f64,
    },
    /// First and last segment make the fractions `ki/2` and `ko/2` of the travel; the acceleration is continuous. There
    /// is a move where 0 < ki, 0 < ko, ki+ko < 2 and ko+6*ki > 2.
    Fractions {
        /// Twice the travel of the first segment, as a fraction of the whole.
        ki: f64,
        /// Twice the travel of the last segment, as a fraction of the whole.
        ko: f64,
        /// How fast.
        time: StepTime,
    },
    /// First and last segment take the same time; the acceleration is continuous. There is a move where 1/3 < ki < 1.
    Symmetric {
        /// How the time is divided.
        frame: Frame,
        /// Time of the second and of the third segment, in s.
        t_out: f64,
    },
}

/// The time of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepTime {
    /// Of the whole, in s.
    Total(f64),
    /// Of the second and of the third segment, each, in s.
    Middle(f64),
}

/// How a symmetric frame divides its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frame {
    /// Twice the travel of the first segment, as a fraction of the whole.
    Ki(f64),
    /// Time of the first and of the last segment, each, in s: longer than `t_out`.
    TIESkip(f64),
}

/// A planned step.
#[derive(Debug, Clone, PartialEq)]
pub struct StepPlan {
    /// Of the four segments, in s.
    pub times: [f64; 4],
    /// Twice the travel of the first segment, as a fraction of the whole.
    pub ki: f64,
    /// Twice the travel of the last segment, as a fraction of the whole.
    pub ko: f64,
    /// Positions after the segments, in m.
    pub positions: [f64; 4],
    /// Velocity after the first and after the second segment, in m/s.
    pub v0: f64,
    /// Velocity after the third segment, in m/s.
    pub v3: f64,
    /// Acceleration at the end of the first segment, in m/s².
    pub a00: f64,
    /// Acceleration at the start of the second segment, and minus that at its end, in m/s².
    pub a0: f64,
    /// Acceleration at the start of the last segment, in m/s², negative.
    pub a3: f64,
    motion: Motion,
}

impl StepPlan {
    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.motion.duration()
    }

    /// One axis, `step`.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }
}

/// States and times, before they are checked.
struct Shape {
    times: [f64; 4],
    positions: [f64; 4],
    v0: f64,
    v3: f64,
    a00: f64,
    a0: f64,
    a3: f64,
    ki: f64,
    ko: f64,
}

impl Shape {
    /// From units in which `travel` and the second time are near 1; those two as they are given.
    fn outside(self, units: Units, travel: f64, middle: f64) -> Self {
        let [t0, _, _, t4] = self.times.map(|t| units.outside(t, 0, 1));
        let [x0, x1, x3, _] = self.positions.map(|x| units.outside(x, 1, 0));
        Self {
            times: [t0, middle, middle, t4],
            positions: [x0, x1, x3, travel],
            v0: units.outside(self.v0, 1, -1),
            v3: units.outside(self.v3, 1, -1),
            a00: units.outside(self.a00, 1, -2),
            a0: units.outside(self.a0, 1, -2),
            a3: units.outside(self.a3, 1, -2),
            ..self
        }
    }
}

impl StepMove {
    /// A step without limits.
    #[must_use]
    pub fn new(travel: f64, shape: StepShape) -> Self {
        Self { travel, shape, limits: Limits::NONE }
    }

    /// Plans it.
    ///
    /// # Errors
    ///
    /// An input that is not a positive, finite number; fractions or times for which there is no such move; a limit that
    /// the move passes; numbers beyond the range of `f64`.
    pub fn plan(&self) -> Result<StepPlan, PlanError> {
        positive("travel", self.travel)?;
        single::check_limits(&self.limits)?;
        let shape = match self.shape {
            StepShape::Quarter { a3, t1 } => quarter(self.travel, a3, t1)?,
            StepShape::Fractions { ki, ko, time } => fractions(self.travel, ki, ko, time)?,
            StepShape::Symmetric { frame: Frame::Ki(ki), t_out } => symmetric(self.travel, ki, t_out)?,
            StepShape::Symmetric { frame: Frame::TIESkip(t), t_out } => symmetric_times(self.travel, t, t_out)?,
        };
        self.planned(&shape)
    }

    fn planned(&self, shape: &Shape) -> Result<StepPlan, PlanError> {
        let Shape { times, positions, v0, v3, a00, a0, a3, ki, ko } = *shape;
        in_range("a time of the step", &times)?;
        in_range("a position of the step", &positions)?;
        in_range("a velocity or acceleration of the step", &[v0, v3, a00, a0, -a3])?;
        let state = |index: usize, velocity, acceleration| State { position: positions[index], velocity, acceleration };
        let pieces = [
            (times[0], State::rest(0.0), state(0, v0, a00)),
            (times[1], state(0, v0, a0), state(1, v0, -a0)),
            (times[2], state(1, v0, -a0), state(2, v3, a3)),
            (times[3], state(2, v3, a3), State::rest(self.travel)),
        ];
        let motion = single::motion("step", &pieces, self.limits)?;
        Ok(StepPlan { times, ki, ko, positions, v0, v3, a00, a0, a3, motion })
    }
}

fn quarter(travel: f64, a3: f64, t1: f64) -> Result<Shape, PlanError> {
    if !(a3 < 0.0 && a3.is_finite()) {
        return Err(PlanError::Input {
            name: "a3",
            value: a3,
            remedy: "the settling slows down: give a negative number",
        });
    }
    positive("t1", t1)?;
    let units = Units::of(travel, t1);
    let [x4, t] = [units.within(travel, 1, 0), units.within(t1, 0, 1)];
    let a3_within = units.within(a3, 1, -2);
    in_range("a3 in units of travel and t1", &[-a3_within])?;
    let m = step_move::quarter_move(x4, a3_within, t);
    if m.t4.is_nan() {
        // a0 > 0 where t1*sqrt(-a3/travel) < (sqrt(114)-3*sqrt(6))/10
        let root = (114_f64.sqrt() - 3.0 * 6_f64.sqrt()) / 10.0;
        let limit = root * (travel / -a3).sqrt();
        let remedy = "the acceleration would not peak after a quarter: give a smaller t1, a weaker a3 or more travel";
        return Err(PlanError::Limit { name: "t1", limit, needed: t1, unit: "s", remedy });
    }
    let ramp = step_move::ramp_from_rest(x4 / 4.0, m.v0);
    let shape = Shape {
        times: [ramp.t0, t, t, m.t4],
        positions: [x4 / 4.0, m.x1, 0.75 * x4, x4],
        v0: m.v0,
        v3: m.v3,
        a00: ramp.a00,
        a0: m.a0,
        a3: a3_within,
        ki: 0.5,
        ko: 0.5,
    };
    Ok(shape.outside(units, travel, t1))
}

fn fractions(travel: f64, ki: f64, ko: f64, time: StepTime) -> Result<Shape, PlanError> {
    positive("ki", ki)?;
    positive("ko", ko)?;
    let m = step_move::continuous_move(ki, ko);
    if m.kv0.is_nan() {
        return Err(no_fractions(ki, ko));
    }
    // of the first segment, in units of the second: its mean velocity is a third of the last
    let kt0 = 1.5 * ki / m.kv0;
    let t1 = match time {
        StepTime::Middle(t1) => {
            positive("time", t1)?;
            t1
        }
        StepTime::Total(total) => {
            positive("time", total)?;
            total / (kt0 + 2.0 + m.kt4)
        }
    };
    let (velocity, acceleration) = (travel / t1, travel / t1 / t1);
    Ok(Shape {
        times: [kt0 * t1, t1, t1, m.kt4 * t1],
        positions: [travel * (ki / 2.0), m.kx1 * travel, travel * (1.0 - ko / 2.0), travel],
        v0: m.kv0 * velocity,
        v3: m.kv3 * velocity,
        a00: m.ka0 * acceleration,
        a0: m.ka0 * acceleration,
        a3: -m.ka3 * acceleration,
        ki,
        ko,
    })
}

fn no_fractions(ki: f64, ko: f64) -> PlanError {
    if ki + ko >= 2.0 {
        let remedy =
            "first and last segment would make more than the whole travel: give a ki below this, or a smaller ko";
        return PlanError::Limit { name: "ki", limit: 2.0 - ko, needed: ki, unit: "", remedy };
    }
    let remedy = "the settling would not slow down: give a ko above this, or a larger ki";
    PlanError::Limit { name: "ko", limit: ko, needed: 2.0 - 6.0 * ki, unit: "", remedy }
}

fn symmetric(travel: f64, ki: f64, t_out: f64) -> Result<Shape, PlanError> {
    finite("ki", ki)?;
    positive("t_out", t_out)?;
    let units = Units::of(travel, t_out);
    let [d2_step, middle] = [units.within(travel, 1, 0), units.within(t_out, 0, 1)];
    let m = step_move::symmetric_frame_step(ki, middle, d2_step);
    if m.t_ie_skip.is_nan() {
        let remedy = "give a ki between 1/3 and 1";
        return Err(PlanError::Input { name: "ki", value: ki, remedy });
    }
    let shape = Shape {
        times: [m.t_ie_skip, middle, middle, m.t_ie_skip],
        positions: [m.d2_in, m.d2_out, m.ax2_entry, d2_step],
        v0: m.v2_in,
        v3: m.v2_out,
        a00: m.a2_max,
        a0: m.a2_max,
        a3: m.a3,
        ki,
        ko: step_move::symmetric_frame(ki).ko,
    };
    Ok(shape.outside(units, travel, t_out))
}

/// The same by times: through ki, which is close to 1 for a long frame, it would lose the digits of 1-ki.
fn symmetric_times(travel: f64, t: f64, t_out: f64) -> Result<Shape, PlanError> {
    positive("t_ie_skip", t)?;
    positive("t_out", t_out)?;
    let ki = step_move::ki_of_t_ie_skip(t, t_out);
    if ki.is_nan() {
        let remedy = "first and last segment take longer than the others: give a t_ie_skip above t_out";
        return Err(PlanError::Limit { name: "t_ie_skip", limit: t, needed: t_out, unit: "s", remedy });
    }
    let units = Units::of(travel, t_out);
    let [d2_step, middle, t] = [units.within(travel, 1, 0), units.within(t_out, 0, 1), units.within(t, 0, 1)];
    let (whole, half, more) = (t + 2.0 * middle, t + middle, t - middle);
    let a0 = 3.0 * d2_step / (t * whole);
    let shape = Shape {
        times: [t, middle, middle, t],
        // (1+4*ki-ki^2)/(8*ki) and 1-ki*(3*ki-1)/(ki+1)/2 with ki = t/whole
        positions: [
            d2_step * (t / whole / 2.0),
            d2_step * ((t * (t + 3.0 * middle) + middle * middle) / (2.0 * t * whole)),
            d2_step * ((t * (t + 7.0 * middle) + 4.0 * middle * middle) / (2.0 * half * whole)),
            d2_step,
        ],
        v0: 1.5 * d2_step / whole,
        v3: 1.5 * d2_step * more / (whole * half),
        a00: a0,
        a0,
        a3: -a0 * more / half,
        ki,
        ko: t * more / (whole * half),
    };
    Ok(shape.outside(units, travel, t_out))
}
