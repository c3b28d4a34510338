//! Files written all or none: each beside its target first, then renamed.

use std::io::Write;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use tempfile::NamedTempFile;
use thiserror::Error;

use crate::scratch;

/// A file that could not be written; what was there before is untouched.
#[derive(Debug, Error, Diagnostic)]
#[error("cannot write {}: {cause}", path.display())]
#[diagnostic(help("make room and get the right to write in this folder"))]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// Why not.
    #[source]
    pub cause: std::io::Error,
}

/// Writes all files; none is replaced before the texts of all are on disk.
pub fn write_all(files: &[(&Path, &str)]) -> Result<(), WriteError> {
    let fail = |path: &Path, cause| WriteError { path: path.to_owned(), cause };
    let mut ready = Vec::new();
    for (path, text) in files {
        ready.push((path, beside(path, text).map_err(|cause| fail(path, cause))?));
    }
    for (path, file) in ready {
        file.persist(path).map_err(|error| fail(path, error.error))?;
    }
    Ok(())
}

fn beside(path: &Path, text: &str) -> std::io::Result<NamedTempFile> {
    let mut file = scratch::beside(path)?;
    file.write_all(text.as_bytes())?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let (one, two) = (folder.path().join("one"), folder.path().join("missing/two"));
        std::fs::write(&one, "before").unwrap();
        assert_eq!(write_all(&[(&one, "after"), (&two, "")]).unwrap_err().path, two);
        assert_eq!(std::fs::read_to_string(&one).unwrap(), "before");
        write_all(&[(&one, "after")]).unwrap();
        assert_eq!(std::fs::read_to_string(&one).unwrap(), "after");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
