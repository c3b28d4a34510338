//! Moves, and the rows of the table of their times.

use super::arc::Arc;

/// How fast a move is asked to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// As fast as the machine moves without cutting (G0).
    Rapid,
    /// Along the path, in mm/s (G1, G2, G3); `f64::INFINITY` is as fast as the machine can.
    Speed(f64),
}

/// The way from one point to the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// The straight one.
    Straight,
    /// An arc of a circle, or of a helix.
    Arc(Arc),
}

/// One move, from rest to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Line of the G-code file, counted from 1; 0 where there is no file.
    pub line: u64,
    /// In mm.
    pub from: [f64; 3],
    /// In mm.
    pub to: [f64; 3],
    /// Between them.
    pub path: Path,
    /// How fast.
    pub feed: Feed,
}

/// One move and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Counted from 1.
    pub number: u64,
    /// What was timed.
    pub cut: Move,
    /// Of the way, in mm.
    pub length: f64,
    /// The speed that feed and speed limits allow along this way, in mm/s.
    pub feed: f64,
    /// The largest speed that is reached, in mm/s.
    pub peak: f64,
    /// In s.
    pub time: f64,
    /// Of all moves so far, in s, with dwells.
    pub total: f64,
}
