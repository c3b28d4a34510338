//! Moves, and the rows of the table of their times.

use super::arc::Arc;

/// How fast a move is asked to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// As fast as the machine moves without cutting (G0).
    Rapid,
    /// Without cutting (G0 of printers), along the path, in mm/s.
    RapidAt(f64),
    /// Along the path, in mm/s (G1, G2, G3); `f64::INFINITY` is as fast as the machine can.
    Speed(f64),
    /// In so many seconds, without the time to speed up and to brake (G93).
    Within(f64),
    /// Cutting, but how fast nobody has said: as fast as rapid moves, which is the least time.
    Unknown,
}

impl Feed {
    /// Whether it does not cut.
    #[must_use]
    pub fn is_rapid(self) -> bool {
        matches!(self, Self::Rapid | Self::RapidAt(_))
    }

    /// That of one of so many equal parts of a move.
    pub(super) fn shared(self, parts: u32) -> Self {
        match self {
            Self::Within(time) => Self::Within(time / f64::from(parts)),
            feed => feed,
        }
    }
}

/// The way from one point to the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// The straight one.
    Straight,
    /// An arc of a circle, or of a helix.
    Arc(Arc),
}

/// One move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Line of the G-code file, counted from 1; 0 where there is no file.
    pub line: u64,
    /// In mm.
    pub from: [f64; 3],
    /// In mm.
    pub to: [f64; 3],
    /// How far the axes A, B, C (in degrees), U, V, W and E (in mm) go meanwhile.
    pub others: [f64; 7],
    /// Between them.
    pub path: Path,
    /// How fast.
    pub feed: Feed,
    /// Whether it ends at rest, whatever comes next.
    pub stops: bool,
    /// Number of the tool.
    pub tool: u32,
    /// What is milled, as an index of [`Summary::features`](super::gcode::Summary::features).
    pub feature: u32,
}

impl Move {
    /// A straight one of X, Y and Z.
    #[must_use]
    pub fn straight(from: [f64; 3], to: [f64; 3], feed: Feed) -> Self {
        let path = Path::Straight;
        Self { line: 0, from, to, others: [0.0; 7], path, feed, stops: false, tool: 0, feature: 0 }
    }
}

/// One move and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Counted from 1.
    pub number: u64,
    /// What was timed.
    pub cut: Move,
    /// Of the way, in mm; in degrees where only axes move that turn.
    pub length: f64,
    /// The speed that feed and speed limits allow along this way, in mm/s.
    pub feed: f64,
    /// Speed at its begin, in mm/s.
    pub entry: f64,
    /// Speed at its end, in mm/s.
    pub exit: f64,
    /// The largest speed that is reached, in mm/s.
    pub peak: f64,
    /// In s.
    pub time: f64,
    /// Of all moves so far, in s, with dwells.
    pub total: f64,
}
