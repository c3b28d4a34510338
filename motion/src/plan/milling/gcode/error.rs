//! What is wrong with a G-code file: where, what, and what to do.

use crate::error::PlanError;

/// What is the matter with a line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// Text that is no G-code.
    #[error("`{text}` is not G-code that can be read: correct it")]
    Syntax {
        /// What.
        text: String,
    },
    /// A comment that does not end in its line.
    #[error("the comment `{text}` has no end: close it with `)`")]
    Comment {
        /// Its begin.
        text: String,
    },
    /// A code that may move or that changes what others mean.
    #[error("{code} is not supported: remove it, or pass such lines over")]
    Code {
        /// As the file has it, without leading zeros.
        code: String,
    },
    /// A coordinate of an axis other than X, Y, Z.
    #[error("the axis {letter} is not supported: only X, Y and Z are")]
    Axis {
        /// Its letter.
        letter: char,
    },
    /// Coordinates, but no code that says how to move.
    #[error("coordinates, but no G0, G1, G2 or G3 is in force: give one")]
    NoMotion,
    /// A word or a motion that the line has twice.
    #[error("{what} stands twice in one line: split the line")]
    Twice {
        /// Letter or motion code.
        what: String,
    },
    /// An arc that is none.
    #[error("the arc {why}")]
    Arc {
        /// What is wrong, and the remedy.
        why: &'static str,
    },
    /// A dwell without its time, or with a negative one.
    #[error("G4 needs its time, P or S, and not a negative one: give it")]
    Dwell,
    /// A cut before the first F.
    #[error("a cut, but no feed is in force: give F before it, or a default feed")]
    NoFeed,
    /// A feed that is not positive.
    #[error("the feed F is {value}: make it positive")]
    Feed {
        /// As the file has it.
        value: f64,
    },
    /// A way to give feeds that does not say how fast in mm or inches per minute.
    #[error("{code}: feeds are read per minute (G94) only")]
    FeedMode {
        /// G93 or G95.
        code: String,
    },
    /// Line ends of old computers.
    #[error("a carriage return inside the line: save the file with line ends LF or CRLF")]
    CarriageReturn,
    /// A line without end.
    #[error("the line has more than {most} bytes: this is not G-code, or its line ends are lost")]
    TooLong {
        /// How many a line may have.
        most: usize,
    },
}

impl Problem {
    /// Whether passing the line over would make the times of the rest wrong.
    pub(super) fn is_fatal(&self) -> bool {
        matches!(
            self,
            Self::NoFeed | Self::Feed { .. } | Self::FeedMode { .. } | Self::CarriageReturn | Self::TooLong { .. }
        )
    }
}

/// A line that was passed over, or part of it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct Notice {
    /// Counted from 1.
    pub line: u64,
    /// Why.
    pub problem: Problem,
}

/// Why a G-code file has no time.
#[derive(Debug, thiserror::Error)]
pub enum GcodeError {
    /// The input ends in the middle, or is not there.
    #[error("line {line} cannot be read: {source}")]
    Read {
        /// Counted from 1.
        line: u64,
        /// What the system says.
        source: std::io::Error,
    },
    /// A line that is not understood.
    #[error(transparent)]
    Line(#[from] Notice),
    /// A move that cannot be timed.
    #[error("line {line}: {source}")]
    Plan {
        /// Counted from 1.
        line: u64,
        /// Why.
        source: PlanError,
    },
    /// An option that makes no sense.
    #[error(transparent)]
    Option(PlanError),
    /// Nothing to time.
    #[error("no move in {lines} lines: this is not G-code, or not the right file")]
    NoMoves {
        /// How many were read.
        lines: u64,
    },
}
