//! The place of a crate of one's own: what is there already, and what may be written.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

use super::runtime::RUNTIME;
use super::{OwnCrateError, Runtime, text};
use closedform_build::{MARK, worksheet_of};
use closedform_project::folder::{foreign, is_generated};

/// Where generated files stand in a crate.
pub(super) const GENERATED: &str = "src/generated";

/// What stands in a folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Nothing, or less than a crate of this command that was stopped half-way.
    Empty,
    /// A crate: its files are the user's.
    Crate,
    /// A crate whose `src/lib.rs` an earlier version of this command generated.
    OldCrate,
}

impl Place {
    /// Looks, and changes nothing.
    pub(super) fn look(out: &Path) -> Result<Self, OwnCrateError> {
        if out.exists() && !out.is_dir() {
            return Err(OwnCrateError::File(out.to_owned()));
        }
        for folder in ["src", GENERATED].map(|below| out.join(below)) {
            if folder.is_symlink() {
                return Err(OwnCrateError::Link(folder));
            }
        }
        let manifest = out.join("Cargo.toml");
        if !manifest.exists() {
            return if is_empty(out)? { Ok(Self::Empty) } else { Err(OwnCrateError::SomethingElse(out.to_owned())) };
        }
        let text = read(&manifest)?;
        let table: toml::Table = text.parse().map_err(|cause| OwnCrateError::Manifest { path: manifest, cause })?;
        if !table.contains_key("package") {
            return Err(OwnCrateError::Workspace(out.to_owned()));
        }
        let library = out.join("src/lib.rs");
        match library.exists() {
            true if is_generated(&read(&library)?) => Ok(Self::OldCrate),
            false if text::is_founded(&text) && !out.join("src/main.rs").exists() => Ok(Self::Empty),
            _ => Ok(Self::Crate),
        }
    }
}

/// Lets one process at a time write into a folder; the others wait.
#[cfg(unix)]
pub(super) fn lock(folder: &Path) -> io::Result<fs::File> {
    let folder = fs::File::open(folder)?;
    folder.lock()?;
    Ok(folder)
}

/// Folders cannot be locked here.
#[cfg(not(unix))]
pub(super) fn lock(_folder: &Path) -> io::Result<()> {
    Ok(())
}

/// Whether all files that are to be written are new, or marked as made of the same worksheet.
pub(super) fn check_owner(folder: &Path, files: &BTreeMap<String, String>) -> Result<(), OwnCrateError> {
    let paths = files.keys().map(String::as_str).chain([text::INDEX, text::JUDGES]).map(|name| folder.join(name));
    if let Some(path) = foreign(paths, MARK)? {
        return Err(OwnCrateError::Foreign(path));
    }
    for (name, text) in files {
        let path = folder.join(name);
        let Ok(old) = fs::read_to_string(&path) else { continue };
        let (old, new) = (first_line(&old), first_line(text));
        if !is_same_worksheet(old, new) {
            return Err(OwnCrateError::OtherWorksheet { path, first_line: old.to_owned() });
        }
    }
    Ok(())
}

/// Whether the first lines of two modules name one worksheet.
pub(super) fn is_same_worksheet(old: &str, new: &str) -> bool {
    matches!((worksheet_of(old), worksheet_of(new)), (Some(old), Some(new)) if old.is_same(&new))
}

/// The modules that an earlier version of this command wrote beside its `src/lib.rs`, by file name.
pub(super) fn old_layout(out: &Path) -> Result<BTreeMap<String, String>, OwnCrateError> {
    let mut modules = BTreeMap::new();
    let source = out.join("src");
    let is_old = fs::read_to_string(source.join("lib.rs")).is_ok_and(|library| is_generated(&library));
    if !is_old {
        return Ok(modules);
    }
    for entry in fs::read_dir(&source).map_err(|cause| OwnCrateError::write(&source, cause))?.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".rs") && name != "lib.rs" && entry.path().is_file() {
            let text = read(&entry.path())?;
            modules.extend(is_generated(&text).then_some((name, text)));
        }
    }
    Ok(modules)
}

/// Gives a crate of an earlier version its new `src/lib.rs`, and takes away what moved below `src/generated/`.
pub(super) fn renew(
    out: &Path,
    moved: &BTreeMap<String, String>,
    notes: &mut Vec<String>,
) -> Result<(), OwnCrateError> {
    let source = out.join("src");
    let library = BTreeMap::from([("lib.rs".to_owned(), text::LIBRARY.to_owned())]);
    closedform_project::folder::write(&source, &library).map_err(|cause| OwnCrateError::write(&source, cause))?;
    let judges = out.join("tests/judges.rs");
    let old_judges = fs::read_to_string(&judges).is_ok_and(|text| is_generated(&text)).then_some(judges);
    for path in moved.keys().map(|name| source.join(name)).chain(old_judges) {
        fs::remove_file(&path).map_err(|cause| OwnCrateError::write(&path, cause))?;
    }
    notes.push(
        "what an earlier version generated in src/ and tests/ now stands in src/generated/; src/lib.rs is yours from here \
         on, and tests/values.tsv serves nothing any more"
            .to_owned(),
    );
    Ok(())
}

/// The lines that the user's own files lack for the generated ones to be compiled.
pub(super) fn lines_to_add(out: &Path, runtime: &Runtime, root: &Path) -> Result<Vec<String>, OwnCrateError> {
    let mut lines = Vec::new();
    let sources = ["src/lib.rs", "src/main.rs"].map(|name| fs::read_to_string(out.join(name)).unwrap_or_default());
    if !sources.iter().any(|source| source.contains("mod generated;")) {
        let file = if sources[0].is_empty() && !sources[1].is_empty() { "src/main.rs" } else { "src/lib.rs" };
        // examples in documentation name kernels from the root of a library
        lines.push(format!("add to {file}: pub mod generated; pub use generated::*;"));
    }
    let manifest: toml::Table = read(&out.join("Cargo.toml"))?.parse().unwrap_or_default();
    if manifest.get("dependencies").and_then(|dependencies| dependencies.get("closedform")).is_none() {
        let dependency = runtime.dependency(&RUNTIME, out, root)?;
        lines.push(format!("add to [dependencies] in Cargo.toml: closedform = {dependency}"));
    }
    Ok(lines)
}

/// Writes a file that is not there, in one step; one that is there stays.
pub(super) fn create(out: &Path, name: &str, text: &str) -> Result<(), OwnCrateError> {
    let path = out.join(name);
    let folder = path.parent().unwrap_or(out);
    let written = fs::create_dir_all(folder).and_then(|()| {
        let file = closedform_system::scratch::beside(&path, text)?;
        match file.persist_noclobber(&path) {
            Err(error) if error.error.kind() != io::ErrorKind::AlreadyExists => Err(error.error),
            _ => Ok(()),
        }
    });
    written.map_err(|cause| OwnCrateError::write(&path, cause))
}

/// Whether nothing is in a folder, or it is not there.
pub(super) fn is_empty(folder: &Path) -> Result<bool, OwnCrateError> {
    match fs::read_dir(folder) {
        Ok(mut entries) => Ok(entries.next().is_none()),
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => Ok(true),
        Err(cause) => Err(OwnCrateError::write(folder, cause)),
    }
}

fn read(path: &Path) -> Result<String, OwnCrateError> {
    let bytes = fs::read(path).map_err(|cause| OwnCrateError::write(path, cause))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}
