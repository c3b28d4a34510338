//! Generated folders: compared whole with what they should hold, and replaced whole.

use similar::TextDiff;
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

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

fn diff(name: &str, old: &str, new: &str) -> String {
    let diff = TextDiff::from_lines(old, new);
    diff.unified_diff().context_radius(2).header(&format!("{name} (checked in)"), &format!("{name} (regenerated)")).to_string()
}

fn read(folder: &Path) -> io::Result<BTreeMap<String, String>> {
    let mut files = BTreeMap::new();
    if !folder.exists() {
        return Ok(files);
    }
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        files.insert(name, String::from_utf8_lossy(&fs::read(entry.path())?).into_owned());
    }
    Ok(files)
}

/// Writes what differs, each file in one step, and removes orphans; says how many files changed.
///
/// All texts are on disk under temporary names before the first file is replaced.
///
/// # Errors
/// When the folder cannot be written; files are then as they were, but for those already renamed.
pub fn replace(folder: &Path, files: &BTreeMap<String, String>) -> io::Result<usize> {
    let differences = compare(folder, files)?;
    fs::create_dir_all(folder)?;
    let mut pending = Vec::new();
    for difference in &differences {
        if let Difference::Stale(name, _) | Difference::Missing(name) = difference {
            let mut file = tempfile::NamedTempFile::new_in(folder)?;
            file.write_all(files[name].as_bytes())?;
            pending.push((file, name));
        }
    }
    for (file, name) in pending {
        make_readable(file.as_file())?;
        file.persist(folder.join(name)).map_err(|error| error.error)?;
    }
    for difference in &differences {
        if let Difference::Orphan(name) = difference {
            fs::remove_file(folder.join(name))?;
        }
    }
    Ok(differences.len())
}

/// Temporary files are private; generated ones are for everybody to read.
#[cfg(unix)]
fn make_readable(file: &fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_file: &fs::File) -> io::Result<()> {
    Ok(())
}
