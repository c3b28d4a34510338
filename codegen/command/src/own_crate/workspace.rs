//! The cargo workspace around a folder, and whether the folder is one of its members.

use std::fs;
use std::path::{Path, PathBuf};

/// A workspace around a new crate.
pub(super) struct Enclosing {
    root: PathBuf,
    /// Whether the crate belongs to it.
    pub(super) is_member: bool,
}

impl Enclosing {
    /// What to say of a crate that stands in the folder of a workspace that does not name it.
    pub(super) fn note(&self) -> Option<String> {
        (!self.is_member).then(|| {
            format!(
                "the workspace {} does not name this folder among its members, so the crate is a workspace of its own; \
                 to make it a member, add it there and strike `[workspace]` out of its Cargo.toml",
                self.root.join("Cargo.toml").display()
            )
        })
    }
}

/// The nearest workspace around a folder that exists, if it does not exclude it.
pub(super) fn enclosing(folder: &Path) -> Option<Enclosing> {
    let folder = folder.canonicalize().ok()?;
    let (root, workspace) = folder.ancestors().skip(1).find_map(|above| Some((above, workspace_of(above)?)))?;
    let below = folder.strip_prefix(root).ok()?;
    let lists = |key: &str, matches: fn(&str, &Path) -> bool| {
        let patterns = workspace.get(key).and_then(toml::Value::as_array).into_iter().flatten();
        patterns.filter_map(toml::Value::as_str).any(|pattern| matches(pattern, below))
    };
    let named = |pattern: &str, below: &Path| below.starts_with(pattern.trim_start_matches("./"));
    // as cargo has it: `exclude` goes before patterns, but not before a folder that is named
    let excluded = lists("exclude", named) && !lists("members", named);
    (!excluded).then(|| Enclosing { root: root.to_owned(), is_member: lists("members", is_matched) })
}

fn workspace_of(folder: &Path) -> Option<toml::Table> {
    let manifest: toml::Table = fs::read_to_string(folder.join("Cargo.toml")).ok()?.parse().ok()?;
    manifest.get("workspace")?.as_table().cloned()
}

/// Whether a pattern such as `crates/*` is matched by a path below the workspace.
fn is_matched(pattern: &str, below: &Path) -> bool {
    let pattern: Vec<&str> = pattern.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    let below: Vec<String> = below.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    parts_match(&pattern, &below)
}

fn parts_match(pattern: &[&str], parts: &[String]) -> bool {
    match (pattern, parts) {
        ([], []) => true,
        (["**", more @ ..], _) => (0..=parts.len()).any(|skipped| parts_match(more, &parts[skipped..])),
        ([first, pattern @ ..], [part, parts @ ..]) => letters_match(first, part) && parts_match(pattern, parts),
        _ => false,
    }
}

fn letters_match(pattern: &str, text: &str) -> bool {
    let mut letters = pattern.chars();
    match letters.next() {
        None => text.is_empty(),
        Some('*') => {
            let ends = text.char_indices().map(|(at, _)| at).chain([text.len()]);
            ends.into_iter().any(|at| letters_match(letters.as_str(), &text[at..]))
        }
        Some(wanted) => {
            let mut rest = text.chars();
            rest.next().is_some_and(|letter| wanted == '?' || wanted == letter)
                && letters_match(letters.as_str(), rest.as_str())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_are_matched_part_by_part() {
        let matched = |pattern: &str, below: &str| is_matched(pattern, Path::new(below));
        assert!(matched("crates/*", "crates/mine") && matched("./mine", "mine") && matched("mine/", "mine"));
        assert!(matched("crates/m?ne", "crates/mine") && matched("**/mine", "a/b/mine") && matched("*-k", "my-k"));
        assert!(
            !matched("crates/*", "crates/a/mine") && !matched("crates/*", "mine") && !matched("crates", "crates/a")
        );
    }

    #[test]
    fn a_workspace_knows_its_members() {
        let folder = tempfile::tempdir().unwrap();
        let new = |path: &str| {
            fs::create_dir_all(folder.path().join(path)).unwrap();
            enclosing(&folder.path().join(path)).map(|enclosing| enclosing.is_member)
        };
        assert_eq!(new("a"), None);
        let manifest = "[workspace]\nmembers = [\"crates/*\", \"one\"]\nexclude = [\"crates/not\", \"vendor\"]\n";
        fs::write(folder.path().join("Cargo.toml"), manifest).unwrap();
        assert_eq!((new("crates/mine"), new("one"), new("two")), (Some(true), Some(true), Some(false)));
        assert_eq!((new("vendor/mine"), new("crates/not")), (None, None));
    }
}
