//! `DerivedRaster`: a raster scan with the turn-arounds of the derivation, symmetric in time and linear in the acceleration.
//!
//! Both axes turn around together, symmetrically in time. The accelerations over time, of a line that ends at 0:
//!
//! ```text
//!   fly    0 __                       __
//!              \__ t_in         t_in /
//!                 \__             __/
//!                    \  t_edge   /
//!   -a1_max     t_out \  ____   / t_out
//!
//!   step   a2_max /\_
//!                /   \_
//!            0 _/      \_         __
//!                        \_      /
//!   -a2_max                \_   /
//!                            \_/
//! ```
//!
//! In `t_in` the fly axis loses `v1_diff` of `v1_scan`; in `t_out` it comes to rest, with `a1_max` in the end; for
//! `t_edge` it rests, if the step axis needs more time. The acceleration of the step axis rises to `a2_max` in `t_in`
//! and falls from there to 0 in the middle of the turn-around: with `t_edge` this makes the step sooner than a segment
//! of constant velocity would.
//!
//! # What is fastest
//!
//! As the derivation counts, `t_in` lies in the line and `t_out` outside: the overhead of half a turn-around is
//! `t_out + t_edge/2 + t_in*v1_diff/(3*v1_scan)`, the time beyond that of the same distance at `v1_scan`. For a given
//! `v1_diff` it falls with `t_in` as long as the step axis sets the time, and rises after that: the best `t_in` is
//! where the two axes meet, or 2*v1_diff/a1_max where that is later. What is left has one number,
//! `q = 3*a1_max^2*delta/v1_scan^2` with `delta = d2_step/a2_max`, and its one minimum over `v1_diff` is (derivation
//! in `choose.rs`)
//!
//! | q | v1_diff | what limits |
//! |---|---|---|
//! | up to 7/2 | 3/4 v1_scan | the fly axis alone |
//! | up to 3.74 | (q/2-1) v1_scan | both; constant deceleration in t_out |
//! | up to 56+12 sqrt(21) = 111 | inside, one root | both |
//! | above | 0 | both; the fly axis turns in 2*v1_scan/a1_max |
//!
//! The time of the turn-around itself has no minimum: it falls with `t_in` to 0, where the jerk is infinite.
//!
//! ```
//! use closedform_motion::plan::derived_raster::DerivedRaster;
//!
//! # fn main() -> Result<(), closedform_motion::PlanError> {
//! let plan = DerivedRaster::new(0.1, 50.0, 2e-4, 2.0, 0.01, 100).plan()?;
//! assert!((plan.overhead - 3.868_405e-3).abs() < 1e-9);
//! for knot in plan.knots().take(3) {
//!     println!("{} s: {} m, {} m/s", knot.time, knot.states[0].position, knot.states[0].velocity);
//! }
//! # Ok(())
//! # }
//! ```

mod choose;
mod quantise;
mod raster;
mod turn;

pub use turn::{Half, Turn};

use crate::error::PlanError;
use crate::motion::Limits;
use crate::plan::check::{in_range, positive};
use turn::Reach;

/// A raster scan to plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DerivedRaster {
    /// Velocity of the fly axis on the line, in m/s.
    pub v1_scan: f64,
    /// Largest acceleration of the fly axis, in m/s².
    pub a1_max: f64,
    /// From line to line, in m.
    pub d2_step: f64,
    /// Largest acceleration of the step axis, in m/s².
    pub a2_max: f64,
    /// Of each line, in m; what belongs to it says `ramps`.
    pub line_length: f64,
    /// How many.
    pub lines: u64,
    /// Whether the ramps in belong to the line.
    pub ramps: Ramps,
    /// How lines follow each other.
    pub raster: Raster,
    /// What is given of the turn-around.
    pub choice: Choice,
    /// All times are multiples of it, in s: the cycle of the controller.
    pub tick: Option<f64>,
}

/// Whether the ramps in, `t_in` at each end, belong to the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ramps {
    /// The line is all at `v1_scan` with the step axis at rest; the ramps lie outside.
    #[default]
    Outside,
    /// The ramps are the ends of the line, as the derivation counts: there the fly axis is slower by up to `v1_diff`,
    /// and the step axis already moves, by `d2_in`.
    Inside,
}

/// How lines follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Raster {
    /// To and fro.
    #[default]
    Snake,
    /// All lines in one direction. The step is made in the turn-around at the end of the line; then the fly axis goes
    /// back at `v1_return` (`None`: `v1_scan`) along the new line, and turns around before it with the step axis at
    /// rest, with the least overhead that the fly axis alone allows.
    OneWay {
        /// In m/s.
        v1_return: Option<f64>,
    },
}

/// What is given of the turn-around.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Choice {
    /// Nothing: the least overhead.
    #[default]
    Fastest,
    /// The velocity that the fly axis loses in `t_in`, in m/s: the least overhead with it.
    V1Diff(f64),
    /// The time from there to rest, in s: the least overhead with it.
    TOut(f64),
    /// The velocity that the fly axis loses in `t_in`, and `t_in`: what is left follows.
    Ramp {
        /// In m/s.
        v1_diff: f64,
        /// In s.
        t_in: f64,
    },
}

/// Which axis sets the time of the turn-around.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limiting {
    /// The fly axis: the step axis stays below `a2_max`.
    Fly,
    /// The step axis: the fly axis rests for `t_edge`, or stays below `a1_max`.
    Step,
    /// Both, up to rounding.
    Both,
}

/// A planned raster scan.
#[derive(Debug, Clone, PartialEq)]
pub struct DerivedRasterPlan {
    /// What was asked for.
    pub scan: DerivedRaster,
    /// Velocity on the line, in m/s: that asked for, or a little less with a tick.
    pub v1_scan: f64,
    /// The turn-around with the step.
    pub turn: Turn,
    /// The way back of a one-way raster.
    pub back: Option<Back>,
    /// Time at `v1_scan` on a line, in s.
    pub line_time: f64,
    /// Distance of it, in m.
    pub steady_length: f64,
    /// From the start of a line to the start of the next, in s.
    pub period: f64,
    /// From rest before the first line to rest after the last, in s.
    pub duration: f64,
    /// Of half a turn-around with the step, in s.
    pub overhead: f64,
    /// What part of the period is not `line_length/v1_scan`.
    pub overhead_share: f64,
    /// How much longer the raster takes because of the tick, in s. It may be a little less than 0 where the ramps lie
    /// inside the line, which is then flown a little slower, or where the way back has a velocity of its own.
    pub tick_cost: f64,
    /// Which axis sets the time of the turn-around.
    pub limiting: Limiting,
}

/// The way back of a one-way raster.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Back {
    /// Its velocity, in m/s.
    pub v1_return: f64,
    /// Its time at this velocity, in s.
    pub time: f64,
    /// The turn-around after it.
    pub turn: Turn,
}

impl DerivedRaster {
    /// A snake raster with the fastest turn-around, ramps outside of the line, and no tick.
    #[must_use]
    pub fn new(v1_scan: f64, a1_max: f64, d2_step: f64, a2_max: f64, line_length: f64, lines: u64) -> Self {
        Self {
            v1_scan,
            a1_max,
            d2_step,
            a2_max,
            line_length,
            lines,
            ramps: Ramps::default(),
            raster: Raster::default(),
            choice: Choice::default(),
            tick: None,
        }
    }

    /// Plans it.
    ///
    /// # Errors
    ///
    /// An input that is not positive and finite; a `v1_diff` or `t_out` that the fly axis cannot keep within `a1_max`,
    /// or for which there is no least overhead (the step is made in `t_out` alone); a line too short for its ramps; a
    /// return too fast for the way back; numbers beyond the range of `f64`.
    pub fn plan(&self) -> Result<DerivedRasterPlan, PlanError> {
        self.check()?;
        let free = Self { tick: None, ..*self };
        let free = free.planned(&free.halves()?)?;
        let Some(tick) = self.tick else { return Ok(free) };
        let coarse = self.planned(&self.quantised(&free, tick)?)?;
        Ok(DerivedRasterPlan { tick_cost: coarse.duration - free.duration, ..coarse })
    }

    /// Limits of the two axes.
    fn limits(&self) -> [Limits; 2] {
        let velocity = self.v1_scan.max(self.v1_return().unwrap_or(0.0));
        [
            Limits { velocity, acceleration: self.a1_max, jerk: f64::INFINITY },
            Limits { velocity: f64::INFINITY, acceleration: self.a2_max, jerk: f64::INFINITY },
        ]
    }

    /// Of a one-way raster.
    fn v1_return(&self) -> Option<f64> {
        match self.raster {
            Raster::Snake => None,
            Raster::OneWay { v1_return } => Some(v1_return.unwrap_or(self.v1_scan)),
        }
    }

    fn check(&self) -> Result<(), PlanError> {
        positive("v1_scan", self.v1_scan)?;
        positive("a1_max", self.a1_max)?;
        positive("d2_step", self.d2_step)?;
        positive("a2_max", self.a2_max)?;
        positive("line_length", self.line_length)?;
        positive("v1_return", self.v1_return().unwrap_or(1.0))?;
        positive("tick", self.tick.unwrap_or(1.0))?;
        if self.lines == 0 || self.lines > 1 << 53 {
            let remedy = "give a number of lines from 1 to 2^53";
            return Err(PlanError::Input { name: "lines", value: self.lines as f64, remedy });
        }
        in_range("delta, d2_step/a2_max,", &[self.d2_step / self.a2_max])?;
        in_range("the time v1_scan/a1_max", &[self.v1_scan / self.a1_max])
    }

    /// The halves of all turn-arounds, without a tick.
    fn halves(&self) -> Result<Frame, PlanError> {
        let line = self.half(self.v1_scan, self.choice)?;
        let Some(v1_return) = self.v1_return() else { return Frame::new(self, line, None, 0.0, 0.0) };
        let same = v1_return == self.v1_scan;
        let away = if same { line } else { self.half(v1_return, Choice::Fastest)? };
        let back = [away, choose::alone(v1_return, self.a1_max), choose::alone(self.v1_scan, self.a1_max)];
        Frame::new(self, line, Some(back), 0.0, 0.0)
    }

    /// A half from what is given of it.
    fn half(&self, velocity: f64, choice: Choice) -> Result<Half, PlanError> {
        choose::half(self, velocity, choice)
    }

    /// The plan of chosen halves.
    fn planned(&self, frame: &Frame) -> Result<DerivedRasterPlan, PlanError> {
        let turn = Turn::with_step(self, frame.line, frame.away());
        let v1_scan = frame.line.half.velocity;
        let back = frame.back.map(|[_, before, after]| Back {
            v1_return: before.half.velocity,
            time: frame.back_time,
            turn: Turn::without_step(before, after),
        });
        let line_time = frame.line_time;
        let period = line_time + turn.duration() + back.map_or(0.0, |back| back.time + back.turn.duration());
        let between = (self.lines - 1) as f64 * period;
        let enter = back.map_or(turn.entering, |back| back.turn.entering);
        let duration = enter.time() + between + line_time + turn.leaving.time();
        let plan = DerivedRasterPlan {
            scan: *self,
            v1_scan,
            turn,
            back,
            line_time,
            steady_length: frame.steady_length,
            period,
            duration,
            overhead: turn.overhead(),
            overhead_share: (period - self.line_length / self.v1_scan) / period,
            tick_cost: 0.0,
            limiting: self.limiting(&turn),
        };
        in_range("the duration of the raster", &[plan.duration, plan.line_time])?;
        in_range("a time of the turn-around", &[turn.leaving.t_in, turn.leaving.t_out])?;
        in_range("the step", &[turn.v2, turn.a2_leaving, turn.d2_in(), self.lines as f64 * self.d2_step])?;
        in_range("the way of the turn-around", &[turn.leaving.d1_in, turn.leaving.d1_out])?;
        plan.check_range()?;
        Ok(plan)
    }

    fn limiting(&self, turn: &Turn) -> Limiting {
        let step = turn.a2_leaving.max(turn.a2_entering) >= self.a2_max * (1.0 - turn::SLACK);
        let fly = turn.t_edge == 0.0 && turn.leaving.a1_peak >= self.a1_max * (1.0 - turn::SLACK);
        match (fly, step) {
            (true, false) => Limiting::Fly,
            (false, _) => Limiting::Step,
            (true, true) => Limiting::Both,
        }
    }
}

/// Halves in their places, and the times between them.
struct Frame {
    /// At the ends of lines.
    line: Reach,
    /// Of a one-way raster: after the step, before the turn-around of the way back, and after it.
    back: Option<[Reach; 3]>,
    line_time: f64,
    back_time: f64,
    steady_length: f64,
}

impl Frame {
    /// From halves; times that are 0 follow from the velocities.
    fn new(
        scan: &DerivedRaster,
        line: Half,
        back: Option<[Half; 3]>,
        line_time: f64,
        back_time: f64,
    ) -> Result<Self, PlanError> {
        let line_end = Reach::from_line(line, scan.ramps);
        let (line_start, back) = match back {
            None => (line_end, None),
            Some([away, before, after]) => {
                let after = Reach::from_line(after, scan.ramps);
                (after, Some([Reach::opposite(away, &line_end), Reach::opposite(before, &after), after]))
            }
        };
        let steady_length = scan.line_length + (line_start.line() + line_end.line());
        if steady_length <= 0.0 {
            return Err(PlanError::Limit {
                name: "line_length",
                limit: scan.line_length,
                needed: -(line_start.line() + line_end.line()),
                unit: "m",
                remedy: "lengthen the line by more than this, raise a1_max or a2_max, or put the ramps outside",
            });
        }
        let time = |given: f64, length: f64, velocity: f64| if given > 0.0 { given } else { length / velocity };
        let line_time = time(line_time, steady_length, line.velocity);
        let mut frame = Self { line: line_end, back, line_time, back_time: 0.0, steady_length };
        if let Some([away, before, _]) = back {
            let length = scan.line_length + (away.line() + before.line());
            if length <= 0.0 {
                return Err(PlanError::Limit {
                    name: "line_length",
                    limit: scan.line_length,
                    needed: -(away.line() + before.line()),
                    unit: "m",
                    remedy: "lower v1_return, which has no room to be reached on the way back, or lengthen the line",
                });
            }
            frame.back_time = time(back_time, length, away.half.velocity);
        }
        Ok(frame)
    }

    /// The half after the step.
    fn away(&self) -> Reach {
        self.back.map_or(self.line, |[away, ..]| away)
    }
}
