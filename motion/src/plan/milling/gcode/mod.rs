//! G-code: the time of a file, read as a stream, line by line.
//!
//! The language is RS274/NGC as LinuxCNC has it, and what grbl, Marlin, Klipper and Fanuc have beside or instead of it: see
//! [`Dialect`]. Of the file only what may be needed again is kept: sub-programs and loops.
//!
//! What takes a time that no file says (a stop, a heater, a macro of the machine) counts 0 s and is told, so the time is at
//! least what is said. What is not understood is a [`Problem`] with its line, and the file is refused or the line passed
//! over, as [`Reading::unknown`] says. Passed over means: no move, but its known modal codes count, unless the line could
//! not be read at all.
//!
//! Why no library reads it: of the crates that parse G-code, `gcode`, `g-code`, `nom-gcode` and `gcode-nom` know neither
//! parameters nor expressions (`g-code` lists both as to be done), and `async-gcode`, which parses them, evaluates nothing
//! and knows no O-words. A line means something only when it is executed, over and over in a loop, and free text, checksums
//! and exponents depend on the dialect: what a parser in front of it gave would have to be undone.
//!
//! The stages, each a file: `text` (a line without blanks, comments and free text), `statement` (what says which lines come
//! next), `flow` with `loops`, `programs`, `source` and `library` (the order of lines), `expression` with `parameters`, `block` (codes and words),
//! `modal` with `state`, `offsets` and `table` (what stays in force), `motion`, `arc`, `cycle`, `curve` (moves), `reader`
//! (all of it, and the clock), `totals`.

mod action;
mod arc;
mod block;
mod codes;
mod curve;
mod cycle;
mod dialect;
mod envelope;
mod error;
mod expression;
mod flow;
mod library;
mod loops;
mod modal;
mod motion;
mod offsets;
mod options;
mod parameters;
mod programs;
mod reader;
mod source;
mod state;
mod statement;
mod table;
mod text;
mod totals;

pub use dialect::Dialect;
pub use error::{GcodeError, Notice, Problem};
pub use options::{DwellUnit, Reading, Unknown};
pub use reader::{Event, Progress};
pub use totals::Summary;

use std::io::BufRead;

use super::Milling;

impl Milling {
    /// The time of a G-code file, and one event for each move, each line that is passed over, and now and then for the
    /// progress.
    ///
    /// # Errors
    ///
    /// The input cannot be read; a line is not understood, unless such lines are to be passed over; a cut has no feed; a
    /// feed is not positive; a line of more than a million bytes; a loop that does not end; sub-programs and loops that do
    /// not fit into memory; no G-code at all; what [`Timer::add`](super::Timer::add) refuses. All with the line.
    ///
    /// ```
    /// use closedform_motion::plan::milling::gcode::{Event, Reading};
    /// use closedform_motion::plan::milling::{Machine, Milling, Model};
    ///
    /// let program = "G21 G90\nG0 X10 Y10 (start)\nG1 Z-1 F120\nX50\nG0 Z5\nM30\n";
    /// let milling = Milling::new(Machine::default(), Model::default())?;
    /// let summary = milling.gcode(program.as_bytes(), &Reading::default(), |event| {
    ///     if let Event::Row(row) = event {
    ///         println!("{} (line {}): {} mm in {} s", row.number, row.cut.line, row.length, row.time);
    ///     }
    /// })?;
    /// assert_eq!(summary.moves, 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gcode(
        &self,
        input: impl BufRead,
        reading: &Reading,
        on_event: impl FnMut(Event<'_>),
    ) -> Result<Summary, GcodeError> {
        reader::read(self, input, reading, on_event)
    }
}
