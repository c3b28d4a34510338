//! The catalogue: every kernel of a folder of generated sources, read as text, so that nothing is rebuilt to use them.

mod entry;
mod error;
#[cfg(any(test, feature = "fixtures"))]
pub mod fixture;
mod nearest;
mod source;

use std::fs;
use std::path::{Path, PathBuf};

pub use entry::{DomainError, Entry, maxima_name, unit_of};
pub use error::{CatalogueError, did_you_mean};
pub use nearest::nearest;

use closedform_project::{Project, ReadError};

/// Where sources stand below a crate or a folder that is no project, the most specific place first.
const FOLDERS: [&str; 3] = ["src/generated", "src", ""];

/// Files that declare modules and hold no kernels.
const INDEXES: [&str; 2] = ["mod", "lib"];

/// Every kernel, sorted by family, in the order of its file.
#[derive(Clone, Debug)]
pub struct Catalogue {
    entries: Vec<Entry>,
}

impl Catalogue {
    /// The kernels of a project; or of the crate, or folder of sources, that its root is.
    ///
    /// # Errors
    ///
    /// When no kernels are found, or a file with kernels cannot be read.
    pub fn open(project: &Project) -> Result<Self, CatalogueError> {
        let places = FOLDERS.iter().map(|folder| project.root.join(folder));
        for folder in [project.generated()].into_iter().chain(places).filter(|folder| folder.is_dir()) {
            let catalogue = Self::load(&folder)?;
            if !catalogue.entries.is_empty() {
                return Ok(catalogue);
            }
        }
        Err(CatalogueError::NoKernels { root: project.root.clone() })
    }

    /// The kernels of the sources in one folder; the stem of a file is the family.
    ///
    /// # Errors
    ///
    /// When the folder or a source cannot be read, or a source is not kernel language.
    pub fn load(folder: &Path) -> Result<Self, CatalogueError> {
        let mut entries = Vec::new();
        for (family, path) in sources(folder)? {
            let text = fs::read_to_string(&path).map_err(|cause| unreadable(&path, cause))?;
            let kernels = closedform_syntax::parse_file(&text)
                .map_err(|cause| CatalogueError::NotKernels { path: path.clone(), cause })?;
            entries.extend(kernels.into_iter().map(|kernel| Entry::new(&family, kernel, &text)));
        }
        Ok(Self { entries })
    }

    /// All kernels.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The kernel called `family::name`; the family may be left off where the name is unique, and the worksheet's name
    /// of a result finds its kernel too.
    ///
    /// # Errors
    ///
    /// When no kernel or more than one has this name.
    pub fn find(&self, name: &str) -> Result<&Entry, CatalogueError> {
        let ways: [fn(&Entry, &str) -> bool; 3] = [Entry::is_named, Entry::is_named_briefly, Entry::has_worksheet_name];
        for way in ways {
            let found: Vec<&Entry> = self.entries.iter().filter(|entry| way(entry, name)).collect();
            match found[..] {
                [] => {}
                [one] => return Ok(one),
                _ => return Err(CatalogueError::Ambiguous { name: name.to_owned(), candidates: names(found) }),
            }
        }
        Err(self.unknown(name))
    }

    /// All kernels, or the one that is asked for.
    ///
    /// # Errors
    ///
    /// As [`find`](Self::find).
    pub fn select(&self, name: Option<&str>) -> Result<Vec<&Entry>, CatalogueError> {
        match name {
            Some(name) => self.find(name).map(|entry| vec![entry]),
            None => Ok(self.entries.iter().collect()),
        }
    }

    fn unknown(&self, name: &str) -> CatalogueError {
        let spellings = self.entries.iter().flat_map(|entry| {
            let full = entry.full_name();
            entry.spellings().into_iter().map(move |spelling| (spelling, full.clone()))
        });
        CatalogueError::Unknown { name: name.to_owned(), nearest: nearest(name, spellings) }
    }
}

fn names(entries: Vec<&Entry>) -> Vec<String> {
    entries.into_iter().map(Entry::full_name).collect()
}

/// Families and paths of the sources in a folder, sorted.
fn sources(folder: &Path) -> Result<Vec<(String, PathBuf)>, CatalogueError> {
    let mut sources = Vec::new();
    for entry in fs::read_dir(folder).map_err(|cause| unreadable(folder, cause))? {
        let path = entry.map_err(|cause| unreadable(folder, cause))?.path();
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == "rs") && !INDEXES.contains(&stem.as_str()) {
            sources.push((stem, path));
        }
    }
    sources.sort();
    Ok(sources)
}

fn unreadable(path: &Path, cause: std::io::Error) -> CatalogueError {
    let remedy = "make it readable, or name another folder with --root".to_owned();
    CatalogueError::Read(ReadError { path: path.to_owned(), cause, remedy })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_are_found_under_every_name() {
        let (_folder, catalogue) = fixture::catalogue();
        let found = |name: &str| catalogue.find(name).map(Entry::full_name).unwrap();
        assert_eq!(names(catalogue.select(None).unwrap()), ["line::root", "line::slope", "plane::slope"]);
        assert_eq!(found("line::root"), "line::root");
        assert_eq!(found("root"), "line::root");
        assert_eq!(found("rootFn"), "line::root");
        assert_eq!(found("cFn"), "plane::slope");
    }

    #[test]
    fn what_is_not_found_says_what_is_near() {
        let (_folder, catalogue) = fixture::catalogue();
        let Err(CatalogueError::Unknown { nearest, .. }) = catalogue.find("lin::rot") else { panic!("unknown") };
        assert_eq!(nearest.first().map(String::as_str), Some("line::root"));
        let Err(CatalogueError::Ambiguous { candidates, .. }) = catalogue.find("slope") else { panic!("ambiguous") };
        assert_eq!(candidates, ["line::slope", "plane::slope"]);
    }

    #[test]
    fn the_folder_is_found_from_the_root() {
        let root = tempfile::tempdir().unwrap();
        let open = |root: &Path| Catalogue::open(&Project::at(root).unwrap());
        assert!(matches!(open(root.path()), Err(CatalogueError::NoKernels { .. })));
        let folder = root.path().join("kernels/src/generated");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("line.rs"), fixture::LINE).unwrap();
        assert_eq!(open(root.path()).unwrap().entries().len(), 2);
        assert_eq!(open(&folder).unwrap().entries().len(), 2);
    }

    #[test]
    fn a_source_with_mistakes_is_named() {
        let root = tempfile::tempdir().unwrap();
        fs::write(root.path().join("bad.rs"), "#[kernel]\npub fn f(x: f64) -> f64 { while x {} x }").unwrap();
        let error = Catalogue::load(root.path()).unwrap_err();
        assert!(error.to_string().contains("bad.rs"), "{error}");
    }
}
