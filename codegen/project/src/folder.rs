//! Generated folders: compared whole with what they should hold, and replaced whole.

use crate::files::WriteError;
use closedform_build::{MARK, is_marked};
use closedform_system::scratch;
use similar::TextDiff;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How a file differs from what it should be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Difference {
    /// It has another text; the difference as a unified diff.
    Stale(String, String),
    /// It is not there.
    Missing(String),
    /// It should not be there.
    Orphan(String),
}

/// Whether a text says of itself that it was generated.
#[must_use]
pub fn is_generated(text: &str) -> bool {
    is_marked(text, MARK)
}

/// The first of these files that is there and lacks this mark: somebody else wrote it.
///
/// # Errors
/// When one cannot be read.
pub fn foreign(paths: impl IntoIterator<Item = PathBuf>, mark: &str) -> Result<Option<PathBuf>, WriteError> {
    for path in paths.into_iter().filter(|path| path.exists()) {
        let text = fs::read(&path).map_err(|cause| WriteError::new(&path, cause))?;
        if !is_marked(&String::from_utf8_lossy(&text), mark) {
            return Ok(Some(path));
        }
    }
    Ok(None)
}

/// Every difference between a folder and the files it should hold.
///
/// # Errors
/// When the folder cannot be read.
pub fn compare(folder: &Path, files: &BTreeMap<String, String>) -> io::Result<Vec<Difference>> {
    let present = read(folder)?;
    let mut differences = Vec::new();
    for (name, text) in files {
        match present.get(name) {
            None => differences.push(Difference::Missing(name.clone())),
            Some(old) if old != text => differences.push(Difference::Stale(name.clone(), diff(name, old, text))),
            Some(_) => {}
        }
    }
    let orphans = present.keys().filter(|name| !files.contains_key(*name));
    differences.extend(orphans.map(|name| Difference::Orphan(name.clone())));
    Ok(differences)
}

/// What is different, as a unified diff.
pub fn diff(name: &str, old: &str, new: &str) -> String {
    let diff = TextDiff::from_lines(old, new);
    diff.unified_diff()
        .context_radius(2)
        .header(&format!("{name} (checked in)"), &format!("{name} (regenerated)"))
        .to_string()
}

/// The names of the files of a folder that were generated, sorted.
///
/// # Errors
/// When the folder cannot be read.
pub fn generated(folder: &Path) -> io::Result<Vec<String>> {
    Ok(read(folder)?.into_iter().filter(|(_, text)| is_generated(text)).map(|(name, _)| name).collect())
}

fn read(folder: &Path) -> io::Result<BTreeMap<String, String>> {
    let mut files = BTreeMap::new();
    if !folder.exists() {
        return Ok(files);
    }
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            continue;
        }
        let name = entry.file_name().to_string_lossy().into_owned();
        files.insert(name, String::from_utf8_lossy(&fs::read(entry.path())?).into_owned());
    }
    Ok(files)
}

/// Writes what differs, each file in one step, and removes generated orphans; says how many files changed.
///
/// All texts are on disk under temporary names before the first file is replaced. What somebody else wrote stays.
///
/// # Errors
/// When the folder cannot be written; files are then as they were, but for those already renamed.
pub fn replace(folder: &Path, files: &BTreeMap<String, String>) -> io::Result<usize> {
    let written = write(folder, files)?;
    let present = read(folder)?;
    let orphans = present.iter().filter(|(name, text)| !files.contains_key(*name) && is_generated(text));
    let orphans: Vec<&String> = orphans.map(|(name, _)| name).collect();
    orphans.iter().try_for_each(|name| fs::remove_file(folder.join(name)))?;
    Ok(written + orphans.len())
}

/// Writes what differs, each file in one step, and leaves all others; says how many files changed.
///
/// # Errors
/// As [`replace`].
pub fn write(folder: &Path, files: &BTreeMap<String, String>) -> io::Result<usize> {
    fs::create_dir_all(folder)?;
    let mut pending = Vec::new();
    for difference in &compare(folder, files)? {
        if let Difference::Stale(name, _) | Difference::Missing(name) = difference {
            pending.push((scratch::beside(&folder.join(name), &files[name])?, name.clone()));
        }
    }
    let changed = pending.len();
    for (file, name) in pending {
        file.persist(folder.join(name)).map_err(|error| error.error)?;
    }
    Ok(changed)
}
