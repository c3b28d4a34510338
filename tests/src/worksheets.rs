//! The folder of worksheets and what is read from it.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of worksheets, contracts, references and golden values.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../maxima-ref")
}

/// Names of all files there that end in `.extension`, without that ending, sorted.
pub fn families(extension: &str) -> Vec<String> {
    families_in("", extension)
}

/// Those of a folder in it.
pub fn families_in(below: &str, extension: &str) -> Vec<String> {
    let files = fs::read_dir(folder().join(below)).expect("maxima-ref/ can be listed");
    let paths = files.map(|file| file.expect("maxima-ref/ can be listed").path());
    let of_kind = paths.filter(|path| path.extension().is_some_and(|found| found == extension));
    let mut names: Vec<String> = of_kind.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
    names.sort();
    names
}

/// Where `FAMILY.extension` is.
pub fn path(family: &str, extension: &str) -> PathBuf {
    folder().join(format!("{family}.{extension}"))
}

/// The text of `FAMILY.extension`.
pub fn read(family: &str, extension: &str) -> String {
    let path = path(family, extension);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}; run `closedform derive`", path.display()))
}
