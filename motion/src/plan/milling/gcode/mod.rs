//! G-code: the time of a file, read as a stream, line by line.
//!
//! Understood, as in the RS274/NGC dialect of LinuxCNC and grbl: G0, G1, G2, G3 (with I, J, K or R, helices too), G4,
//! G17 to G19, G20, G21, G80, G90, G91, G90.1, G91.1, G92; F, X, Y, Z; line and program numbers, comments, `%`, `/`.
//! Words may stand in any order, and what a block sets (units, plane, feed) applies to the whole block. Modal codes go
//! on: a line of coordinates alone moves as the one before. Codes that move nothing and change no time are passed over:
//! spindle, coolant, tool and program codes (M), work offsets, tool length offsets, path modes. M2, M30 and a second
//! `%` end the program.
//!
//! Everything else is a [`Problem`] with its line, and the file is refused or the line passed over, as
//! [`Reading::unknown`] says. Passed over means: no move, but its known modal codes count, unless the line could not be
//! read at all. Subprograms, variables, canned cycles, cutter compensation and rotary axes are such problems; so is a
//! return to a home position (G28, G53), since where that is, no file says.

mod arc;
mod block;
mod codes;
mod error;
mod modal;
mod reader;

pub use error::{GcodeError, Notice, Problem};
pub use reader::{Event, Progress, Summary};

use std::io::BufRead;

use super::Milling;

/// What becomes of a line that is not understood.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unknown {
    /// The file is refused.
    #[default]
    Refuse,
    /// The line is passed over and reported.
    Skip,
}

/// The unit of P in a dwell (G4 P).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DwellUnit {
    /// LinuxCNC, grbl, Mach.
    #[default]
    Seconds,
    /// Fanuc, Marlin. Their S and X are seconds, and are read so.
    Milliseconds,
}

/// How a G-code file is read.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// What becomes of a line that is not understood.
    pub unknown: Unknown,
    /// The feed before the first F, in mm/s; without it, a cut before the first F is an error.
    pub default_feed: Option<f64>,
    /// Unit of P in a dwell.
    pub dwell: DwellUnit,
    /// Whether lines that begin with `/` are left out, as with the switch "block delete" of a controller.
    pub block_delete: bool,
    /// Where the tool is at the begin, in mm.
    pub start: [f64; 3],
}

impl Milling {
    /// The time of a G-code file, and one event for each move, each line that is passed over, and now and then for the
    /// progress. Of the file one line is held, never all.
    ///
    /// # Errors
    ///
    /// The input cannot be read; a line is not understood, unless such lines are to be passed over; a cut has no feed;
    /// a feed is not positive; feeds are not per minute (G93, G95); a line of more than a million bytes; no move at
    /// all; what [`Timer::add`](super::Timer::add) refuses. All but the last two with the line.
    ///
    /// ```
    /// use closedform_motion::plan::milling::gcode::{Event, Reading};
    /// use closedform_motion::plan::milling::{Machine, Milling, Model};
    ///
    /// let program = "G21 G90\nG0 X10 Y10 (start)\nG1 Z-1 F120\nX50\nG0 Z5\nM30\n";
    /// let milling = Milling::new(Machine::default(), Model::Continuous)?;
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
