//! The invariants of absence: who names whom, and who must not.

use std::collections::BTreeSet;
use std::process::Command;

use closedform_tests::cycles::{cycles, roots};
use closedform_tests::layering::{self, Edge};
use closedform_tests::workspace::{self, Source};

/// What crates may depend on, among those of the workspace.
const CRATES: [(&str, &str); 58] = [
    ("closedform", "closedform-arith"),
    ("closedform", "closedform-derive"),
    ("closedform-bind", "closedform-measure"),
    ("closedform-bind", "closedform-project"),
    ("closedform-bind", "closedform-syntax"),
    ("closedform-bind", "closedform-system"),
    ("closedform-bounds", "closedform-arith"),
    ("closedform-bounds", "closedform-syntax"),
    ("closedform-cli", "closedform"),
    ("closedform-cli", "closedform-bind"),
    ("closedform-cli", "closedform-bounds"),
    ("closedform-cli", "closedform-build"),
    ("closedform-cli", "closedform-errata"),
    ("closedform-cli", "closedform-generator"),
    ("closedform-cli", "closedform-maxima"),
    ("closedform-cli", "closedform-measure"),
    ("closedform-cli", "closedform-mutants"),
    ("closedform-cli", "closedform-project"),
    ("closedform-cli", "closedform-syntax"),
    ("closedform-cli", "closedform-system"),
    ("closedform-derive", "closedform-syntax"),
    ("closedform-errata", "closedform-maxima"),
    ("closedform-errata", "closedform-project"),
    ("closedform-generator", "closedform-arith"),
    ("closedform-generator", "closedform-bounds"),
    ("closedform-generator", "closedform-maxima"),
    ("closedform-generator", "closedform-project"),
    ("closedform-generator", "closedform-syntax"),
    ("closedform-kernels", "closedform"),
    ("closedform-maxima", "closedform-arith"),
    ("closedform-measure", "closedform-arith"),
    ("closedform-measure", "closedform-maxima"),
    ("closedform-measure", "closedform-project"),
    ("closedform-measure", "closedform-syntax"),
    ("closedform-measure", "closedform-system"),
    ("closedform-motion", "closedform"),
    ("closedform-motion", "closedform-kernels"),
    ("closedform-motion", "closedform-player"),
    ("closedform-mutants", "closedform"),
    ("closedform-mutants", "closedform-bounds"),
    ("closedform-mutants", "closedform-measure"),
    ("closedform-mutants", "closedform-project"),
    ("closedform-mutants", "closedform-syntax"),
    ("closedform-project", "closedform-build"),
    ("closedform-project", "closedform-maxima"),
    ("closedform-project", "closedform-syntax"),
    ("closedform-project", "closedform-system"),
    ("closedform-symbolica", "closedform-arith"),
    ("closedform-symbolica", "closedform-generator"),
    ("closedform-symbolica", "closedform-project"),
    ("closedform-symbolica", "closedform-system"),
    ("closedform-syntax", "closedform-arith"),
    ("closedform-tests", "closedform"),
    ("closedform-tests", "closedform-bounds"),
    ("closedform-tests", "closedform-kernels"),
    ("closedform-tests", "closedform-maxima"),
    ("closedform-tests", "closedform-project"),
    ("closedform-tests", "closedform-syntax"),
];

/// What their tests may depend on besides.
const CRATES_IN_TESTS: [(&str, &str); 12] = [
    ("closedform-bind", "closedform"),
    ("closedform-bind", "closedform-kernels"),
    ("closedform-cli", "closedform-measure"),
    ("closedform-cli", "closedform-project"),
    ("closedform-derive", "closedform"),
    ("closedform-derive", "closedform-arith"),
    ("closedform-errata", "closedform-project"),
    ("closedform-generator", "closedform"),
    ("closedform-mutants", "closedform-measure"),
    ("closedform-symbolica", "closedform"),
    ("closedform-symbolica", "closedform-maxima"),
    ("closedform-symbolica", "closedform-syntax"),
];

/// What the stages of the generator may name of one another: the printer, `rust`, decides nothing.
const STAGES: [(&str, &str); 6] = [
    ("field", "algebra"),
    ("program", "field"),
    ("rust", "program"),
    ("stable", "algebra"),
    ("stable", "field"),
    ("stable", "program"),
];

/// Why files still import each other: functions that call each other over one tree.
const RECURSION: &str = "mutual recursion over one tree";
/// A type stands in the file of those who make it, not below those who use it.
const TYPES: &str = "a type that both need stands with one of them";
/// What the parts of a module share stands in the file that joins them.
const WHOLE: &str = "what parts share stands in the file of the whole";

/// The circles of imports between files that are left: the folder, its files and why. None may be added, and none may grow.
const CIRCLES: [(&str, &[&str], &str); 25] = [
    ("codegen/bounds/src", &["case.rs", "correction.rs", "count.rs", "equal.rs"], RECURSION),
    ("codegen/bounds/src/sign", &["facts.rs", "prove.rs"], RECURSION),
    ("codegen/command/src", &["verify.rs", "verify/search.rs"], WHOLE),
    ("codegen/command/src", &["worker.rs", "worker/attempt.rs"], WHOLE),
    (
        "codegen/errata/src",
        &["contrast.rs", "error.rs", "judge.rs", "problem.rs", "row.rs", "sheet.rs", "shipped.rs"],
        TYPES,
    ),
    ("codegen/errata/src", &["page.rs", "page/worst.rs"], WHOLE),
    ("codegen/maxima/src", &["error.rs", "lex.rs", "parse.rs", "parse/cursor.rs", "parse/expression.rs"], TYPES),
    ("codegen/maxima/src", &["evaluate.rs", "evaluate/stable.rs"], WHOLE),
    ("codegen/maxima/src/evaluate", &["function.rs", "power.rs", "root.rs", "scope.rs"], RECURSION),
    ("codegen/mutants/src", &["equivalent.rs", "exam.rs"], TYPES),
    ("codegen/mutants/src/kind", &["condition.rs", "walk.rs"], RECURSION),
    ("codegen/mutants/src/kind", &["mod.rs", "whole.rs"], WHOLE),
    ("codegen/project/src", &["contract.rs", "contract/check.rs"], WHOLE),
    ("codegen/project/src/worksheet", &["arrays.rs", "evaluate.rs"], RECURSION),
    ("codegen/project/src", &["family.rs", "family/stranger.rs"], WHOLE),
    (
        "codegen/project/src",
        &["maxima_process.rs", "maxima_process/child.rs", "maxima_process/transcript.rs", "maxima_process/watch.rs"],
        WHOLE,
    ),
    ("motion/src/plan/milling", &["mod.rs", "timer.rs"], WHOLE),
    ("motion/src/plan/derived_raster", &["choose.rs", "mod.rs", "quantise.rs", "turn.rs"], WHOLE),
    ("motion/src/plan/waypoints", &["fastest.rs", "four.rs", "input.rs", "mod.rs", "spline.rs"], WHOLE),
    ("motion/src/plot", &["drawing.rs", "file.rs"], TYPES),
    ("motion/src/plot", &["path.rs", "picture.rs"], TYPES),
    ("motion/src/table", &["columns.rs", "csv.rs", "file.rs", "json.rs", "mod.rs", "moves.rs"], WHOLE),
    ("syntax/src", &["file.rs", "lib.rs"], WHOLE),
    ("tests/src", &["check.rs", "failure.rs"], TYPES),
    ("tests/src", &["inputs.rs", "scaling.rs"], TYPES),
];

/// What users of kernels never build.
const HEAVY: [&str; 3] = ["symbolica", "rug", "gmp-mpfr-sys"];

#[test]
fn crates_depend_as_allowed() {
    layering::demand(&layering::internal(layering::dependencies("dependencies")), &CRATES, "CRATES");
}

#[test]
fn tests_of_crates_depend_as_allowed() {
    let kinds = ["dev-dependencies", "build-dependencies"];
    let edges = kinds.iter().flat_map(|kind| layering::dependencies(kind)).collect();
    layering::demand(&layering::internal(edges), &CRATES_IN_TESTS, "CRATES_IN_TESTS");
}

#[test]
fn users_build_no_computer_algebra() {
    for name in ["closedform-kernels", "closedform", "closedform-derive", "closedform-syntax", "closedform-motion"] {
        let built = layering::built_by_users_of(name);
        assert!(built.contains("closedform-arith"), "{name}: nothing is known of what it builds: {built:?}");
        let heavy: Vec<&str> = HEAVY.into_iter().filter(|heavy| built.contains(*heavy)).collect();
        assert!(heavy.is_empty(), "{name} builds {heavy:?}: run `cargo tree -p {name} -i {}`", heavy[0]);
    }
    // The judges do: these names are the right ones.
    let built = layering::built_by_users_of("closedform-tests");
    assert!(HEAVY[1..].iter().all(|heavy| built.contains(*heavy)), "{built:?}");
}

#[test]
fn judges_share_nothing_with_the_generator() {
    let built = layering::built_by_users_of("closedform-tests");
    let generator = ["closedform-generator", HEAVY[0]].into_iter().find(|name| built.contains(*name));
    assert_eq!(generator, None, "closedform-tests depends on it");
}

/// What the judges may name of the project: file formats, hexadecimal floats and random numbers. Domains, references and
/// samples are their own.
const SHARED: [&str; 5] = ["contract::", "golden::", "hexfloat", "kept::", "sample::Random"];

#[test]
fn judges_share_formats_with_the_project_and_no_decisions() {
    let files = workspace::files();
    let mut shared = BTreeSet::new();
    for file in layering::within(&files, "tests/").into_iter().filter(|file| file.path.ends_with(".rs")) {
        for named in layering::named_after(file, "closedform_project::") {
            let known = SHARED.into_iter().find(|shared| named.starts_with(shared));
            shared.insert(known.unwrap_or_else(|| panic!("{} names of the project: {named}", file.path)));
        }
    }
    assert_eq!(shared, BTreeSet::from(SHARED), "strike the others out of SHARED");
}

#[test]
fn one_crate_depends_on_symbolica() {
    let kinds = ["dependencies", "dev-dependencies", "build-dependencies"];
    let edges = kinds.iter().flat_map(|kind| layering::dependencies(kind));
    let users: Vec<String> = edges.filter(|(_, to)| to == HEAVY[0]).map(|(from, _)| from).collect();
    assert_eq!(users, ["closedform-symbolica"]);
}

#[test]
fn commands_build_no_symbolica() {
    for name in ["closedform-cli", "closedform-generator"] {
        let built = layering::built_by_users_of(name);
        assert!(built.contains(HEAVY[1]), "{name}: nothing is known of what it builds: {built:?}");
        assert!(!built.contains(HEAVY[0]), "{name}: run `cargo tree -p {name} -i {}`", HEAVY[0]);
    }
}

#[test]
fn one_file_names_symbolica() {
    let files = workspace::files();
    let others =
        |file: &&Source| Source { path: file.path.clone(), text: file.text.replace("closedform_symbolica", "") };
    let naming = layering::within(&files, "codegen/").into_iter().filter(|file| {
        layering::names(&others(file), "symbolica::") // our crate of that name may be named
    });
    let paths: Vec<&str> = naming.map(|file| file.path.as_str()).collect();
    assert_eq!(paths, ["codegen/symbolica/src/polynomial.rs"]);
}

#[test]
fn stages_name_each_other_as_allowed() {
    let files = workspace::files();
    let stages = ["algebra", "field", "stable", "program", "rust"];
    let edges = |stage: &str| -> Vec<Edge> {
        let named = layering::modules_named(&files, stage).into_iter();
        named.map(|name| (stage.to_owned(), name)).collect()
    };
    let found: BTreeSet<Edge> = stages.into_iter().flat_map(edges).collect();
    layering::demand(&found, &STAGES, "STAGES");
}

#[test]
fn files_of_a_crate_import_each_other_in_no_circle() {
    let files = workspace::files();
    let roots = roots(&files);
    assert!(roots.contains("codegen/generator/src/"), "{roots:?}");
    let circles: Vec<BTreeSet<String>> = roots.iter().flat_map(|root| cycles(&files, root)).collect();
    let known: Vec<BTreeSet<String>> = CIRCLES.iter().map(|(folder, names, _)| paths(folder, names)).collect();
    let new = circles.iter().filter(|circle| !known.iter().any(|known| known.is_superset(circle)));
    let new = new.map(|circle| format!("new circle of imports, undo it: {circle:?}"));
    let old = known.iter().zip(CIRCLES).filter(|(known, _)| !circles.contains(known));
    let old =
        old.map(|(known, (.., why))| format!("no such circle ({why}), or a smaller one, correct CIRCLES: {known:?}"));
    let complaints: Vec<String> = new.chain(old).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

fn paths(folder: &str, names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|name| format!("{folder}/{name}")).collect()
}

/// No file in these folders below `codegen/` names any of `what`.
fn absent(folders: &[&str], what: &[&str]) {
    let files = workspace::files();
    for folder in folders {
        for file in layering::within(&files, &format!("codegen/{folder}/")) {
            let named = what.iter().find(|what| layering::names(file, what));
            assert_eq!(named, None, "{} names it", file.path);
        }
    }
}

/// What cargo builds of dependencies, with their features, for some packages together.
fn built_for(packages: &[&str]) -> BTreeSet<String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["tree", "--offline", "--edges", "normal,build", "--prefix", "none", "--format", "{p} {f}"]);
    packages.iter().for_each(|package| _ = cargo.args(["--package", package]));
    let said = workspace::output(&mut cargo);
    said.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect()
}

#[test]
fn symbolica_is_built_once() {
    // `make run` builds both programs together, `generate` and `make test` the generator alone: with other features of one
    // dependency cargo would build Symbolica, which takes minutes, once more
    let alone = built_for(&["closedform-symbolica"]);
    let together = built_for(&["closedform-symbolica", "closedform-cli"]);
    let only_alone: Vec<&String> = alone.difference(&together).collect();
    assert!(alone.len() > 50 && only_alone.is_empty(), "built once more for the generator alone: {only_alone:?}");
}

/// The most files that may name the cube root, which stands for every function that is added to the table.
const FILES_OF_A_FUNCTION: usize = 12;

#[test]
fn a_function_of_the_table_stands_in_few_files() {
    let files = workspace::files();
    let generated: BTreeSet<&str> = workspace::generated(&files).into_iter().map(|file| file.path.as_str()).collect();
    let is_test = |path: &str| path.contains("tests/") || path.ends_with("tests.rs");
    let source = |path: &str| path.ends_with(".rs") && !is_test(path) && !generated.contains(path);
    let naming = files.iter().filter(|file| source(&file.path));
    let naming = naming.filter(|file| ["cbrt", "Cbrt"].iter().any(|name| layering::names(file, name)));
    let naming: Vec<&str> = naming.map(|file| file.path.as_str()).collect();
    assert!(naming.contains(&"arith/src/function/cbrt.rs") && naming.len() <= FILES_OF_A_FUNCTION, "{naming:?}");
}

#[test]
fn no_float_comes_before_programs() {
    absent(&["project/src/expression", "generator/src/algebra", "generator/src/field"], &["f64", "f32", "_float"]);
}

#[test]
fn no_maxima_text_comes_after_expressions() {
    let stages = ["algebra", "field", "stable", "program", "rust"].map(|stage| format!("generator/src/{stage}"));
    absent(&stages.each_ref().map(String::as_str), &["closedform_maxima"]);
}
