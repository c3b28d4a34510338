//! The page of verdicts by the command: written by `derive` if all verdicts stand, missed and compared by `check`.

mod common;

use common::{edit, fails, project, succeeds};
use std::fs;
use std::path::{Path, PathBuf};

/// A project with the errata of one family alone.
fn one_family() -> tempfile::TempDir {
    let project = project();
    let errata = project.path().join("maxima-ref/errata");
    for entry in fs::read_dir(&errata).unwrap() {
        let path = entry.unwrap().path();
        if path.file_stem().is_none_or(|name| name != "fly_axis") {
            fs::remove_file(path).unwrap();
        }
    }
    fs::write(errata.join("ORDER"), "fly_axis\n").unwrap();
    _ = fs::remove_file(page(project.path()));
    project
}

fn page(project: &Path) -> PathBuf {
    project.join("maxima-ref/ERRATA.md")
}

fn doctor(project: &Path) {
    edit(&project.join("maxima-ref/errata/fly_axis.toml"), "alpha = 2*v1Diff", "alpha = 3*v1Diff");
}

/// Fails with all of these words.
#[track_caller]
fn refuses(project: &Path, arguments: &[&str], words: &[&str]) {
    let said = fails(project, arguments);
    for word in words {
        assert!(said.contains(word), "{word:?} is not said in:\n{said}");
    }
}

#[test]
fn derive_writes_the_page_and_check_compares_its_list() {
    let project = one_family();
    refuses(project.path(), &["check"], &["missing: ", "ERRATA.md", "closedform derive"]);
    let said = succeeds(project.path(), &["derive", "fly_axis"]);
    assert!(said.contains("ERRATA.md: the verdicts on "), "{said}");
    edit(&page(project.path()), "4.6 tmp | equal |", "4.6 tmp | garbled |");
    let words = ["stale: ", "ERRATA.md", "-4.6 tmp: garbled", "+4.6 tmp: equal", "closedform derive"];
    refuses(project.path(), &["check"], &words);
}

#[test]
fn a_wrong_verdict_names_its_row_and_leaves_everything_as_it_was() {
    let project = one_family();
    fs::write(page(project.path()), "written by `closedform derive`: the page before").unwrap();
    let references = project.path().join("maxima-ref/fly_axis.ref");
    fs::write(&references, "/* written by `closedform derive fly_axis` before */").unwrap();
    doctor(project.path());
    let words = ["fly_axis.toml has a mistake", "4.6 sub_alpha: `printed` is not shown", "correct the transcription"];
    refuses(project.path(), &["derive", "fly_axis"], &words);
    assert_eq!(fs::read_to_string(page(project.path())).unwrap(), "written by `closedform derive`: the page before");
    assert_eq!(fs::read_to_string(references).unwrap(), "/* written by `closedform derive fly_axis` before */");
}

#[test]
fn check_with_maxima_computes_every_verdict_and_the_page() {
    let project = one_family();
    succeeds(project.path(), &["derive", "fly_axis"]);
    edit(&page(project.path()), "4.6 tmp | equal |  |", "4.6 tmp | equal | really |");
    let words = ["stale: ", "ERRATA.md", "-| 4.6 tmp | equal | really |", "closedform derive"];
    refuses(project.path(), &["check", "--maxima"], &words);
    doctor(project.path());
    refuses(project.path(), &["check", "--maxima"], &["fly_axis.toml", "4.6 sub_alpha: `printed` is not shown"]);
}

#[test]
fn families_without_errata_have_no_page() {
    let project = one_family();
    succeeds(project.path(), &["derive", "pvt"]);
    assert!(!page(project.path()).exists());
    fs::remove_dir_all(project.path().join("maxima-ref/errata")).unwrap();
    succeeds(project.path(), &["derive", "fly_axis"]);
    assert!(!page(project.path()).exists());
}
