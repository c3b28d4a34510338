//! Times moves one after another.

use super::cut::Cut;
use super::row::{Move, Row};
use super::steps::Ramp;
use super::sum::Sum;
use super::{Milling, Model, continuous};
use crate::error::PlanError;

/// A clock that moves are added to.
#[derive(Debug, Clone)]
pub struct Timer {
    milling: Milling,
    ramp: Ramp,
    total: Sum,
    number: u64,
}

impl Timer {
    pub(super) fn new(milling: Milling) -> Self {
        Self { milling, ramp: Ramp::new(), total: Sum::default(), number: 0 }
    }

    /// Adds a move.
    ///
    /// # Errors
    ///
    /// A feed that is not positive; more than a million steps to speed up in; numbers that leave the range of 64-bit
    /// numbers.
    pub fn add(&mut self, cut: &Move) -> Result<Row, PlanError> {
        let limits = Cut::of(cut, &self.milling.machine)?;
        let (time, peak) = match (&limits, self.milling.model) {
            (None, _) => (0.0, 0.0),
            (Some(cut), Model::Steps { length }) => self.ramp.time(cut, length)?,
            (Some(cut), Model::Continuous) => continuous::time(cut),
        };
        if !(time.is_finite() && peak.is_finite()) {
            return Err(PlanError::Range { what: "the time of a cut" });
        }
        let (length, feed) = limits.map_or((0.0, 0.0), |cut| (cut.length, cut.speed));
        self.number += 1;
        self.total.add(time);
        Ok(Row { number: self.number, cut: *cut, length, feed, peak, time, total: self.total.value() })
    }

    /// Adds a time in which nothing moves.
    pub fn dwell(&mut self, time: f64) {
        self.total.add(time);
    }

    /// Of all so far, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.total.value()
    }
}
