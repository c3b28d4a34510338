//! What blocks ask the machine to do, in order.

use super::error::Problem;
use crate::plan::milling::Move;

/// One thing to do.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Action {
    /// A move.
    Move(Move),
    /// A stop, in s.
    Dwell(f64),
    /// The moves before end at rest.
    Rest,
    /// A tool comes.
    ToolChange,
    /// The spindle begins to turn.
    SpindleStart,
    /// A probe has come to the end of its way, and has touched something there or not.
    Probed(bool),
    /// A limit of a printer: the number of its code and its words.
    Limit { code: u32, words: Box<[Option<f64>; 26]> },
    /// What was passed over, or takes a time that nobody knows.
    Tell(Problem),
}
