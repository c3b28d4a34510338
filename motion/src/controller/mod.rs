//! Plans as motion controllers take them: programs and arrays of positions, velocities and times, in counts of encoders.
//!
//! | form | what it is | times |
//! |---|---|---|
//! | [`Form::Pmac`] | a motion program in PVT mode for Turbo PMAC and Power PMAC | ms, in steps of a quarter of a microsecond, below 4.096 s |
//! | [`Form::Acs`] | a program in ACSPL+ with `PVSPLINE`, for SPiiPlus controllers | ms, in whole microseconds |
//! | [`Form::Arrays`] | JSON with the arrays of a trajectory of ophyd-async's PMAC driver | whole microseconds |
//! | [`Form::Epics`] | JSON with the process variables of EPICS' profile moves | s, in whole microseconds |
//!
//! The first three drive the cubic that has the positions and velocities of two rows at its ends. What is longer than a
//! segment may be is divided, on the same cubic. Times are rounded to the steps of the form; each is where it was, but for
//! half a step.
//!
//! Profile moves of EPICS have no velocities: drivers take means over the elements around a point. `Buffer::longest` makes
//! the elements short, and the error falls with its square.
//!
//! [`save_scan_spec`] says what a raster scans, as scanspec has it, and [`save_constants`] the segments of a plan as constants
//! of Rust or C, for a player on the controller.

mod acs;
mod arrays;
mod constants;
mod epics;
mod error;
mod number;
mod pmac;
mod points;
mod scaling;
mod scan_spec;

use std::io::Write;
use std::path::Path;

pub use constants::{Language, save_constants, write_constants};
pub use error::ExportError;
pub use points::Buffer;
pub use scaling::Scaling;
pub use scan_spec::{save_scan_spec, write_scan_spec};

use crate::file::write_whole;
use crate::table::Row;
use points::Points;

/// What a controller takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Form {
    /// A motion program of a PMAC.
    Pmac,
    /// A program in ACSPL+.
    Acs,
    /// Arrays for ophyd-async.
    Arrays,
    /// Process variables of EPICS.
    Epics,
}

/// Writes the rows of a plan into a file, whole or not at all; how many points there are.
///
/// # Errors
///
/// Not as many scalings as axes, or more axes than the controller has letters for; a segment that is shorter than the buffer
/// allows, or than a step of the form; a longest segment that is too short; more points than the buffer holds; a number that
/// is not finite; the file system.
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
    let points = |times| Points::new(rows, scalings, buffer, times);
    match form {
        Form::Pmac => pmac::write(out, names, points(pmac::TIMES)?),
        Form::Acs => acs::write(out, names, points(acs::TIMES)?),
        Form::Arrays => arrays::write(out, names, points(arrays::TIMES)?),
        Form::Epics => epics::write(out, names, points(epics::TIMES)?),
    }
}
