//! Milling: how long a machine takes for a path of straight cuts and arcs, or for a G-code file.
//!
//! The tool goes from point to point and rests at each (exact stop), as in the seed. In each cut it goes as fast as no
//! axis exceeds its acceleration limit or its speed and as the feed allows; the second half, braking as late as
//! possible, is the first backward in time. Lengths are in mm, speeds in mm/s, times in s.
//!
//! The edges, decided here:
//!
//! - A cut that is not a whole number of steps long: each half gets the fewest equal steps that are not longer than the
//!   step asked for. A cut shorter than two steps has one step in each half.
//! - An axis that a cut runs against is the mirrored one; an axis that does not move limits nothing.
//! - A move of no length takes no time.
//! - An arc is one cut without a stop, see [`Arc`].

mod arc;
mod continuous;
mod cut;
pub mod gcode;
mod machine;
mod row;
mod steps;
mod sum;
mod timer;

pub use arc::Arc;
pub use machine::Machine;
pub use row::{Feed, Move, Path, Row};
pub use timer::Timer;

use crate::error::PlanError;

/// How speed grows along a cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model {
    /// The seed's: the cut is cut into steps, and in each the speed is constant.
    ///
    /// The axis that limits changes its speed from step to step by the acceleration limit times the duration of the
    /// step. The time is never longer than that of [`Model::Continuous`], to which it tends as the steps become short;
    /// at worst, with one step a half, it is shorter by the factor sqrt(2).
    Steps {
        /// Largest length of a step, in mm; the seed's is 1.
        length: f64,
    },
    /// Constant acceleration up to the feed, and constant deceleration.
    Continuous,
}

impl Default for Model {
    fn default() -> Self {
        Self::Steps { length: 1.0 }
    }
}

/// A machine and how its time is counted.
///
/// ```
/// use closedform_motion::plan::milling::{Feed, Machine, Milling, Model};
///
/// let machine = Machine { acceleration: [500.0, 500.0, 200.0], ..Machine::default() };
/// let job = Milling::new(machine, Model::Continuous)?
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
        let cut =
            |pair: &[[f64; 3]]| timer.add(&Move { line: 0, from: pair[0], to: pair[1], path: Path::Straight, feed });
        let rows = points.windows(2).map(cut).collect::<Result<_, _>>()?;
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
