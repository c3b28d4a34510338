//! Files written all or none: each beside its target first, then renamed.

use std::path::{Path, PathBuf};

use closedform_build::is_marked;
use closedform_system::scratch;
use miette::Diagnostic;
use tempfile::NamedTempFile;
use thiserror::Error;

/// What the first line of every file that may be replaced says.
const MARK: &str = "written by `closedform ";

/// Refuses to replace files that this command did not write.
pub fn replaceable<'a>(paths: impl IntoIterator<Item = &'a Path>) -> Result<(), WriteError> {
    let is_marked = |text: &[u8]| is_marked(&String::from_utf8_lossy(text), MARK);
    let foreign = |path: &&Path| std::fs::read(path).is_ok_and(|text| !text.is_empty() && !is_marked(&text));
    match paths.into_iter().find(foreign) {
        None => Ok(()),
        Some(path) => {
            let cause =
                std::io::Error::other("it is there, and its first line does not say that `closedform` wrote it");
            Err(WriteError { path: path.to_owned(), cause, remedy: "rename it if it is yours, or delete it" })
        }
    }
}

/// A file that could not be written; what was there before is untouched.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot write {}: {cause}", path.display())]
#[diagnostic(help("{remedy}"))]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    pub cause: std::io::Error,
    /// What to do about it.
    pub remedy: &'static str,
}

impl WriteError {
    /// Where there is no room, or no right to write.
    #[must_use]
    pub fn new(path: &Path, cause: std::io::Error) -> Self {
        Self { path: path.to_owned(), cause, remedy: "make room and get the right to write there" }
    }
}

/// Writes all files; none is replaced before the texts of all are on disk.
pub fn write_all(files: &[(&Path, &str)]) -> Result<(), WriteError> {
    let mut ready = Vec::new();
    for (path, text) in files {
        ready.push((path, beside(path, text).map_err(|cause| WriteError::new(path, cause))?));
    }
    for (path, file) in ready {
        file.persist(path).map_err(|error| WriteError::new(path, error.error))?;
    }
    Ok(())
}

fn beside(path: &Path, text: &str) -> std::io::Result<NamedTempFile> {
    let file = scratch::beside(path, text)?;
    if let Ok(replaced) = std::fs::metadata(path) {
        file.as_file().set_permissions(replaced.permissions())?;
    }
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    #[test]
    fn what_others_wrote_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.ref");
        assert!(replaceable([&*path]).is_ok());
        std::fs::write(&path, "/* written by `closedform derive a` */\n").unwrap();
        assert!(replaceable([&*path]).is_ok());
        std::fs::write(&path, "/* by hand */\nwritten by `closedform derive`").unwrap();
        assert!(replaceable([&*path]).unwrap_err().to_string().contains("a.ref"));
    }

    #[test]
    fn all_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let (one, two) = (folder.path().join("one"), folder.path().join("missing/two"));
        std::fs::write(&one, "before").unwrap();
        assert_eq!(write_all(&[(&one, "after"), (&two, "")]).unwrap_err().path, two);
        assert_eq!(std::fs::read_to_string(&one).unwrap(), "before");
        std::fs::set_permissions(&one, std::fs::Permissions::from_mode(0o640)).unwrap();
        write_all(&[(&one, "after")]).unwrap();
        assert_eq!(std::fs::read_to_string(&one).unwrap(), "after");
        assert_eq!(std::fs::metadata(&one).unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
