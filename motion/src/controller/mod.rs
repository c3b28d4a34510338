//! Plans as motion controllers take them: programs and arrays of positions, velocities and times, in counts of encoders.
//!
//! | form | what it is | times |
//! |---|---|---|
//! | [`Form::Pmac`] | a motion program in PVT mode for Turbo PMAC and Power PMAC | ms, in steps of a quarter of a microsecond, below 4.096 s |
//! | [`Form::Arrays`] | JSON with the arrays of a trajectory of ophyd-async's PMAC driver | whole microseconds |
//!
//! Both drive the cubic that has the positions and velocities of two rows at its ends. What is longer than a segment may be
//! is divided, on the same cubic. Times are rounded to the steps of the form; each is where it was, but for half a step.

mod arrays;
mod error;
mod pmac;
mod points;
mod scaling;

use std::io::Write;
use std::path::Path;

pub use error::ExportError;
pub use points::Buffer;
pub use scaling::Scaling;

use crate::file::write_whole;
use crate::table::Row;
use points::Points;

/// What a controller takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A motion program of a PMAC.
    Pmac,
    /// Arrays for ophyd-async.
    Arrays,
}

/// Writes the rows of a plan into a file, whole or not at all; how many points there are.
///
/// # Errors
///
/// Not as many scalings as axes, or more axes than the controller has letters for; a segment that is shorter than the buffer
/// allows, or than a step of the form; more points than the buffer holds; a number that is not finite; the file system.
pub fn save<R: Into<Row>>(
    path: &Path,
    form: Form,
    names: &[String],
    scalings: &[Scaling],
    buffer: &Buffer,
    rows: impl IntoIterator<Item = R>,
) -> Result<u64, ExportError> {
    write_whole(path, |out| write(out, form, names, scalings, buffer, rows))
}

/// The same to any place.
///
/// # Errors
///
/// As of [`save`].
pub fn write<R: Into<Row>>(
    out: &mut impl Write,
    form: Form,
    names: &[String],
    scalings: &[Scaling],
    buffer: &Buffer,
    rows: impl IntoIterator<Item = R>,
) -> Result<u64, ExportError> {
    let scalings = scaling::of_axes(scalings, names.len())?;
    let rows = rows.into_iter().map(Into::into);
    match form {
        Form::Pmac => pmac::write(out, names, Points::new(rows, scalings, buffer, pmac::TIMES)),
        Form::Arrays => arrays::write(out, names, Points::new(rows, scalings, buffer, arrays::TIMES)),
    }
}
