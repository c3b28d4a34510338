//! Temporary files and folders that bear our name and a lock, so that those of a killed command are known and removed.

use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::{Builder, NamedTempFile, TempDir};

/// How names begin and end, around what the system chooses; also in `closedform-motion`.
const FILE: [&str; 2] = [".closedform-", ".part"];

/// The same for folders.
const FOLDER: [&str; 2] = ["closedform-", ".run"];

/// How many letters and digits the system chooses.
const CHOSEN: usize = 6;

/// The file in a folder whose lock says that the folder is in use.
const OWNER: &str = "owner";

/// So long after it was made, what is in use is certainly locked.
const YOUNG: Duration = Duration::from_secs(60);

/// A temporary folder, removed when this is dropped.
pub struct Folder {
    folder: TempDir,
    _owner: File,
}

impl Folder {
    /// A new folder, where the system keeps such.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn new() -> io::Result<Self> {
        Self::within(&std::env::temp_dir())
    }

    fn within(parent: &Path) -> io::Result<Self> {
        sweep(parent, FOLDER, |path| {
            if is_left(&path.join(OWNER)) {
                _ = fs::remove_dir_all(path);
            }
        });
        let folder = Builder::new().prefix(FOLDER[0]).suffix(FOLDER[1]).rand_bytes(CHOSEN).tempdir_in(parent)?;
        let owner = File::create(folder.path().join(OWNER))?;
        _ = owner.try_lock(); // a file system without locks: nobody can lock it, so nobody removes it
        Ok(Self { folder, _owner: owner })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// A temporary file that holds a text, in the folder of `path`, to be moved there in one step; as any new file, for
/// everybody to read.
///
/// # Errors
/// When it cannot be made, or there is no room.
pub fn beside(path: &Path, text: &str) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    sweep(folder, FILE, |path| {
        if is_left(path) {
            _ = fs::remove_file(path);
        }
    });
    let readable = Permissions::from_mode(0o666); // less what the user's umask takes
    let mut builder = Builder::new();
    builder.prefix(FILE[0]).suffix(FILE[1]).rand_bytes(CHOSEN).permissions(readable);
    let mut file = builder.tempfile_in(folder).map_err(without_its_name)?;
    _ = file.as_file().try_lock(); // as above
    file.as_file_mut().write_all(text.as_bytes())?;
    Ok(file)
}

/// What the system said, without the name of a temporary file: whoever reads it knows the one that it stands for.
fn without_its_name(error: io::Error) -> io::Error {
    let (said, kind) = (error.to_string(), error.kind());
    said.split_once(" at path \"").map_or(error, |(said, _)| io::Error::new(kind, said.to_owned()))
}

/// Shows everything in a folder that bears such a name. What cannot be read is left alone: it is no reason to stop.
fn sweep(folder: &Path, name: [&str; 2], remove: impl Fn(&Path)) {
    let paths = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    paths.filter(|path| is_named(path, name)).for_each(|path: PathBuf| remove(&path));
}

fn is_named(path: &Path, [start, end]: [&str; 2]) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let chosen = name.strip_prefix(start).and_then(|rest| rest.strip_suffix(end)).unwrap_or_default();
    chosen.len() == CHOSEN && chosen.chars().all(|c| c.is_ascii_alphanumeric())
}

/// Whether nobody holds the lock of a file any more.
fn is_left(path: &Path) -> bool {
    let Ok(file) = File::open(path) else { return false };
    let changed = file.metadata().and_then(|data| data.modified()).ok();
    let is_old = changed.and_then(|changed| changed.elapsed().ok()).is_some_and(|age| age > YOUNG);
    is_old && file.try_lock().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::SystemTime;

    /// Makes a file with an age.
    fn aged(path: &Path, age: Duration) -> File {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let file = File::create(path).unwrap();
        file.set_modified(SystemTime::now() - age).unwrap();
        file
    }

    #[test]
    fn what_cannot_be_made_is_told_without_temporary_names() {
        let folder = tempfile::tempdir().unwrap();
        let error = beside(&folder.path().join("nowhere/table.csv"), "a\n").unwrap_err();
        assert_eq!(error.to_string(), io::Error::from_raw_os_error(2).to_string());
    }

    #[test]
    fn only_what_a_killed_command_left_is_removed() {
        let parent = tempfile::tempdir().unwrap();
        let at = |name: &str| parent.path().join(name);
        let old = 2 * YOUNG;
        let left = [at(".closedform-aB3dE6.part"), at("closedform-aB3dE6.run/owner")];
        left.iter().for_each(|path| drop(aged(path, old)));
        let kept =
            [".closedform-notes.part", ".closedform-aB3dE6", "closedform-aB3dE6/owner", ".closedform-a.3dE6.part"];
        kept.iter().for_each(|name| drop(aged(&at(name), old)));
        drop(aged(&at(".closedform-young6.part"), Duration::ZERO));
        let used = [at(".closedform-used66.part"), at("closedform-used66.run/owner")].map(|path| {
            let file = aged(&path, old);
            file.try_lock().unwrap();
            (path, file)
        });
        let folder = Folder::within(parent.path()).unwrap();
        let file = beside(&at("table.csv"), "a\n").unwrap();
        assert!(left.iter().all(|path| !path.exists()) && !at("closedform-aB3dE6.run").exists());
        assert!(kept.iter().all(|name| at(name).exists()) && at(".closedform-young6.part").exists());
        assert!(used.iter().all(|(path, _)| path.exists()));
        assert!(is_named(folder.path(), FOLDER) && is_named(file.path(), FILE));
        let made = [folder.path().to_owned(), file.path().to_owned()];
        drop((folder, file));
        assert!(made.iter().all(|path| !path.exists()));
    }
}
