//! Documents: every link leads somewhere, the book has all its pages, and printed formulas are fresh.

use std::fs;
use std::path::Path;

use closedform_tests::workspace::{self, Source};
use closedform_tests::{bench, links};

fn documents() -> Vec<Source> {
    workspace::files().into_iter().filter(|file| file.path.ends_with(".md")).collect()
}

#[test]
fn links_lead_somewhere() {
    let root = workspace::root();
    let broken = |document: &Source| {
        links::complaints(document, |path| root.join(path).exists(), |path| fs::read_to_string(root.join(path)).ok())
    };
    let complaints: Vec<String> = documents().iter().flat_map(broken).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn the_summary_names_every_page_of_the_book() {
    let documents = documents();
    let pages = documents.iter().filter_map(|document| document.path.strip_prefix("book/src/"));
    let summary = fs::read_to_string(workspace::root().join("book/src/SUMMARY.md")).expect("SUMMARY.md can be read");
    let named = links::targets(&summary);
    let missing: Vec<&str> =
        pages.filter(|page| *page != "SUMMARY.md" && !named.iter().any(|name| name == page)).collect();
    assert!(!named.is_empty() && missing.is_empty(), "SUMMARY.md does not name {missing:?}");
}

#[test]
fn the_bench_times_the_references_as_they_are_written() {
    let (text, path) = (bench::text(), workspace::root().join(bench::PATH));
    if fs::read_to_string(&path).is_ok_and(|found| found == text) {
        return;
    }
    let fresh = Path::new(env!("CARGO_TARGET_TMPDIR")).join("as_written.rs");
    fs::write(&fresh, text).expect("cargo's folder for tests can be written");
    panic!("{} is stale: copy {} there", bench::PATH, fresh.display());
}
