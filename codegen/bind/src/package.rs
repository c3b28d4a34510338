//! The crate that holds the kernels, as its manifest says it.

use crate::error::BindError;
use closedform_project::Project;
use std::fs;
use std::path::{Path, PathBuf};

/// The crate that holds the kernels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Package {
    /// Its name, with `-` as written.
    pub name: String,
    /// The name under which Rust code imports it.
    pub import: String,
    /// Whether it has the feature `std`, to be left out on controllers.
    pub has_std: bool,
    /// Its folder.
    pub folder: PathBuf,
}

impl Package {
    /// The crate of a project's kernels, or the one that its root is.
    ///
    /// # Errors
    ///
    /// When there is none.
    pub fn of(project: &Project) -> Result<Self, BindError> {
        let folders = [&project.kernels, &project.root];
        let found = folders.into_iter().find(|folder| folder.join("Cargo.toml").is_file());
        Self::read(found.unwrap_or(&project.kernels))
    }

    fn read(folder: &Path) -> Result<Self, BindError> {
        let fail = |cause: String| BindError::NoCrate { folder: folder.to_owned(), cause };
        let text =
            fs::read_to_string(folder.join("Cargo.toml")).map_err(|cause| fail(format!("Cargo.toml: {cause}")))?;
        let manifest: toml::Table = text.parse().map_err(|cause: toml::de::Error| fail(cause.message().to_owned()))?;
        let entry = |table: &str, key: &str| manifest.get(table).and_then(|table| table.get(key)).cloned();
        let name = entry("package", "name").and_then(|name| name.as_str().map(str::to_owned));
        let name = name.ok_or_else(|| fail("its Cargo.toml names no package".to_owned()))?;
        let import = entry("lib", "name").and_then(|name| name.as_str().map(str::to_owned));
        Ok(Self {
            import: import.unwrap_or_else(|| name.replace('-', "_")),
            name,
            has_std: entry("features", "std").is_some(),
            folder: folder.to_owned(),
        })
    }
}
