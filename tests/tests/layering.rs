//! The invariants of absence: who names whom, and who must not.

use std::collections::BTreeSet;

use closedform_tests::layering::{self, Edge};
use closedform_tests::workspace;

/// What crates may depend on, among those of the workspace.
const CRATES: [(&str, &str); 15] = [
    ("closedform", "closedform-derive"),
    ("closedform-bounds", "closedform-syntax"),
    ("closedform-codegen", "closedform"),
    ("closedform-codegen", "closedform-bounds"),
    ("closedform-codegen", "closedform-maxima"),
    ("closedform-codegen", "closedform-syntax"),
    ("closedform-derive", "closedform-syntax"),
    ("closedform-kernels", "closedform"),
    ("closedform-motion", "closedform"),
    ("closedform-motion", "closedform-kernels"),
    ("closedform-tests", "closedform"),
    ("closedform-tests", "closedform-bounds"),
    ("closedform-tests", "closedform-kernels"),
    ("closedform-tests", "closedform-maxima"),
    ("closedform-tests", "closedform-syntax"),
];

/// What their tests may depend on besides.
const CRATES_IN_TESTS: [(&str, &str); 1] = [("closedform-derive", "closedform")];

/// What the stages of the generator may name of one another: the printer, `rust`, decides nothing.
const STAGES: [(&str, &str); 15] = [
    ("field", "algebra"),
    ("field", "expression"),
    ("mutate", "bound_proof"),
    ("mutate", "catalogue"),
    ("mutate", "kept"),
    ("mutate", "measure"),
    ("mutate", "worksheet"),
    ("program", "field"),
    ("rust", "markdown"),
    ("rust", "program"),
    ("stable", "algebra"),
    ("stable", "field"),
    ("stable", "program"),
    ("verdict", "drawn"), // its tests: errors as people see them
    ("verdict", "worksheet"),
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
    for name in ["closedform-kernels", "closedform", "closedform-derive", "closedform-motion"] {
        let built = layering::built_by_users_of(name);
        assert!(built.contains("closedform-syntax"), "{name}: nothing is known of what it builds: {built:?}");
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
    let generator = ["closedform-codegen", HEAVY[0]].into_iter().find(|name| built.contains(*name));
    assert_eq!(generator, None, "closedform-tests depends on it");
}

#[test]
fn only_the_generator_depends_on_symbolica() {
    let kinds = ["dependencies", "dev-dependencies", "build-dependencies"];
    let edges = kinds.iter().flat_map(|kind| layering::dependencies(kind));
    let users: Vec<String> = edges.filter(|(_, to)| to == HEAVY[0]).map(|(from, _)| from).collect();
    assert_eq!(users, ["closedform-codegen"]);
}

#[test]
fn only_algebra_names_symbolica() {
    let files = workspace::files();
    let naming = layering::within(&files, "codegen/").into_iter().filter(|file| layering::names(file, "symbolica::"));
    let (inside, outside): (Vec<&str>, Vec<&str>) =
        naming.map(|file| file.path.as_str()).partition(|path| path.starts_with("codegen/src/algebra/"));
    assert_eq!(outside, [""; 0]);
    assert_ne!(inside, [""; 0], "this test looks for another name");
}

#[test]
fn stages_name_each_other_as_allowed() {
    let files = workspace::files();
    let stages = ["expression", "algebra", "field", "stable", "program", "rust", "verdict", "mutate"];
    let edges = |stage: &str| -> Vec<Edge> {
        let named = layering::modules_named(&files, stage).into_iter();
        named.map(|name| (stage.to_owned(), name)).collect()
    };
    let found: BTreeSet<Edge> = stages.into_iter().flat_map(edges).collect();
    layering::demand(&found, &STAGES, "STAGES");
}

/// No file in these folders of the generator names any of `what`.
fn absent(folders: &[&str], what: &[&str]) {
    let files = workspace::files();
    for folder in folders {
        for file in layering::within(&files, &format!("codegen/src/{folder}/")) {
            let named = what.iter().find(|what| layering::names(file, what));
            assert_eq!(named, None, "{} names it", file.path);
        }
    }
}

#[test]
fn no_float_comes_before_programs() {
    absent(&["expression", "algebra", "field"], &["f64", "f32", "_float"]);
}

#[test]
fn no_maxima_text_comes_after_expressions() {
    absent(&["algebra", "field", "stable", "program", "rust"], &["closedform_maxima"]);
}
