//! PVT tables: time, position and velocity of every axis, in the columns that motion controllers take.
//!
//! A row says where every axis is at a time and how fast; the controller joins two rows by the one cubic that has these
//! positions and velocities at its ends (cubic Hermite interpolation). A segment of constant jerk is such a cubic, so its
//! two ends say all of it; one with a snap is divided ([`knots`]) until the cubics stay within a tolerance of it.
//!
//! Columns: time in s, then position in m and velocity in m/s of the first axis, of the second, and so on. The time is
//! absolute, or ([`Timing::Duration`]) how long the segment takes that ends with the row, as controllers want it whose
//! commands say time, end position and end velocity of a segment (PVT mode of Delta Tau's PMAC, there in ms and for less
//! than 4.096 s each); the first row, the start, then takes 0 s.
//!
//! Numbers are the shortest decimals that read back to the same bits. Rows are written as they come: a table of any
//! length needs the memory of a row.

mod columns;
mod csv;
mod error;
mod file;
mod json;
mod knots;
mod moves;
mod numbers;
mod triggers;

pub use csv::{read_csv, write_csv};
pub use error::TableError;
pub use file::{load, save};
pub use json::{read_json, write_json};
pub use knots::{Knots, knots};
pub use moves::{MoveWriter, save_moves};
pub use triggers::save_triggers;

use crate::motion::Knot;

/// What the first column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Timing {
    /// The time of the row since the start.
    #[default]
    Absolute,
    /// The time since the row before; 0 in the first row.
    Duration,
}

/// A row to write.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// When, and the states of all axes.
    pub knot: Knot,
    /// How long the segment takes that ends with it, in s, where that is known better than as a difference of times.
    pub duration: Option<f64>,
}

impl From<Knot> for Row {
    fn from(knot: Knot) -> Self {
        Self { knot, duration: None }
    }
}

impl From<(Knot, f64)> for Row {
    fn from((knot, duration): (Knot, f64)) -> Self {
        Self { knot, duration: Some(duration) }
    }
}

/// What a table says.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// The names of the axes, in order.
    pub axes: Vec<String>,
    /// Of the first column.
    pub timing: Timing,
}

/// A table that was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Its axes.
    pub heading: Heading,
    /// Its rows, with absolute times, and with the accelerations at the begin of the cubic that follows the row (of the
    /// last row: at the end of the cubic before it).
    pub rows: Vec<Knot>,
}
