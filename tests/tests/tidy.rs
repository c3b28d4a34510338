//! Every file says its job, nothing is left over, and families come in full sets.

use std::collections::BTreeSet;
use std::fs;

use closedform_tests::workspace::{self, Source};
use closedform_tests::{tidy, worksheets};

#[track_caller]
fn none(complaints: Vec<String>) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn files_are_tidy() {
    none(workspace::files().iter().flat_map(tidy::complaints).collect());
}

#[test]
fn generated_files_say_what_made_them() {
    let files = workspace::files();
    let marked: BTreeSet<&str> = workspace::generated(&files).iter().map(|file| file.path.as_str()).collect();
    assert!(!marked.is_empty(), ".gitattributes marks nothing as linguist-generated");
    let complain = |file: &Source| match (marked.contains(file.path.as_str()), tidy::says_its_origin(&file.text)) {
        (true, false) => Some(format!("{}: line one does not say what made it", file.path)),
        (false, true) => Some(format!("{}: mark it as linguist-generated in .gitattributes", file.path)),
        _ => None,
    };
    none(files.iter().filter_map(complain).collect());
}

/// Programs are nobody's dependency, and tests are not published.
#[test]
fn errors_of_libraries_may_grow() {
    let programs = ["codegen/command/", "codegen/symbolica/", "motion/src/bin/", "tests/", "fuzz/"];
    let of_library = |file: &&Source| {
        let source = file.path.ends_with(".rs") && file.path.contains("/src/");
        source && !programs.iter().any(|program| file.path.starts_with(program))
    };
    none(workspace::files().iter().filter(of_library).flat_map(tidy::closed_errors).collect());
    let closed = Source { path: "a.rs".into(), text: "#[derive(Debug, Error)]\npub enum Failure {\n}\n".into() };
    assert_eq!(tidy::closed_errors(&closed).len(), 1);
}

#[test]
fn no_crate_can_be_unsafe() {
    let lints = &workspace::manifest(".")["workspace"]["lints"]["rust"];
    assert_eq!(lints["unsafe_code"].as_str(), Some("forbid"));
    for member in workspace::members() {
        let lints = &workspace::manifest(&member)["lints"];
        assert_eq!(lints["workspace"].as_bool(), Some(true), "{member}/Cargo.toml: `lints.workspace = true`");
    }
}

#[test]
fn families_come_in_full_sets() {
    let extensions = ["mac", "toml", "ref", "tsv"];
    let families: BTreeSet<String> = extensions.iter().flat_map(|extension| worksheets::families(extension)).collect();
    assert!(!families.is_empty(), "no families");
    let sheets = |family: &String| extensions.map(|extension| format!("maxima-ref/{family}.{extension}"));
    let kernels = |family: &String| [format!("kernels/src/generated/{family}.rs")];
    let paths = families.iter().flat_map(|family| sheets(family).into_iter().chain(kernels(family)));
    none(paths.filter(|path| !workspace::root().join(path).is_file()).map(|path| format!("no file {path}")).collect());
}

#[test]
fn the_table_names_every_family() {
    let path = "book/src/kernels.md";
    let page = fs::read_to_string(workspace::root().join(path)).expect("the page can be read");
    let families = worksheets::families("toml").into_iter();
    none(
        families
            .filter(|name| !page.contains(&format!("`{name}::")))
            .map(|name| format!("{path} does not name `{name}`"))
            .collect(),
    );
}

/// The rest of a recipe of a makefile, up to the next blank line.
fn recipe(makefile: &str, target: &str) -> String {
    let text = fs::read_to_string(workspace::root().join(makefile)).expect("the makefile can be read");
    let mut lines = text.lines().skip_while(|line| !line.starts_with(target));
    assert!(lines.next().is_some(), "{makefile} has no {target}");
    lines.take_while(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

#[test]
fn the_tools_of_an_example_are_installed_as_those_of_the_project() {
    assert_eq!(recipe("codegen/command/example/Makefile", "tools:"), recipe("Makefile", "tools:"));
}
