//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use tempfile::{Builder, NamedTempFile};

/// How the names of temporary files begin and end, around letters and digits that the system chooses; also in codegen.
const START: &str = ".closedform-";
const END: &str = ".part";
const CHOSEN: usize = 6;

/// So long after it was made, a temporary file in use is certainly locked.
const YOUNG: Duration = Duration::from_secs(60);

/// The temporary files that are being written.
static BEGUN: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes the files that are being written: for a command that is interrupted, and ends.
#[cfg(feature = "command")]
pub fn remove_begun() {
    let begun = BEGUN.lock().unwrap_or_else(PoisonError::into_inner);
    for path in begun.iter() {
        _ = fs::remove_file(path);
    }
}

/// One of them, as long as it lives.
struct Begun(PathBuf);

impl Begun {
    fn new(path: &Path) -> Self {
        BEGUN.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Begun {
    fn drop(&mut self) {
        BEGUN.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

/// Writes a file beside its place and moves it there when all is written: a reader sees the old file or the new one, and
/// where `write` fails, the old one stays.
pub(crate) fn write_whole<T, E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut File>) -> Result<T, E>,
) -> Result<T, E> {
    let mut file = beside(path)?;
    let _begun = Begun::new(file.path());
    let mut out = BufWriter::new(file.as_file_mut());
    let result = write(&mut out)?;
    out.flush()?;
    drop(out);
    file.persist(path).map_err(|error| error.error)?;
    Ok(result)
}

/// A temporary file in the folder of `path`, because a file moves in one step only within a file system.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    remove_left(folder);
    let mut builder = Builder::new();
    builder.prefix(START).suffix(END).rand_bytes(CHOSEN);
    // As any other new file, the umask allowing; a temporary one is its owner's alone.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder).map_err(without_its_name)?;
    // Says that it is in use; on a file system without locks nobody can lock it, so nobody removes it.
    _ = file.as_file().try_lock();
    Ok(file)
}

/// What the system said, without the name of the temporary file: whoever reads it knows the one that it stands for.
fn without_its_name(error: io::Error) -> io::Error {
    let (said, kind) = (error.to_string(), error.kind());
    said.split_once(" at path \"").map_or(error, |(said, _)| io::Error::new(kind, said.to_owned()))
}

/// Removes the temporary files of killed commands: those that nobody holds. What cannot be read or removed stays.
fn remove_left(folder: &Path) {
    let paths = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    for path in paths.filter(|path| is_ours(path) && is_left(path)) {
        _ = fs::remove_file(path);
    }
}

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let chosen = name.strip_prefix(START).and_then(|rest| rest.strip_suffix(END)).unwrap_or_default();
    chosen.len() == CHOSEN && chosen.chars().all(|c| c.is_ascii_alphanumeric())
}

fn is_left(path: &Path) -> bool {
    let Ok(file) = File::open(path) else { return false };
    let changed = file.metadata().and_then(|data| data.modified()).ok();
    let is_old = changed.and_then(|changed| changed.elapsed().ok()).is_some_and(|age| age > YOUNG);
    is_old && file.try_lock().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.csv");
        write_whole(&path, |out| out.write_all(b"old")).expect("written");
        let failed: io::Result<()> = write_whole(&path, |out| {
            out.write_all(b"new")?;
            Err(io::Error::other("stop"))
        });
        assert!(failed.is_err());
        assert_eq!(fs::read(&path).expect("the old file"), b"old");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    }

    #[test]
    fn only_what_a_killed_command_left_is_removed() {
        let folder = tempfile::tempdir().expect("a folder");
        let make = |name: &str, age| {
            let file = File::create(folder.path().join(name)).expect("a file");
            file.set_modified(std::time::SystemTime::now() - age).expect("an age");
            file
        };
        drop(make(".closedform-left66.part", 2 * YOUNG));
        drop(make(".closedform-notes.part", 2 * YOUNG));
        drop(make(".closedform-young6.part", Duration::ZERO));
        let used = make(".closedform-used66.part", 2 * YOUNG);
        used.try_lock().expect("a lock");
        write_whole(&folder.path().join("a.csv"), |out| out.write_all(b"new")).expect("written");
        let names = fs::read_dir(folder.path()).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into_owned()).collect();
        names.sort();
        let stay = [".closedform-notes.part", ".closedform-used66.part", ".closedform-young6.part", "a.csv"];
        assert_eq!(names, stay);
    }
}
