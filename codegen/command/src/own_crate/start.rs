//! A new project: the example's files, and those that are written around them.

use std::fs;
use std::path::{Path, PathBuf};

use super::place;
use super::runtime::{BUILD, RUNTIME};
use super::{OwnCrateError, Runtime, name, text, workspace};
use crate::schema;

/// What is made of the example's worksheet, for the crate and for the project; a test makes them anew.
const CRATE: [(&str, &str); 4] = [
    ("src/generated/braking.rs", include_str!("../../example/generated/braking.rs")),
    ("src/generated/braking.tsv", include_str!("../../example/generated/braking.tsv")),
    ("src/generated/judges.rs", include_str!("../../example/generated/judges.rs")),
    ("src/generated/mod.rs", include_str!("../../example/generated/mod.rs")),
];
const PROJECT: [(&str, &str); 5] = [
    ("maxima-ref/braking.mac", include_str!("../../example/braking.mac")),
    ("maxima-ref/braking.ref", include_str!("../../example/braking.ref")),
    ("maxima-ref/braking.toml", include_str!("../../example/braking.toml")),
    ("maxima-ref/braking.tsv", include_str!("../../example/braking.tsv")),
    ("records/LEDGER.csv", include_str!("../../example/LEDGER.csv")),
];

/// What editors check its TOML files by; the first lines of those name them.
const SCHEMAS: [(&str, &str); 2] =
    [("schema/contract.schema.json", schema::CONTRACT), ("schema/project.schema.json", schema::PROJECT)];

/// How the project is laid out.
struct Layout {
    /// The folder of the crate, from the project's.
    kernels: &'static str,
    /// The way back.
    worksheets: &'static str,
}

/// In a workspace, the project is a crate that the workspace may hold; elsewhere it is a workspace that holds one.
const MEMBER: Layout = Layout { kernels: ".", worksheets: "maxima-ref" };
const WHOLE: Layout = Layout { kernels: "kernels", worksheets: "../maxima-ref" };

/// Writes a new project; returns what the user should know.
///
/// # Errors
///
/// When the folder is not new or empty, or cannot be written.
pub fn start(folder: &Path, runtime: &Runtime) -> miette::Result<Vec<String>> {
    if folder.is_file() {
        return Err(OwnCrateError::File(folder.to_owned()).into());
    }
    if !place::is_empty(folder)? {
        return Err(OwnCrateError::NotEmpty(folder.to_owned()).into());
    }
    let mut made = Made::default();
    let notes = made.folder(folder).and_then(|()| fill(folder, runtime, &mut made));
    if notes.is_err() {
        made.undo();
    }
    Ok(notes?)
}

/// Writes the files.
fn fill(folder: &Path, runtime: &Runtime, made: &mut Made) -> Result<Vec<String>, OwnCrateError> {
    let name = name::package(folder)?;
    let enclosing = workspace::enclosing(folder);
    let layout = if enclosing.is_some() { MEMBER } else { WHOLE };
    let kernels = folder.join(layout.kernels);
    made.folder(&kernels)?;
    let [library, build] = [RUNTIME, BUILD].map(|part| runtime.dependency(&part, &kernels, Path::new("")));
    let manifest = text::manifest(&name.package, &library?, enclosing.as_ref());
    let build = format!("\n[build-dependencies]\nclosedform-build = {}\n", build?);
    made.file(&kernels, "Cargo.toml", &text::with_table(&manifest, &build))?;
    made.file(&kernels, "build.rs", &text::build_script(layout.worksheets))?;
    made.file(&kernels, "src/lib.rs", text::LIBRARY)?;
    for (path, text) in CRATE {
        made.file(&kernels, path, text)?;
    }
    for (path, text) in PROJECT.into_iter().chain(SCHEMAS) {
        made.file(folder, path, text)?;
    }
    if enclosing.is_none() {
        made.file(folder, "Cargo.toml", text::WORKSPACE)?;
    }
    made.file(folder, "README.md", &text::project_readme(&name.package))?;
    made.file(folder, "Makefile", text::MAKEFILE)?;
    made.file(folder, ".github/workflows/kernels.yml", &text::workflow(&runtime.install()))?;
    made.file(folder, ".gitignore", text::IGNORE)?;
    // last: what it stands in is a project, and whole
    made.file(folder, "closedform.toml", &text::project(layout.kernels))?;
    Ok(name.note().into_iter().chain(enclosing.as_ref().and_then(workspace::Enclosing::note)).collect())
}

/// What was made so far, folders before what is in them.
#[derive(Default)]
struct Made(Vec<PathBuf>);

impl Made {
    fn folder(&mut self, folder: &Path) -> Result<(), OwnCrateError> {
        let new: Vec<&Path> =
            folder.ancestors().take_while(|above| !above.as_os_str().is_empty() && !above.exists()).collect();
        self.0.extend(new.into_iter().rev().map(Path::to_owned));
        fs::create_dir_all(folder).map_err(|cause| OwnCrateError::write(folder, cause))
    }

    fn file(&mut self, below: &Path, name: &str, text: &str) -> Result<(), OwnCrateError> {
        let path = below.join(name);
        self.folder(path.parent().unwrap_or(below))?;
        place::create(below, name, text)?;
        self.0.push(path);
        Ok(())
    }

    /// Takes it away; a folder that somebody else has put something into stays.
    fn undo(&self) {
        for path in self.0.iter().rev() {
            _ = if path.is_dir() { fs::remove_dir(path) } else { fs::remove_file(path) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_a_project_or_nothing() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("deep/mine");
        assert!(start(&folder, &Runtime::Folder("nowhere".into())).is_err());
        assert_eq!(fs::read_dir(parent.path()).unwrap().count(), 0);
        fs::create_dir_all(&folder).unwrap();
        assert!(start(&folder, &Runtime::Folder("nowhere".into())).is_err());
        assert!(folder.is_dir() && place::is_empty(&folder).unwrap());
        start(&folder, &Runtime::Version).unwrap();
        assert!(folder.join("closedform.toml").is_file());
    }

    #[test]
    fn what_others_put_there_stays() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("mine");
        let mut made = Made::default();
        made.file(&folder, "sub/ours.txt", "ours").unwrap();
        fs::write(folder.join("theirs.txt"), "theirs").unwrap();
        made.undo();
        let left: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(left, ["theirs.txt"]);
    }
}
