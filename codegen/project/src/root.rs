//! The root: where the project around the current folder begins.

use miette::{IntoDiagnostic, miette};
use std::path::{Path, PathBuf};

/// What marks the root of a project.
const MARKER: &str = "maxima-ref";

/// The named folder, or the nearest one above the current folder that holds `maxima-ref`, or the current one.
///
/// # Errors
///
/// When the named folder does not exist, or there is no current one.
pub fn project_root(named: Option<&Path>) -> miette::Result<PathBuf> {
    if let Some(named) = named {
        let missing = || miette!(help = "name the folder that holds maxima-ref", "{} is no folder", named.display());
        return if named.is_dir() { Ok(named.to_owned()) } else { Err(missing()) };
    }
    let current = std::env::current_dir().into_diagnostic()?;
    let above = current.ancestors().find(|folder| folder.join(MARKER).is_dir());
    Ok(above.unwrap_or(&current).to_owned())
}
