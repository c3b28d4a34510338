//! The triggers of a raster as CSV, a line a pixel.

use std::io::Write;
use std::path::Path;

use super::TableError;
use super::numbers::decimal;
use crate::file::write_whole;
use crate::plan::raster_scan::Trigger;

/// Writes when and where each pixel begins, whole or not at all; how many rows.
pub fn save_triggers(
    path: &Path,
    axes: &[&str; 2],
    triggers: impl IntoIterator<Item = Trigger>,
) -> Result<u64, TableError> {
    write_whole(path, |out| {
        writeln!(out, "line,pixel,time [s],{} position [m],{} position [m]", axes[0], axes[1])?;
        let mut count = 0;
        for Trigger { line, pixel, time, position: [fly, step] } in triggers {
            writeln!(out, "{line},{pixel},{},{},{}", decimal(time), decimal(fly), decimal(step))?;
            count += 1;
        }
        Ok(count)
    })
}
