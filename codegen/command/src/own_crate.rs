//! A crate of one's own: kernels below `src/generated/` of a folder whose other files belong to the user.
//!
//! A new folder gets everything that a crate needs, once: `Cargo.toml`, `src/lib.rs` and a README are the user's from then
//! on. Below `src/generated/` stands what is generated, each file marked in its first line: a module for each worksheet,
//! the index of all of them, and the judges with their values. A file without that mark is never touched.

mod error;
mod name;
mod place;
mod runtime;
mod text;
mod values;
mod workspace;

pub use error::OwnCrateError;
pub use runtime::Runtime;

use closedform_measure::catalogue::Catalogue;
use closedform_project::folder;
use closedform_project::generated::Generated;
use closedform_system::scratch::Folder;
use place::Place;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What was made of a worksheet, before anything is written.
pub struct Draft {
    /// The module of the worksheet.
    module: String,
    files: BTreeMap<String, String>,
    /// The generated sources as a folder, as commands read them.
    folder: Folder,
}

impl Draft {
    /// The files of a worksheet's kernels, with values that judge them.
    ///
    /// # Errors
    ///
    /// When a kernel has no values on its domain.
    pub fn new(generated: &Generated) -> miette::Result<Self> {
        let mut files = generated.files.clone();
        files.remove(text::INDEX);
        let module = files.keys().next().and_then(|name| name.strip_suffix(".rs")).unwrap_or_default().to_owned();
        let folder = Folder::new().map_err(|cause| OwnCrateError::write(Path::new("a temporary folder"), cause))?;
        folder::write(folder.path(), &files).map_err(|cause| OwnCrateError::write(folder.path(), cause))?;
        let values =
            values::text(&Catalogue::load(folder.path())?, &text::mark_of_values(&files[&format!("{module}.rs")]))?;
        files.insert(format!("{module}.tsv"), values);
        Ok(Self { module, files, folder })
    }

    /// The kernels.
    ///
    /// # Errors
    ///
    /// When they do not read back.
    pub fn catalogue(&self) -> miette::Result<Catalogue> {
        Ok(Catalogue::load(self.folder.path())?)
    }
}

/// Whether the kernels of `worksheet` may be written to `out`; nothing is written.
///
/// # Errors
///
/// When `out` is something else than a new folder, a crate, or an empty folder.
pub fn check(out: &Path) -> Result<(), OwnCrateError> {
    Place::look(out).map(|_| ())
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
    let mut notes = Vec::new();
    if place == Place::Empty {
        found(out, runtime, root, &mut notes)?;
    }
    let generated = out.join(place::GENERATED);
    place::check_owner(&generated, &draft.module, &draft.files)?;
    let moved = place::old_layout(out)?;
    let mut files = draft.files.clone();
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
    let index = BTreeMap::from([
        (text::INDEX.to_owned(), text::index(&catalogue)),
        (text::JUDGES.to_owned(), text::judges(&catalogue)),
    ]);
    folder::write(&generated, &index).map_err(fail(&generated))?;
    if place == Place::OldCrate {
        place::renew(out, &moved, &mut notes)?;
    }
    notes.extend(place::lines_to_add(out, runtime, root)?);
    Ok(notes)
}

/// The files of a new crate, which are never written again.
fn found(out: &Path, runtime: &Runtime, root: &Path, notes: &mut Vec<String>) -> miette::Result<()> {
    let name = name::package(out)?;
    let enclosing = workspace::enclosing(out);
    let manifest = text::manifest(&name.package, &runtime.dependency(out, root)?, enclosing.as_ref());
    notes.extend(name.note());
    notes.extend(enclosing.as_ref().and_then(workspace::Enclosing::note));
    place::create(out, "Cargo.toml", &manifest)?;
    place::create(out, "src/lib.rs", text::LIBRARY)?;
    place::create(out, "README.md", &text::readme(&name.package))?;
    place::create(out, ".gitignore", text::IGNORE)?;
    Ok(())
}
