//! Links of Markdown documents: where they lead, and whether anything is there.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use crate::workspace::Source;

/// What stands before the target of a link, and what ends it.
const LINKS: [(&str, char); 3] = [("](", ')'), ("src=\"", '"'), ("srcset=\"", '"')];

/// The links of a document that lead nowhere, one line each. `exists` says whether there is a file or folder, `read` gives
/// the text of a document.
pub fn complaints(
    document: &Source,
    exists: impl Fn(&Path) -> bool,
    read: impl Fn(&Path) -> Option<String>,
) -> Vec<String> {
    let folder = Path::new(&document.path).parent().unwrap_or(Path::new(""));
    let leads_nowhere = |target: &&String| {
        let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
        let path = if file.is_empty() { PathBuf::from(&document.path) } else { normal(&folder.join(file)) };
        let has_anchor = |text: String| anchors(&text).contains(anchor);
        !exists(&path) || !anchor.is_empty() && !read(&path).is_some_and(has_anchor)
    };
    let targets = targets(&document.text);
    let broken = targets.iter().filter(|target| !target.contains("://")).filter(leads_nowhere);
    broken.map(|target| format!("{}: the link `{target}` leads nowhere", document.path)).collect()
}

/// What the links of a text lead to, outside code.
pub fn targets(text: &str) -> Vec<String> {
    let text = without_code(text);
    let text = text.as_str();
    let after = |(start, end): (&'static str, char)| {
        let links = text.match_indices(start).map(move |(at, _)| &text[at + start.len()..]);
        links.filter_map(move |rest| Some(rest.split_once(end)?.0.to_owned())).collect::<Vec<_>>()
    };
    LINKS.into_iter().flat_map(after).collect()
}

/// The anchors of the headings of a text, as forges make them.
fn anchors(text: &str) -> BTreeSet<String> {
    let outside = blocks(text).step_by(2).flat_map(str::lines);
    let heading = |line: &str| Some(line.strip_prefix('#')?.trim_start_matches('#').strip_prefix(' ')?.to_lowercase());
    let kept = |letter: &char| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter);
    let anchor = |title: String| title.trim().chars().filter(kept).collect::<String>().replace(' ', "-");
    outside.filter_map(heading).map(anchor).collect()
}

/// The text between fences of code, and every second time that within them.
fn blocks(text: &str) -> impl Iterator<Item = &str> {
    text.split("```")
}

/// The text without its code, in blocks and in lines.
fn without_code(text: &str) -> String {
    let outside: String = blocks(text).step_by(2).collect();
    outside.split('`').step_by(2).collect()
}

/// A path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => _ = normal.pop(),
            Component::CurDir => {}
            other => normal.push(other),
        }
    }
    normal
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complain(text: &str) -> usize {
        let document = Source { path: "book/a.md".to_owned(), text: text.to_owned() };
        let exists = |path: &Path| ["b.md", "book/a.md", "book/c"].iter().any(|known| path == Path::new(known));
        complaints(&document, exists, |path| (path == Path::new("b.md")).then(|| "# Its `x` part\n".to_owned())).len()
    }

    #[test]
    fn links_that_lead_nowhere_are_found() {
        assert_eq!(complain("[a](a.md) [b](../b.md) [c](c) [d](https://example.org)"), 0);
        assert_eq!(complain("[d](d.md) [b](b.md) <img src=\"d.svg\"> <source srcset=\"d.svg\">"), 4);
        assert_eq!(complain("`[d](d.md)` and\n```text\n[d](d.md)\n```\n"), 0);
    }

    #[test]
    fn anchors_are_those_of_headings() {
        assert_eq!(complain("[b](../b.md#its-x-part)"), 0);
        assert_eq!(complain("[b](../b.md#its-part) [c](c#part) [here](#part)"), 3);
    }
}
