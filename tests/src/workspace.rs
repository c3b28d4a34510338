//! The workspace as text: its files and its manifests.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, str};

use toml::Table;

/// A text file of the workspace.
#[derive(Clone, Debug)]
pub struct Source {
    /// From the root, with `/`.
    pub path: String,
    /// What it says.
    pub text: String,
}

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ is in the workspace").to_owned()
}

/// Every text file that git tracks, or would with the next `git add`.
pub fn files() -> Vec<Source> {
    let listed = git(&["ls-files", "-z", "--cached", "--others", "--exclude-standard", "--deduplicate"]);
    let paths = listed.split('\0').filter(|path| !path.is_empty());
    // Deleted files are still listed; others are not text.
    let read = |path: &str| Some(Source { path: path.to_owned(), text: fs::read_to_string(root().join(path)).ok()? });
    paths.filter_map(read).collect()
}

/// Those of `files` that `.gitattributes` marks as generated.
pub fn generated(files: &[Source]) -> Vec<&Source> {
    let attribute = "linguist-generated";
    let paths = files.iter().map(|file| file.path.as_str());
    let told = git(&["check-attr", attribute, "--"].into_iter().chain(paths).collect::<Vec<_>>());
    let marked: Vec<&str> = told.lines().filter_map(|line| line.strip_suffix(": linguist-generated: set")).collect();
    files.iter().filter(|file| marked.contains(&file.path.as_str())).collect()
}

/// The manifest of the folder `path`.
pub fn manifest(path: &str) -> Table {
    let file = root().join(path).join("Cargo.toml");
    let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    text.parse().unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// The folders of the workspace's crates.
pub fn members() -> Vec<String> {
    let root = manifest(".");
    let members = root["workspace"]["members"].as_array().expect("a list of folders");
    members.iter().map(|member| member.as_str().expect("a folder").to_owned()).collect()
}

/// What a command prints that is run in the workspace.
///
/// # Panics
///
/// It fails.
pub fn output(command: &mut Command) -> String {
    let output = command.current_dir(root()).output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {}\n{complaint}", output.status);
    String::from_utf8(output.stdout).unwrap_or_else(|error| panic!("{command:?}: {error}"))
}

fn git(arguments: &[&str]) -> String {
    output(Command::new("git").args(["-c", "safe.directory=*"]).args(arguments))
}
