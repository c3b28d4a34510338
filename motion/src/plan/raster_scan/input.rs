//! What is known of a raster scan, and whether it can be one.

use crate::error::PlanError;
use crate::motion::Limits;
use crate::plan::check::{finite, not_negative, positive};

/// How lines follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Order {
    /// To and fro.
    #[default]
    Snake,
    /// All in one direction: between them the fly axis goes back, no faster than this, in m/s (`None`: its limit).
    OneWay(Option<f64>),
}

/// A raster scan to plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RasterScan {
    /// Of the fly axis on the line, in m/s; it is kept exactly.
    pub velocity: f64,
    /// Of a line, in m; the first line goes the other way where it is negative.
    pub line_length: f64,
    /// From line to line, in m: of either sign, or 0 for one line again and again.
    pub step: f64,
    /// How many.
    pub lines: u64,
    /// What the fly axis may do.
    pub fly: Limits,
    /// What the step axis may do.
    pub stepping: Limits,
    /// How lines follow each other.
    pub order: Order,
    /// Time at the scan velocity before each line, and after it, in s.
    pub run_up: f64,
    /// Time of the step axis at rest before each line, in s.
    pub settle: f64,
    /// All times of rows are multiples of it, in s: the cycle of the controller.
    pub tick: Option<f64>,
    /// No time from row to row is shorter, in s; 0 for none.
    pub shortest: f64,
    /// Where the first line begins, in m: of the fly axis and of the step axis.
    pub start: [f64; 2],
}

impl RasterScan {
    /// A snake of lines, without anything else.
    #[must_use]
    pub fn new(velocity: f64, line_length: f64, step: f64, lines: u64, fly: Limits, stepping: Limits) -> Self {
        Self {
            velocity,
            line_length,
            step,
            lines,
            fly,
            stepping,
            order: Order::Snake,
            run_up: 0.0,
            settle: 0.0,
            tick: None,
            shortest: 0.0,
            start: [0.0; 2],
        }
    }

    pub(super) fn check(&self) -> Result<(), PlanError> {
        positive("velocity", self.velocity)?;
        positive("the magnitude of line_length", self.line_length.abs())?;
        finite("step", self.step)?;
        not_negative("run_up", self.run_up)?;
        not_negative("settle", self.settle)?;
        not_negative("shortest", self.shortest)?;
        positive("tick", self.tick.unwrap_or(1.0))?;
        finite("start", self.start[0])?;
        finite("start", self.start[1])?;
        if let Order::OneWay(Some(back)) = self.order {
            positive("v_return", back)?;
        }
        if self.lines == 0 || self.lines > 1 << 53 {
            let remedy = "give a number of lines from 1 to 2^53";
            return Err(PlanError::Input { name: "lines", value: self.lines as f64, remedy });
        }
        if self.velocity > self.fly.velocity {
            let (limit, needed) = (self.fly.velocity, self.velocity);
            let remedy = "the line is faster than the fly axis may be: give a smaller scan velocity";
            return Err(PlanError::Limit { name: "velocity of the fly axis", limit, needed, unit: "m/s", remedy });
        }
        Ok(())
    }

    /// How fast the fly axis may go back.
    pub(super) fn v_return(&self) -> f64 {
        match self.order {
            Order::OneWay(Some(back)) => back.min(self.fly.velocity),
            _ => self.fly.velocity,
        }
    }
}
