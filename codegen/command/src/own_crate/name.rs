//! The name of a package: that of its folder, or what cargo takes that is near.

use std::path::Path;

use super::OwnCrateError;
use closedform_project::contract::{is_device, is_keyword};

/// What cargo takes no package name for, beside keywords: crates of every program, and folders of its own.
const TAKEN_PACKAGES: [&str; 11] = [
    "alloc",
    "build",
    "closedform",
    "core",
    "deps",
    "examples",
    "incremental",
    "proc-macro",
    "proc_macro",
    "std",
    "test",
];

/// The longest name, as registries allow it.
const LONGEST: usize = 64;

/// The name of a package, and what it was made of.
pub(super) struct PackageName {
    pub(super) package: String,
    folder: String,
}

impl PackageName {
    /// What to say where the package is not called as its folder.
    pub(super) fn note(&self) -> Option<String> {
        let Self { package, folder } = self;
        (package != folder).then(|| format!("the package is called `{package}`, because `{folder}` is no name for one"))
    }
}

/// The name of the package in a folder that exists.
pub(super) fn package(folder: &Path) -> Result<PackageName, OwnCrateError> {
    let whole = folder.canonicalize().map_err(|cause| OwnCrateError::write(folder, cause))?;
    let folder = whole.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(PackageName { package: package_of(&folder), folder })
}

/// The name itself if cargo takes it; else what is left of it in small letters, digits and dashes, made free.
fn package_of(folder: &str) -> String {
    if is_package(folder) {
        return folder.to_owned();
    }
    let small = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c.to_ascii_lowercase() } else { '-' };
    let mapped: String = folder.chars().map(small).collect();
    let words: Vec<&str> = mapped.split('-').filter(|word| !word.trim_matches('_').is_empty()).collect();
    let mut name: String = words.join("-").chars().take(LONGEST - "kernels-".len()).collect();
    name.truncate(name.trim_end_matches(['-', '_']).len());
    match name.as_str() {
        "" => "kernels".to_owned(),
        name if is_package(name) => name.to_owned(),
        name if name.starts_with(|c: char| c.is_ascii_lowercase()) => format!("{name}-kernels"),
        name => format!("kernels-{}", name.trim_start_matches('_')),
    }
}

fn is_package(name: &str) -> bool {
    let letters = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    let module = name.replace('-', "_");
    letters
        && name.len() <= LONGEST
        && name.starts_with(|c: char| c.is_ascii_alphabetic())
        && !TAKEN_PACKAGES.contains(&name)
        && !is_keyword(&module.to_ascii_lowercase())
        && !is_device(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_gives_its_package_the_name() {
        for name in ["mine", "my-kernels", "my_kernels", "Optics", "a1"] {
            assert_eq!(package_of(name), name);
        }
        let pairs = [
            ("my kernels", "my-kernels"),
            ("a-b.c", "a-b-c"),
            ("1digit", "kernels-1digit"),
            ("core", "core-kernels"),
            ("closedform", "closedform-kernels"),
            ("build", "build-kernels"),
            ("fn", "fn-kernels"),
            ("Self", "self-kernels"),
            ("proc-macro", "proc-macro-kernels"),
            ("CON", "con-kernels"),
            ("com1", "com1-kernels"),
            ("\u{dc}n\u{ef}", "n"),
            ("\u{65e5}\u{672c}", "kernels"),
            ("_", "kernels"),
            ("-x-", "x"),
        ];
        for (folder, package) in pairs {
            assert_eq!(package_of(folder), package, "{folder}");
            assert!(is_package(package), "{package}");
        }
        let long = package_of(&"long name ".repeat(100));
        assert!(is_package(&long), "{long}");
        assert!(is_package(&package_of(&"1".repeat(100))));
    }
}
