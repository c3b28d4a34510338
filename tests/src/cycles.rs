//! Import cycles: which files of a crate name each other in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::iter::{Copied, Peekable};
use std::slice;

use crate::workspace::Source;

/// How many names may stand for another name in a row.
const ALIASES: usize = 16;

/// A path as it is written, with the name that it goes by; a glob has none.
type Import = (Vec<String>, Option<String>);

/// The modules of a crate that are files, by their paths from its root.
type Modules = BTreeMap<Vec<String>, Module>;

/// The rest of a file's tokens.
type Rest<'t> = Peekable<Copied<slice::Iter<'t, &'t str>>>;

/// A file of a crate.
struct Module {
    file: String,
    imports: Vec<Import>,
    mentions: Vec<Vec<String>>,
}

/// The largest groups of files of the crate in `folder`, which ends in `/`, each of which names all others, if by others.
pub fn cycles(files: &[Source], folder: &str) -> Vec<BTreeSet<String>> {
    let modules = modules(files, folder);
    let edges: BTreeMap<&str, BTreeSet<&str>> =
        modules.iter().map(|(path, module)| (module.file.as_str(), named_by(&modules, path))).collect();
    let reached: BTreeMap<&str, BTreeSet<&str>> = edges.keys().map(|&file| (file, reachable(&edges, file))).collect();
    let circle = |file: &str| -> BTreeSet<String> {
        let back = reached[file].iter().filter(|other| reached[*other].contains(file));
        back.map(|other| (*other).to_owned()).collect()
    };
    let circles: BTreeSet<BTreeSet<String>> = edges.keys().map(|file| circle(file)).collect();
    circles.into_iter().filter(|circle| circle.len() > 1).collect()
}

fn reachable<'m>(edges: &BTreeMap<&'m str, BTreeSet<&'m str>>, from: &str) -> BTreeSet<&'m str> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&str> = edges[from].iter().copied().collect();
    while let Some(file) = open.pop() {
        if found.insert(file) {
            open.extend(&edges[file]);
        }
    }
    found
}

/// The folders, ending in `/`, in which crates and programs have their roots.
pub fn roots(files: &[Source]) -> BTreeSet<&str> {
    let split =
        files.iter().filter_map(|file| file.path.rsplit_once('/').map(|(folder, name)| (file, folder.len(), name)));
    let roots = split.filter(|(file, _, name)| file.path.contains("src/") && ["lib.rs", "main.rs"].contains(name));
    roots.map(|(file, end, _)| &file.path[..=end]).collect()
}

fn modules(files: &[Source], folder: &str) -> Modules {
    let others: Vec<&str> = roots(files).into_iter().filter(|root| root.len() > folder.len()).collect();
    let mut modules = Modules::new();
    for file in files.iter().filter(|file| !others.iter().any(|root| file.path.starts_with(root))) {
        if let Some(path) = file.path.strip_prefix(folder).and_then(|path| path.strip_suffix(".rs")) {
            // a program beside a library is one file, which names the library as others do
            modules.entry(module_path(path)).or_insert_with(|| Module::read(file));
        }
    }
    modules
}

fn module_path(path: &str) -> Vec<String> {
    let mut names: Vec<String> = path.split('/').map(str::to_owned).collect();
    if matches!(names.last().map(String::as_str), Some("mod" | "lib" | "main")) {
        names.pop();
    }
    names
}

/// The other files that a module names.
fn named_by<'m>(modules: &'m Modules, at: &[String]) -> BTreeSet<&'m str> {
    let Module { file, imports, mentions } = &modules[at];
    let paths = imports.iter().map(|(path, _)| path).chain(mentions);
    let named =
        paths.filter_map(|path| resolved(modules, at, path, ALIASES)).map(|module| modules[&module].file.as_str());
    named.filter(|named| named != file).collect()
}

/// The module in which stands what a path names; `None` if that is outside of the crate.
fn resolved(modules: &Modules, at: &[String], path: &[String], aliases: usize) -> Option<Vec<String>> {
    let mut place = at.to_vec();
    for (position, name) in path.iter().enumerate() {
        match name.as_str() {
            "crate" => place.clear(),
            "self" => {}
            "super" => _ = place.pop(),
            _ => {
                place.push(name.clone());
                if modules.contains_key(&place) {
                    continue;
                }
                place.pop();
                let alias = modules.get(&place)?.imports.iter().find(|(_, known)| known.as_ref() == Some(name));
                return match alias {
                    Some((target, _)) if aliases > 0 && target != path => {
                        let longer = [target, &path[position + 1..]].concat();
                        resolved(modules, &place, &longer, aliases - 1)
                    }
                    // the first name of a path is a crate, unless it is known here
                    _ => (position > 0).then_some(place),
                };
            }
        }
    }
    modules.contains_key(&place).then_some(place)
}

impl Module {
    fn read(file: &Source) -> Self {
        let tokens = tokens(&file.text);
        let (mut imports, mut mentions) = (Vec::new(), Vec::new());
        let mut rest: Rest = tokens.iter().copied().peekable();
        while let Some(token) = rest.next() {
            if token == "use" {
                use_tree(&mut rest, &[], &mut imports);
            } else if token == "$" {
                // `$crate` names what a macro means where it is called
                _ = rest.next().map(|name| path(name, &mut rest));
            } else if is_name(token) {
                mentions.push(path(token, &mut rest));
            }
        }
        mentions.retain(|path| path.len() > 1);
        Self { file: file.path.clone(), imports, mentions }
    }
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// A name and those that follow it behind `::`.
fn path(first: &str, rest: &mut Rest) -> Vec<String> {
    let mut names = vec![first.to_owned()];
    while rest.next_if_eq(&"::").is_some() {
        names.extend(rest.next_if(|token| is_name(token)).map(str::to_owned));
    }
    names
}

/// Reads one tree of a `use`, behind the names that it begins with.
fn use_tree(rest: &mut Rest, prefix: &[String], imports: &mut Vec<Import>) {
    let mut names = prefix.to_vec();
    while let Some(token) = rest.next_if(|token| is_name(token) && *token != "as" || *token == "::") {
        names.extend(is_name(token).then(|| token.to_owned()));
    }
    if rest.next_if_eq(&"{").is_some() {
        while rest.next_if_eq(&"}").is_none() && rest.peek().is_some() {
            use_tree(rest, &names, imports);
            rest.next_if_eq(&",");
        }
        return;
    }
    if rest.next_if_eq(&"*").is_some() {
        return imports.push((names, None));
    }
    if names.last().is_some_and(|name| name == "self") {
        names.pop();
    }
    let alias = rest.next_if_eq(&"as").and_then(|_| rest.next());
    let name = alias.map(str::to_owned).or_else(|| names.last().cloned());
    imports.push((names, name));
}

/// The names, `::` and other signs of a file, without comments, texts and what only its tests see.
fn tokens(text: &str) -> Vec<&str> {
    let code = text.split("\nmod tests {").next().unwrap_or_default();
    let mut tokens = Vec::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let length = token_length(rest, first);
        let token = &rest[..length];
        if is_name(token) || !(first.is_whitespace() || first == '"' || first == '\'' || token.starts_with("//")) {
            tokens.push(token);
        }
        rest = &rest[length..];
    }
    tokens
}

fn token_length(text: &str, first: char) -> usize {
    let up_to = |end: Option<usize>| end.unwrap_or(text.len());
    if text.starts_with("//") {
        up_to(text.find('\n'))
    } else if text.starts_with("r#\"") {
        up_to(text.find("\"#").map(|end| end + 2))
    } else if first == '"' {
        up_to(text_end(text))
    } else if let Some(length) =
        ["'\"'", "'\\''", "'\\\\'", "'\\\"'"].iter().find(|c| text.starts_with(**c)).map(|c| c.len())
    {
        length
    } else if is_name(&text[..first.len_utf8()]) {
        up_to(text.find(|c: char| !c.is_alphanumeric() && c != '_'))
    } else if text.starts_with("::") {
        2
    } else {
        first.len_utf8()
    }
}

/// Where a text in quotation marks ends.
fn text_end(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.char_indices().skip(1).find_map(|(at, c)| {
        let ends = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        ends.then_some(at + 1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        let source = |(path, text): &(&str, &str)| Source { path: format!("a/src/{path}"), text: (*text).to_owned() };
        let files: Vec<Source> = files.iter().map(source).collect();
        cycles(&files, "a/src/").into_iter().map(|circle| circle.into_iter().collect()).collect()
    }

    #[test]
    fn roots_are_the_folders_of_libraries_and_programs() {
        let paths = ["a/src/lib.rs", "a/src/main.rs", "a/src/domain.rs", "a/src/bin/b/main.rs", "a/tests/main.rs"];
        let files = paths.map(|path| Source { path: path.to_owned(), text: String::new() });
        assert_eq!(Vec::from_iter(roots(&files)), ["a/src/", "a/src/bin/b/"]);
    }

    #[test]
    fn files_that_import_each_other_are_found() {
        let files =
            [("lib.rs", "mod b; mod c;"), ("b.rs", "use super::c::C;"), ("c.rs", "use crate::{d::D, b::{self, B}};")];
        assert_eq!(found(&files), [["a/src/b.rs", "a/src/c.rs"]]);
    }

    #[test]
    fn paths_in_code_count_and_those_in_comments_texts_and_tests_do_not() {
        let there = ("b.rs", "fn f() { super::c::g() }");
        let back = |text| found(&[("lib.rs", ""), there, ("c.rs", text)]).len();
        assert_eq!(back("fn g() { crate::b::f() }"), 1);
        assert_eq!(back("macro_rules! m { () => { $crate::b::f() }; }"), 0);
        assert_eq!(back("// crate::b::f()\nfn g() -> &str { \"\\\"crate::b::f()\" }\n"), 0);
        assert_eq!(back("fn g() {}\n#[cfg(test)]\nmod tests {\n    use crate::b::f;\n}\n"), 0);
    }

    #[test]
    fn a_module_that_hands_on_what_its_parts_have_is_not_meant_itself() {
        let parts = [("m/b.rs", "use super::C;"), ("m/c.rs", "pub struct C;")];
        let file = |text| found(&[("lib.rs", ""), ("m/mod.rs", text), parts[0], parts[1]]);
        assert!(file("mod b; mod c; pub use b::B; pub use c::{C as D, C};").is_empty());
        assert_eq!(file("mod b; pub use b::B; pub struct C;"), [["a/src/m/b.rs", "a/src/m/mod.rs"]]);
    }
}
