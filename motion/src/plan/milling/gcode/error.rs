//! What is wrong with a G-code file: where, what, and what to do.

use crate::error::PlanError;

/// What is the matter with a line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// Text that is no G-code.
    #[error("`{text}` is not G-code that can be read: correct it")]
    Syntax {
        /// What.
        text: String,
    },
    /// A number with an exponent, which no controller reads.
    #[error("`{text}` has an exponent, which controllers take for a word E: write the number with all its digits")]
    Exponent {
        /// The word.
        text: String,
    },
    /// A line that came over with an error.
    #[error("the checksum is {given}, and that of the line is {right}: the line is damaged, correct it")]
    Checksum {
        /// In the file.
        given: u8,
        /// Of the bytes before it.
        right: u8,
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
    /// A word that the dialect does not have.
    #[error("{what} is nothing that {dialect} has: correct it, or name the dialect of the file")]
    Dialect {
        /// The word.
        what: String,
        /// The dialect.
        dialect: &'static str,
    },
    /// A word that no code of its line uses.
    #[error("{letter} does nothing in this line: remove it, or give the code that it belongs to")]
    Unused {
        /// Its letter.
        letter: char,
    },
    /// Coordinates, but no code that says how to move.
    #[error("coordinates, but no G0, G1, G2 or G3 is in force: give one")]
    NoMotion,
    /// The same before the first of them.
    #[error("coordinates before the first G0, G1, G2 or G3: they count as a rapid move (G0), as grbl has it")]
    FirstMotion,
    /// An arc whose ends are a little too differently far from its centre.
    #[error("the arc ends {apart} mm farther from its centre than it starts, or nearer: LinuxCNC and grbl refuse it")]
    Spiral {
        /// In mm.
        apart: f64,
    },
    /// A sub-program that another memory may have.
    #[error("there is no sub-program O{label} in the file or beside it: it counts 0 s")]
    NoProgram {
        /// Its number.
        label: String,
    },
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
    /// A cycle or a spline that lacks something.
    #[error("{code} {why}")]
    Cycle {
        /// Its code.
        code: String,
        /// What is wrong, and the remedy.
        why: &'static str,
    },
    /// A dwell without its time, or with a negative one.
    #[error("G4 needs its time, P or S, and not a negative one: give it")]
    Dwell,
    /// A cut before the first F.
    #[error(
        "a cut, but no feed is in force: it counts as fast as the machine goes; give F before it, or a default feed"
    )]
    NoFeed,
    /// The feed per turn of a spindle that stands still.
    #[error("a feed per turn (G95) or a thread, but the spindle has no speed: give S before it")]
    NoSpindle,
    /// The feed is not positive.
    #[error("the feed F is {value}: make it positive")]
    Feed {
        /// As the file has it.
        value: f64,
    },
    /// An expression without a value.
    #[error("the expression {why}")]
    Expression {
        /// What is wrong, and the remedy.
        why: String,
    },
    /// A parameter that has no value.
    #[error("#<{name}> has no value: set it before, or define it")]
    Undefined {
        /// Its name.
        name: String,
    },
    /// A condition, a loop or a sub-program that is not whole.
    #[error("{what}: {remedy}")]
    Flow {
        /// What is wrong.
        what: String,
        /// What to do.
        remedy: &'static str,
    },
    /// More of something than is allowed.
    #[error("{what}, more than {most}: {remedy}")]
    Limit {
        /// What.
        what: &'static str,
        /// How many are allowed.
        most: u64,
        /// What to do.
        remedy: &'static str,
    },
    /// What stops a program on purpose, or asks for what only a machine knows.
    #[error("{what}")]
    Stopped {
        /// What, with the remedy.
        what: String,
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
            Self::NoSpindle
                | Self::Feed { .. }
                | Self::CarriageReturn
                | Self::TooLong { .. }
                | Self::Flow { .. }
                | Self::Limit { .. }
        )
    }
}

/// A line that was passed over, or that takes a time which nobody knows.
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
#[non_exhaustive]
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
    #[error("no G-code in {lines} lines: this is not the right file")]
    NoCode {
        /// How many were read.
        lines: u64,
    },
}
