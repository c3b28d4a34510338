//! Errors as the parser returns them; how the compiler shows each is kept in `derive/tests/ui`.

#[allow(dead_code, missing_docs)]
#[path = "../src/error.rs"]
mod error;

use closedform_syntax::{Kernel, certified, parse_file};
use std::path::{Path, PathBuf};

/// The sources that each cause one message.
fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../derive/tests/ui");
    let files = folder.read_dir().expect("the folder of the macro's cases").map(|file| file.expect("readable").path());
    files.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect()
}

/// What the macro accepts.
fn certified_kernels(source: &str) -> syn::Result<Vec<Kernel>> {
    let kernels = parse_file(source)?;
    kernels.iter().try_for_each(certified)?;
    Ok(kernels)
}

fn messages(source: &str) -> Vec<String> {
    let error = certified_kernels(source).expect_err(source);
    error.into_iter().map(|error| error.to_string()).collect()
}

#[test]
fn a_source_file_gets_the_message_and_place_that_the_macro_shows() {
    for path in cases() {
        let read = |path: &Path| std::fs::read_to_string(path).expect("readable");
        let errors: Vec<_> = certified_kernels(&read(&path)).expect_err("a mistake").into_iter().collect();
        let shown = read(&path.with_extension("stderr"));
        let told: Vec<String> = errors.iter().map(|error| format!("error: {error}")).collect();
        let first_lines: Vec<&str> = shown.lines().filter(|line| line.starts_with("error: ")).collect();
        assert_eq!(first_lines, told, "{}", path.display());
        for start in errors.iter().map(|error| error.span().start()) {
            let place = format!(".rs:{}:{}\n", start.line, start.column + 1);
            assert!(shown.contains(&place), "{}: at {place}but shown\n{shown}", path.display());
        }
    }
}

#[test]
fn every_message_has_its_case() {
    let catalogue = include_str!("../src/error.rs").lines();
    let names = catalogue.filter_map(|line| line.strip_prefix("pub const ")?.split(':').next());
    let cases = cases();
    let has_case =
        |name: &&str| cases.iter().any(|path| path.file_stem().is_some_and(|stem| *stem == *name.to_lowercase()));
    let missing: Vec<_> = names.filter(|name| !has_case(name)).collect();
    // The last guard of `parse`: whatever is unreadable has a message of its own.
    assert_eq!(missing, ["UNREADABLE"]);
}

#[test]
fn one_run_reports_all_errors() {
    let source = "#[kernel(famly = 1)] fn f(x: f32) -> f64 { let y = 2 * z; x.powi(y) + (1 as f64) }";
    let expected =
        [error::ATTRIBUTE, error::INPUT_TYPE, error::INTEGER, error::UNKNOWN_NAME, error::POWER, error::CAST];
    assert_eq!(messages(source), expected);
}

#[test]
fn errors_of_all_kernels_of_a_file_are_reported() {
    let source =
        "#[kernel] fn f(x: f64) -> f64 { 1 } mod m { #[closedform::kernel()] fn g() -> f64 { 1.0 } fn h() {} }";
    assert_eq!(messages(source), [error::INTEGER, error::NO_INPUTS]);
}

#[test]
fn a_refused_name_causes_no_follow_up() {
    let source = "#[kernel] fn f(mut x: f64) -> f64 { let (y, z): (f64, f64) = x; let w = 1; x + y + z + w }";
    assert_eq!(messages(source), [error::INPUT_PATTERN, error::LET, error::INTEGER]);
}
