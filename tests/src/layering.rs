//! Who may name whom: crates by their manifests, stages of the generator by their text.

use std::collections::BTreeSet;
use std::process::Command;

use toml::{Table, Value};

use crate::workspace::{self, Source};

/// Something that names something else.
pub type Edge = (String, String);

/// What every crate of the workspace depends on by its tables of this name, such as `dependencies`.
pub fn dependencies(kind: &str) -> BTreeSet<Edge> {
    let inherited = &workspace::manifest(".")["workspace"]["dependencies"];
    let members = workspace::members().into_iter().map(|member| workspace::manifest(&member));
    members.flat_map(|member| dependencies_of(&member, kind, inherited)).collect()
}

fn dependencies_of(manifest: &Table, kind: &str, inherited: &Value) -> BTreeSet<Edge> {
    let name = manifest["package"]["name"].as_str().expect("a name");
    let targets = manifest.get("target").and_then(Value::as_table).into_iter().flat_map(Table::values);
    let tables = manifest.get(kind).into_iter().chain(targets.filter_map(|target| target.get(kind)));
    let entries = tables.filter_map(Value::as_table).flat_map(Table::iter);
    // A dependency may go by another name than its own.
    let own = |entry: &Value| Some(entry.get("package")?.as_str()?.to_owned());
    let dependency = |(key, entry): (&String, &Value)| {
        own(entry).or_else(|| own(inherited.get(key)?)).unwrap_or_else(|| key.clone())
    };
    entries.map(|entry| (name.to_owned(), dependency(entry))).collect()
}

/// The edges that end at a crate of the workspace.
pub fn internal(edges: BTreeSet<Edge>) -> BTreeSet<Edge> {
    let is_own = |name: &str| name == "closedform" || name.starts_with("closedform-");
    edges.into_iter().filter(|(_, to)| is_own(to)).collect()
}

/// Every crate that a user of `name` builds, itself included.
pub fn built_by_users_of(name: &str) -> BTreeSet<String> {
    let arguments = ["tree", "--offline", "--package", name, "--edges", "normal,build", "--prefix", "none"];
    let tree = workspace::output(Command::new(env!("CARGO")).args(arguments));
    tree.lines().filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

/// The files in a folder, which ends in `/`.
pub fn within<'a>(files: &'a [Source], folder: &str) -> Vec<&'a Source> {
    let found: Vec<&Source> = files.iter().filter(|file| file.path.starts_with(folder)).collect();
    assert!(!found.is_empty(), "no files in {folder}");
    found
}

/// The modules of the generator that the files of one of them name by `crate::`.
pub fn modules_named(files: &[Source], module: &str) -> BTreeSet<String> {
    let files = within(files, &format!("codegen/generator/src/{module}/"));
    let named = files.iter().flat_map(|file| code(&file.text)).flat_map(|line| line.split("crate::").skip(1));
    let heads = named.map(|path| path.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default());
    heads.filter(|head| *head != module).map(str::to_owned).collect()
}

/// Whether a file names something outside comments.
pub fn names(file: &Source, what: &str) -> bool {
    code(&file.text).any(|line| line.contains(what))
}

/// What follows each mention of `start` outside comments, to the end of its line.
pub fn named_after<'a>(file: &'a Source, start: &'a str) -> impl Iterator<Item = &'a str> {
    let mentions = code(&file.text).flat_map(move |line| line.split(start).skip(1));
    mentions.filter(|rest| !rest.starts_with('"'))
}

fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| line.split("//").next())
}

/// The differences of what is from what may be, one a line.
///
/// # Panics
///
/// There are any.
pub fn demand(found: &BTreeSet<Edge>, allowed: &[(&str, &str)], list: &str) {
    let allowed: BTreeSet<Edge> = allowed.iter().map(|(from, to)| ((*from).to_owned(), (*to).to_owned())).collect();
    let new = found.difference(&allowed).map(|(from, to)| format!("new edge {from} -> {to}: undo it, or decide it in"));
    let old = allowed.difference(found).map(|(from, to)| format!("no edge {from} -> {to}: strike it out of"));
    let complaints: Vec<String> = new.chain(old).map(|complaint| format!("{complaint} {list}")).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependencies_are_found_in_every_table_by_their_own_name() {
        let inherited: Table = "far = { package = \"closedform-far\" }".parse().expect("a table");
        let text = "package.name = \"a\"\ndependencies.far.workspace = true\ndependencies.b = \"1\"\n\
                    target.'cfg(unix)'.dependencies.c = { package = \"d\", optional = true }\ndev-dependencies.e = \"1\"";
        let found = dependencies_of(&text.parse().expect("a manifest"), "dependencies", &Value::Table(inherited));
        let names: Vec<&str> = found.iter().map(|(_, to)| to.as_str()).collect();
        assert_eq!(names, ["b", "closedform-far", "d"]);
    }

    #[test]
    fn modules_are_found_wherever_they_are_named() {
        let text = "use crate::field::Sign;\nfn f(x: crate::program::Node) {} // crate::rust\n";
        let file = Source { path: "codegen/generator/src/stable/a.rs".to_owned(), text: text.to_owned() };
        let named = modules_named(&[file], "stable");
        assert_eq!(named.into_iter().collect::<Vec<_>>(), ["field", "program"]);
    }

    #[test]
    #[should_panic(expected = "new edge kernels -> codegen")]
    fn a_new_edge_is_named() {
        demand(&BTreeSet::from([("kernels".to_owned(), "codegen".to_owned())]), &[], "this list");
    }
}
