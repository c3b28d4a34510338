//! The project: where its worksheets, kernels and records are, by its `closedform.toml` or by default.

use std::io;
use std::ops::Range;
use std::path::{Component, Path, PathBuf};

use miette::{Diagnostic, NamedSource, SourceSpan};
use serde::Deserialize;
use thiserror::Error;

/// The file that makes a folder a project.
pub const FILE: &str = "closedform.toml";

/// The folder that does without it.
const WORKSHEETS: &str = "maxima-ref";

/// A project on disk.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Project {
    /// The folder that `closedform.toml` is in.
    pub root: PathBuf,
    /// Worksheets and contracts, and what Maxima made of them.
    pub worksheets: PathBuf,
    /// The crate of the kernels.
    pub kernels: PathBuf,
    /// What was measured and found: the ledger, worst inputs, what is known of mutants.
    pub records: PathBuf,
    /// A page that shows the table of kernels.
    pub table: Option<PathBuf>,
    /// Whether the crate of the kernels carries judges of its own.
    pub judges: bool,
    /// What its commands may use.
    pub limits: Limits,
}

/// Limits in seconds, where a project sets them; `closedform_system::limit` says what they are of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Limits {
    /// The processor time of one worksheet in Maxima.
    pub maxima: Option<u64>,
    /// The processor time that the algebra may take for one kernel.
    pub kernel: Option<u64>,
    /// How long to wait for the turn to use Symbolica.
    pub wait: Option<u64>,
}

/// `closedform.toml` as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(default = "worksheets")]
    worksheets: PathBuf,
    #[serde(default = "kernels")]
    kernels: PathBuf,
    #[serde(default = "records")]
    records: PathBuf,
    table: Option<PathBuf>,
    #[serde(default = "yes")]
    judges: bool,
    #[serde(default)]
    limits: Limits,
}

fn worksheets() -> PathBuf {
    WORKSHEETS.into()
}

fn kernels() -> PathBuf {
    "kernels".into()
}

fn records() -> PathBuf {
    "records".into()
}

fn yes() -> bool {
    true
}

/// Why there is no project.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ProjectError {
    /// The named folder is none.
    #[error("{} is no folder", .0.display())]
    #[diagnostic(help("name the folder that holds {FILE} or {WORKSHEETS}"))]
    NoFolder(PathBuf),
    /// A file cannot be read, or there is no current folder.
    #[error("cannot read {}: {cause}", path.display())]
    #[diagnostic(help("get the right to read it, or name another folder with --root"))]
    Read {
        /// Which.
        path: PathBuf,
        /// Why not.
        cause: io::Error,
    },
    /// `closedform.toml` is wrong.
    #[error("{message}")]
    #[diagnostic(help(
        "{FILE} may say worksheets, kernels, records and table, which are paths from its folder, and judges = false; \
         [limits] may say maxima, kernel and wait, which are whole seconds"
    ))]
    Wrong {
        /// What is wrong.
        message: String,
        /// The file.
        #[source_code]
        text: NamedSource<String>,
        /// Where.
        #[label("here")]
        place: SourceSpan,
    },
    /// A path leads out of the project.
    #[error("{FILE}: `{key} = {:?}` leads out of the project", path.display())]
    #[diagnostic(help("write a path below the folder of {FILE}, or `.` for that folder itself"))]
    Outside {
        /// Which key.
        key: &'static str,
        /// What it says.
        path: PathBuf,
    },
}

impl Project {
    /// The project of the named folder, or the nearest around the current one; where there is none, one in the current
    /// folder whose parts are where they are by default.
    ///
    /// # Errors
    ///
    /// When the named folder does not exist, or `closedform.toml` is wrong.
    pub fn find(named: Option<&Path>) -> Result<Self, ProjectError> {
        if let Some(named) = named {
            return if named.is_dir() { Self::at(named) } else { Err(ProjectError::NoFolder(named.to_owned())) };
        }
        let read = |cause| ProjectError::Read { path: ".".into(), cause };
        let current = std::env::current_dir().map_err(read)?;
        let holds = |what: fn(&Path) -> bool| current.ancestors().find(|folder| what(folder));
        let found =
            holds(|folder| folder.join(FILE).is_file()).or_else(|| holds(|folder| folder.join(WORKSHEETS).is_dir()));
        Self::at(found.unwrap_or(&current))
    }

    /// The project of a folder.
    ///
    /// # Errors
    ///
    /// When `closedform.toml` is wrong.
    pub fn at(root: &Path) -> Result<Self, ProjectError> {
        let path = root.join(FILE);
        let text = match std::fs::read_to_string(&path) {
            Err(cause) if cause.kind() == io::ErrorKind::NotFound => String::new(),
            text => text.map_err(|cause| ProjectError::Read { path: path.clone(), cause })?,
        };
        let written: Written = toml::from_str(&text).map_err(|error| wrong(&path, &text, &error))?;
        let below = |key, path: PathBuf| below(root, key, path);
        Ok(Self {
            root: root.to_owned(),
            worksheets: below("worksheets", written.worksheets)?,
            kernels: below("kernels", written.kernels)?,
            records: below("records", written.records)?,
            table: written.table.map(|table| below("table", table)).transpose()?,
            judges: written.judges,
            limits: written.limits,
        })
    }

    /// Where generated files stand, all of them.
    #[must_use]
    pub fn generated(&self) -> PathBuf {
        self.kernels.join("src/generated")
    }

    /// A path as one reads it from the root.
    #[must_use]
    pub fn shown(&self, path: &Path) -> String {
        path.strip_prefix(&self.root).unwrap_or(path).display().to_string()
    }
}

fn below(root: &Path, key: &'static str, path: PathBuf) -> Result<PathBuf, ProjectError> {
    let leads_below = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    // `.` leaves nothing of a path, so that no path shows a needless `./`
    let parts: PathBuf = path.components().filter(|part| *part != Component::CurDir).collect();
    match (leads_below, parts.as_os_str().is_empty()) {
        (false, _) => Err(ProjectError::Outside { key, path }),
        (true, true) => Ok(root.to_owned()),
        (true, false) => Ok(root.join(parts)),
    }
}

fn wrong(path: &Path, text: &str, error: &toml::de::Error) -> ProjectError {
    let place: Range<usize> = error.span().unwrap_or_default();
    let text = NamedSource::new(path.to_string_lossy(), text.to_owned());
    ProjectError::Wrong { message: error.message().to_owned(), text, place: place.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawn::{drawn, has};
    use std::fs;

    fn read(text: &str) -> Result<Project, ProjectError> {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(FILE), text).unwrap();
        let mut project = Project::at(folder.path())?;
        let bare = |path: &Path| path.strip_prefix(folder.path()).unwrap().to_owned();
        project.worksheets = bare(&project.worksheets);
        project.kernels = bare(&project.kernels);
        project.records = bare(&project.records);
        project.table = project.table.as_deref().map(bare);
        Ok(project)
    }

    #[test]
    fn what_is_not_said_is_where_it_is_by_default() {
        let project = read("").unwrap();
        assert_eq!((project.worksheets.to_str(), project.kernels.to_str()), (Some("maxima-ref"), Some("kernels")));
        assert_eq!((project.records.to_str(), project.table, project.judges), (Some("records"), None, true));
        let project = read("kernels = \".\"\ntable = \"./docs/kernels.md\"\njudges = false").unwrap();
        assert_eq!((project.kernels.to_str(), project.judges), (Some(""), false));
        assert_eq!(project.table.unwrap().to_str(), Some("docs/kernels.md"));
        let limits = read("[limits]\nmaxima = 600").unwrap().limits;
        assert_eq!(limits, Limits { maxima: Some(600), ..Limits::default() });
    }

    #[test]
    fn what_is_wrong_has_its_place() {
        let said = |text: &str| drawn(&read(text).unwrap_err());
        has(&said("worksheets = \"a\"\nkernel = \"b\""), &["unknown field `kernel`", "closedform.toml:2:1"]);
        has(&said("[limits]\nmaxima = \"long\""), &["expected u64", "closedform.toml:2:10", "whole seconds"]);
        has(&said("[limits]\nkernel = -1"), &["closedform.toml:2:10", "whole seconds"]);
        has(&said("[limits]\nmaxim = 1"), &["unknown field `maxim`", "`maxima`, `kernel`, `wait`"]);
        has(&said("judges = 1"), &["invalid type", "closedform.toml:1:10"]);
        has(&said("kernels = \"../mine\""), &["`kernels = \"../mine\"` leads out of the project"]);
        has(&said("records = \"/tmp\""), &["leads out of the project"]);
        has(
            &drawn(&Project::find(Some(Path::new("no/such"))).unwrap_err()),
            &["no/such is no folder", "closedform.toml"],
        );
    }
}
