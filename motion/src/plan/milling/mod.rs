//! Milling: how long a machine takes for a path of straight cuts and arcs, or for a G-code file.
//!
//! Three models, see [`Model`]: a controller that looks ahead, a stop at every point, and the steps of the derivation. In
//! each cut the tool goes as fast as no axis exceeds its acceleration limit or its speed, and as the feed allows. Lengths
//! are in mm, speeds in mm/s, times in s; those of axes that turn in degrees, where nothing else moves.
//!
//! The edges, decided here:
//!
//! - A cut that is not a whole number of steps long: each half gets the fewest equal steps that are not longer than the
//!   step asked for. A cut shorter than two steps has one step in each half.
//! - An axis that a cut runs against is the mirrored one; an axis that does not move limits nothing.
//! - A move of no length takes no time, and is no corner.
//! - An arc is one cut without a stop, see [`Arc`], or its chords, see [`Arcs`].
//! - A move of other axes than X, Y and Z alone begins and ends at rest.

mod arc;
mod corner;
mod cruise;
mod cut;
mod exact_stop;
pub mod gcode;
mod machine;
mod planner;
mod ramp;
mod row;
mod rules;
mod steps;
mod sum;
mod timer;

pub use arc::Arc;
pub use machine::Machine;
pub use row::{Feed, Move, Path, Row};
pub use rules::{Arcs, Corner, Rules};
pub use timer::Timer;

use crate::error::PlanError;

/// How the time of a path is counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model {
    /// As controllers do: without a stop where the path allows it, by these rules.
    LookAhead(Rules),
    /// From rest to rest in every cut: constant acceleration up to the feed, and constant deceleration.
    ExactStop,
    /// The derivation's: from rest to rest, and each half of a cut is cut into steps of constant speed.
    ///
    /// The axis that limits changes its speed from step to step by the acceleration limit times the duration of the
    /// step. The time is never longer than that of [`Model::ExactStop`], to which it tends as the steps become short;
    /// at worst, with one step a half, it is shorter by the factor sqrt(2), which no machine can keep.
    Steps {
        /// Largest length of a step, in mm; the derivation's is 1.
        length: f64,
    },
}

impl Model {
    /// What options and summaries call it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::LookAhead(_) => "look-ahead",
            Self::ExactStop => "exact-stop",
            Self::Steps { .. } => "steps",
        }
    }
}

impl Default for Model {
    fn default() -> Self {
        Self::LookAhead(Rules::default())
    }
}

/// A machine and how its time is counted.
///
/// ```
/// use closedform_motion::plan::milling::{Feed, Machine, Milling, Model};
///
/// let machine = Machine { acceleration: [500.0, 500.0, 200.0], ..Machine::default() };
/// let job = Milling::new(machine, Model::ExactStop)?
///     .polyline(&[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [100.0, 50.0, 0.0]], Feed::Speed(25.0))?;
/// // 100 mm and 50 mm at 25 mm/s, and 0.05 s more for each of the two cuts, to speed up and to brake.
/// assert!((job.time - (100.0 / 25.0 + 50.0 / 25.0 + 0.1)).abs() < 1e-12);
/// # Ok::<(), closedform_motion::PlanError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Milling {
    machine: Machine,
    model: Model,
}

impl Milling {
    /// # Errors
    ///
    /// A limit or a step length that is not positive, or that is not a number.
    pub fn new(machine: Machine, model: Model) -> Result<Self, PlanError> {
        machine.check()?;
        if let Model::Steps { length } = model
            && !(length > 0.0 && length.is_finite())
        {
            return Err(PlanError::Input { name: "step", value: length, remedy: "make it positive and finite" });
        }
        if let Model::LookAhead(rules) = model {
            rules.check()?;
        }
        Ok(Self { machine, model })
    }

    /// The limits.
    #[must_use]
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// How time is counted.
    #[must_use]
    pub fn model(&self) -> Model {
        self.model
    }

    /// Times one move after another, without holding them.
    #[must_use]
    pub fn timer(&self) -> Timer {
        Timer::new(*self)
    }

    /// The time of straight cuts from point to point.
    ///
    /// # Errors
    ///
    /// Fewer than two points; a coordinate that is not finite; a feed that is not positive; no speed limit and steps
    /// that are too short for a cut.
    pub fn polyline(&self, points: &[[f64; 3]], feed: Feed) -> Result<Job, PlanError> {
        if points.len() < 2 {
            let remedy = "give at least two";
            return Err(PlanError::Input { name: "number of points", value: points.len() as f64, remedy });
        }
        for (index, point) in points.iter().enumerate() {
            if let Some(bad) = point.iter().find(|coordinate| !coordinate.is_finite()) {
                let (name, remedy) = ("a coordinate", "make all coordinates finite");
                return Err(PlanError::Item { item: "point", index, name, value: *bad, remedy });
            }
        }
        let mut timer = self.timer();
        for pair in points.windows(2) {
            timer.add(&Move::straight(pair[0], pair[1], feed))?;
        }
        timer.rest()?;
        let rows = std::iter::from_fn(|| timer.next_row()).collect();
        Ok(Job { rows, time: timer.time() })
    }
}

/// A path, timed.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// One a cut.
    pub rows: Vec<Row>,
    /// Of all, in s.
    pub time: f64,
}
