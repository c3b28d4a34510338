//! The module of a worksheet in a crate: one that no other worksheet has, and the same at every run.

use std::path::Path;

use super::place;
use closedform_build::worksheet_of;
use closedform_project::contract::{free_module_name, free_module_name_beside};

/// A module, and what it was named after.
pub struct Module {
    /// Its name.
    pub name: String,
    /// The name that it would have alone in the crate.
    usual: String,
}

impl Module {
    /// What to say where another worksheet has the usual name.
    pub fn note(&self) -> Option<String> {
        let Self { name, usual } = self;
        (name != usual)
            .then(|| format!("the module is called `{name}`, because `{usual}` is that of another worksheet"))
    }
}

/// The module of a worksheet in the crate of a folder, which may hold modules of others.
pub fn module(worksheet: &Path, out: &Path) -> Module {
    let name = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
    let stem = name(worksheet.file_stem());
    let own_line = format!("// from {}: edit", name(worksheet.file_name()));
    let is_taken = |module: &str| {
        let path = out.join(place::GENERATED).join(format!("{module}.rs"));
        let Ok(text) = std::fs::read_to_string(path) else { return false };
        let line = text.lines().next().unwrap_or_default();
        // what was not generated is refused by name, not stepped around
        worksheet_of(line).is_some() && !place::is_same_worksheet(line, &own_line)
    };
    Module { name: free_module_name_beside(&stem, is_taken), usual: free_module_name(&stem) }
}
