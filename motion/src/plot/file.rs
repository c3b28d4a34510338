//! Pictures as files, SVG or PNG by their ending.

use std::io::Write;
use std::path::Path;

use super::drawing::Drawing;
use super::error::PlotError;
use crate::file::write_whole;

/// Writes a drawing, whole or not at all.
pub(super) fn save(path: &Path, drawing: &Drawing) -> Result<(), PlotError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let bytes = match ending.as_deref() {
        Some("svg") => drawing.svg().into_bytes(),
        #[cfg(feature = "png")]
        Some("png") => drawing.png()?,
        _ => return Err(PlotError::Format { path: path.display().to_string() }),
    };
    write_whole(path, |out| Ok(out.write_all(&bytes)?))
}
