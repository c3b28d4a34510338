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

/// Hidden names that belong to the project; all others belong to tools.
const SHOWN: [&str; 4] = [".ci", ".gitattributes", ".github", ".gitignore"];

/// Every text file of the workspace, in order of their paths; git is not asked, because an archive has no repository.
pub fn files() -> Vec<Source> {
    files_below(&root())
}

fn files_below(root: &Path) -> Vec<Source> {
    let mut paths = Vec::new();
    collect(root, &mut paths);
    paths.sort();
    let from_root = |path: &Path| path.strip_prefix(root).expect("below the root").to_str().map(str::to_owned);
    // What is no text cannot be read as one.
    let read = |path: PathBuf| Some(Source { path: from_root(&path)?, text: fs::read_to_string(path).ok()? });
    paths.into_iter().filter_map(read).collect()
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries {
        let path = entry.unwrap_or_else(|error| panic!("{}: {error}", folder.display())).path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if name.starts_with('.') && !SHOWN.contains(&name) || is_built(&path) {
            continue;
        }
        if path.is_dir() { collect(&path, paths) } else { paths.push(path) }
    }
}

/// Whether cargo builds there: by default, or by the tag with which it marks other folders.
fn is_built(path: &Path) -> bool {
    path.is_dir() && (path.ends_with("target") || path.join("CACHEDIR.TAG").is_file())
}

/// Those of `files` that `.gitattributes` marks as generated.
pub fn generated(files: &[Source]) -> Vec<&Source> {
    let attributes = fs::read_to_string(root().join(".gitattributes")).expect(".gitattributes can be read");
    let marked = |line: &str| line.strip_suffix(" linguist-generated").map(str::to_owned);
    let patterns: Vec<String> = attributes.lines().filter_map(marked).collect();
    files.iter().filter(|file| patterns.iter().any(|pattern| matches(pattern, &file.path))).collect()
}

/// Whether a pattern of `.gitattributes` names a path: `*END`, `FOLDER/**` or the path itself.
fn matches(pattern: &str, path: &str) -> bool {
    let (start, end) = match (pattern.strip_prefix('*'), pattern.strip_suffix("/**")) {
        (Some(end), _) => ("", end),
        (_, Some(folder)) => (folder, ""),
        _ => return pattern == path,
    };
    assert!(!start.contains('*') && !end.contains(['*', '/']), ".gitattributes: teach this function `{pattern}`");
    path.ends_with(end) && path.strip_prefix(start).is_some_and(|rest| start.is_empty() || rest.starts_with('/'))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_found_without_git_but_not_what_tools_make() {
        let temporary = tempfile::tempdir().expect("a folder");
        let folder = temporary.path().join("walked");
        let kept = [".ci/run", ".gitignore", "a/b.rs", "a/src/target.rs", "z"];
        let left = [".git/config", ".editor/a", "a/.a.rs.swp", "a/target/a.rs", "other/a.rs", "other/CACHEDIR.TAG"];
        for path in kept.iter().chain(&left) {
            let path = folder.join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
            fs::write(path, "text").expect("a file");
        }
        fs::write(folder.join("picture"), [0xff]).expect("a file");
        let found = files_below(&folder);
        assert_eq!(found.iter().map(|file| file.path.as_str()).collect::<Vec<_>>(), kept);
    }

    #[test]
    fn patterns_of_attributes_name_endings_folders_and_files() {
        assert!(matches("*.ref", "maxima-ref/pvt.ref") && !matches("*.ref", "pvt.refs"));
        assert!(matches("a/b/**", "a/b/c/d") && !matches("a/b/**", "a/bc/d"));
        assert!(matches("a/b", "a/b") && !matches("a/b", "a/b/c"));
    }
}
