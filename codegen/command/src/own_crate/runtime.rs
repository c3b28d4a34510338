//! The runtime as a dependency of a new crate: a folder, a git repository or a version.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::OwnCrateError;
use crate::program::checkout;
use closedform_system::way::way;

/// Where a new crate takes the runtime from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Runtime {
    /// From the project at hand, or the checkout that this command was built in; if there is none, the published version.
    #[default]
    Beside,
    /// The published version.
    Version,
    /// A git repository.
    Git(String),
    /// A folder.
    Folder(PathBuf),
}

impl FromStr for Runtime {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let is_address = text.contains("://") || text.starts_with("git@") || text.ends_with(".git");
        Ok(match text {
            "version" => Self::Version,
            _ if is_address => Self::Git(text.to_owned()),
            _ => Self::Folder(text.into()),
        })
    }
}

/// A package of closedform that a crate depends on.
pub(super) struct Part {
    package: &'static str,
    /// Its folder in a checkout.
    folder: &'static str,
}

/// What kernels need when they run.
pub(super) const RUNTIME: Part = Part { package: "closedform", folder: "runtime" };

/// What a build script asks whether they are fresh.
pub(super) const BUILD: Part = Part { package: "closedform-build", folder: "codegen/build" };

impl Runtime {
    /// What stands behind `closedform = ` in the manifest of the crate in `out`, which exists; or behind another part.
    pub(super) fn dependency(&self, part: &Part, out: &Path, root: &Path) -> Result<String, OwnCrateError> {
        match self {
            Self::Version => Ok(version()),
            Self::Git(url) => Ok(format!("{{ git = {} }}", quoted(url))),
            Self::Folder(folder) => {
                let checkouts = [folder.clone(), folder.join("..")];
                let found = checkouts.iter().map(|checkout| checkout.join(part.folder)).find(|folder| part.is(folder));
                found.map(|folder| path(out, &folder)).ok_or_else(|| OwnCrateError::NoRuntime(folder.clone()))
            }
            Self::Beside => {
                let found = [root, checkout()].iter().map(|root| root.join(part.folder)).find(|folder| part.is(folder));
                Ok(found.map_or_else(version, |folder| path(out, &folder)))
            }
        }
    }

    /// The line of a shell that installs the command of the same origin.
    pub(super) fn install(&self) -> String {
        match self {
            Self::Git(url) => format!("cargo install --locked --git {url} closedform-cli"),
            // a folder beside the project is nowhere in CI
            Self::Beside | Self::Version | Self::Folder(_) => {
                format!("cargo install --locked closedform-cli@{}", env!("CARGO_PKG_VERSION"))
            }
        }
    }
}

impl Part {
    fn is(&self, folder: &Path) -> bool {
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
        let table: Option<toml::Table> = manifest.parse().ok();
        let name = table.as_ref().and_then(|table| table.get("package")?.get("name")?.as_str());
        name == Some(self.package)
    }
}

fn version() -> String {
    quoted(env!("CARGO_PKG_VERSION"))
}

fn path(out: &Path, folder: &Path) -> String {
    format!("{{ path = {} }}", quoted(&way(out, folder).to_string_lossy().replace('\\', "/")))
}

/// As a string of TOML.
fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_say_where_the_runtime_is() {
        let read = |text: &str| text.parse::<Runtime>().unwrap();
        assert_eq!(read("version"), Runtime::Version);
        assert_eq!(read("https://host/closedform"), Runtime::Git("https://host/closedform".to_owned()));
        assert_eq!(read("../closedform"), Runtime::Folder("../closedform".into()));
        let out = tempfile::tempdir().unwrap();
        let said =
            |text: &str| read(text).dependency(&RUNTIME, out.path(), Path::new("")).map_err(|error| error.to_string());
        assert_eq!(said("git@host:a.git"), Ok("{ git = \"git@host:a.git\" }".to_owned()));
        assert_eq!(said("version"), Ok(format!("\"{}\"", env!("CARGO_PKG_VERSION"))));
        assert!(said("nowhere").unwrap_err().contains("no runtime at nowhere"));
        assert!(said(&checkout().to_string_lossy()).unwrap().ends_with("runtime\" }"));
    }
}
