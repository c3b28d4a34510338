//! A crate of one's own: kernels below `src/generated/` of a folder whose other files belong to the user.
//!
//! A new folder gets everything that a crate needs, once: `Cargo.toml`, `src/lib.rs` and a README are the user's from then
//! on. Below `src/generated/` stands what is generated, each file marked in its first line: a module for each worksheet,
//! the index of all of them, and the judges with their values. A file without that mark is never touched.

mod error;
mod module;
mod name;
mod place;
mod runtime;
mod start;
mod text;
mod values;
mod workspace;

pub use error::OwnCrateError;
pub use module::module;
pub use runtime::Runtime;
pub use start::start;

use closedform_measure::catalogue::Catalogue;
use closedform_project::generated::Generated;
use closedform_project::{Project, folder, layout};
use closedform_system::scratch::Folder;
use place::Place;
use runtime::RUNTIME;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// What was made of worksheets, before anything is written.
pub struct Draft {
    /// The modules.
    files: BTreeMap<String, String>,
    /// The same as a folder, as commands read them.
    folder: Folder,
}

impl Draft {
    /// The files of the kernels that were made.
    ///
    /// # Errors
    ///
    /// When there is no room for them.
    pub fn new(generated: &Generated) -> miette::Result<Self> {
        let files = generated.files.clone();
        let folder = Folder::new().map_err(|cause| OwnCrateError::write(Path::new("a temporary folder"), cause))?;
        folder::write(folder.path(), &files).map_err(|cause| OwnCrateError::write(folder.path(), cause))?;
        Ok(Self { files, folder })
    }

    /// The kernels.
    ///
    /// # Errors
    ///
    /// When they do not read back.
    pub fn catalogue(&self) -> miette::Result<Catalogue> {
        Ok(Catalogue::load(self.folder.path())?)
    }

    /// Everything below `src/generated/` of a crate that holds these kernels and no others: modules, index, and if it is to
    /// judge them itself, values and judges.
    ///
    /// # Errors
    ///
    /// When a kernel has no values on its domain.
    pub fn whole(&self, judges: bool) -> miette::Result<BTreeMap<String, String>> {
        let (catalogue, mut files) = (self.catalogue()?, self.files.clone());
        if judges {
            files.extend(values::missing(&catalogue, self.folder.path())?);
        }
        files.extend(text::joint(&catalogue, judges));
        Ok(files)
    }
}

/// The names of all files that are generated of families, with values and judges unless others judge them.
pub fn names<'a>(families: impl IntoIterator<Item = &'a str>, judges: bool) -> BTreeSet<String> {
    let modules: BTreeSet<&str> = families.into_iter().collect();
    let endings: &[&str] = if judges { &["rs", "tsv"] } else { &["rs"] };
    let joint = [text::INDEX].into_iter().chain(judges.then_some(text::JUDGES)).filter(|_| !modules.is_empty());
    let of_module = |module: &str| endings.iter().map(|ending| format!("{module}.{ending}")).collect::<Vec<_>>();
    modules.iter().flat_map(|module| of_module(module)).chain(joint.map(str::to_owned)).collect()
}

/// Whether the kernels of `worksheet` may be written to `out`; nothing is written.
///
/// # Errors
///
/// When `out` is something else than a new folder, a crate, or an empty folder.
pub fn check(out: &Path) -> miette::Result<()> {
    Place::look(out)?;
    let Ok(whole) = out.canonicalize() else { return Ok(()) };
    for folder in whole.ancestors().filter(|folder| folder.join(layout::FILE).is_file()) {
        let project = Project::at(folder)?;
        if project.kernels.canonicalize().is_ok_and(|kernels| kernels == whole) {
            return Err(OwnCrateError::Project { out: out.to_owned(), worksheets: project.worksheets }.into());
        }
    }
    Ok(())
}

/// Gives a folder that is new or empty what a crate needs besides its kernels, once. Returns what the user should know.
///
/// # Errors
///
/// When `out` is something else than a new folder, a crate, or an empty folder, or cannot be written.
pub fn found(out: &Path, runtime: &Runtime, root: &Path) -> miette::Result<Vec<String>> {
    let fail = |cause| OwnCrateError::write(out, cause);
    fs::create_dir_all(out).map_err(fail)?;
    let _alone = place::lock(out).map_err(fail)?;
    match Place::look(out)? {
        Place::Empty => new_files(out, runtime, root),
        Place::Crate | Place::OldCrate => Ok(Vec::new()),
    }
}

/// Writes the crate, or adds the worksheet to it; one process at a time. Returns what the user should know, a line each.
///
/// # Errors
///
/// When the place is taken by what is not generated, or cannot be written.
pub fn write(draft: &Draft, out: &Path, runtime: &Runtime, root: &Path) -> miette::Result<Vec<String>> {
    let fail = |path: &Path| {
        let path = path.to_owned();
        move |cause| OwnCrateError::write(&path, cause)
    };
    fs::create_dir_all(out).map_err(fail(out))?;
    let _alone = place::lock(out).map_err(fail(out))?;
    let place = Place::look(out)?;
    let mut notes = if place == Place::Empty { new_files(out, runtime, root)? } else { Vec::new() };
    let generated = out.join(place::GENERATED);
    let mut files = draft.files.clone();
    files.extend(values::missing(&draft.catalogue()?, draft.folder.path())?);
    place::check_owner(&generated, &files)?;
    let moved = place::old_layout(out)?;
    files.extend(
        moved
            .iter()
            .filter(|(name, _)| !draft.files.contains_key(*name))
            .map(|(name, text)| (name.clone(), text.clone())),
    );
    folder::write(&generated, &files).map_err(fail(&generated))?;
    let catalogue = Catalogue::load(&generated)?;
    let missing = values::missing(&catalogue, &generated)?;
    folder::write(&generated, &missing).map_err(fail(&generated))?;
    folder::write(&generated, &text::joint(&catalogue, true)).map_err(fail(&generated))?;
    if place == Place::OldCrate {
        place::renew(out, &moved, &mut notes)?;
    }
    notes.extend(place::lines_to_add(out, runtime, root)?);
    Ok(notes)
}

/// The files of a new crate, which are never written again.
fn new_files(out: &Path, runtime: &Runtime, root: &Path) -> miette::Result<Vec<String>> {
    let name = name::package(out)?;
    let enclosing = workspace::enclosing(out);
    let manifest = text::manifest(&name.package, &runtime.dependency(&RUNTIME, out, root)?, enclosing.as_ref());
    place::create(out, "Cargo.toml", &manifest)?;
    place::create(out, "src/lib.rs", text::LIBRARY)?;
    place::create(out, "README.md", &text::readme(&name.package))?;
    place::create(out, ".gitignore", text::IGNORE)?;
    Ok(name.note().into_iter().chain(enclosing.as_ref().and_then(workspace::Enclosing::note)).collect())
}
