//! The command on this repository and on broken copies of it: fresh, live, and clear about what is wrong.

mod common;

use closedform_measure::catalogue::Catalogue;
use closedform_project::Project;
use closedform_syntax::Precision;
use common::{
    closedform, closedform_waiting, edit, fails, failure, repository, restamp, small_project, succeeds, turn,
};
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::path::Path;
use std::process::Command;

/// The texts of all generated files of a project.
fn kernels(project: &Path) -> BTreeMap<String, String> {
    let folder = fs::read_dir(project.join("kernels/src/generated")).unwrap();
    folder
        .map(|entry| {
            let path = entry.unwrap().path();
            (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap())
        })
        .collect()
}

/// Fails with a text, and leaves every generated file as it was.
fn refuses(project: &Path, arguments: &[&str], texts: &[&str]) {
    let before = kernels(project);
    let said = fails(project, arguments);
    for text in texts {
        assert!(said.contains(text), "{text:?} is not said in:\n{said}");
    }
    assert_eq!(before, kernels(project), "files changed");
}

/// The arguments that make a crate of a worksheet.
fn making<'a>(worksheet: &'a Path, out: &'a Path) -> [&'a str; 5] {
    ["generate", "--input", worksheet.to_str().unwrap(), "--out", out.to_str().unwrap()]
}

#[test]
fn the_checked_in_kernels_are_fresh_and_proved() {
    let _turn = turn();
    succeeds(&repository(), &["check", "--prove"]);
}

#[test]
fn maxima_derives_what_the_kernels_compute() {
    let _turn = turn();
    succeeds(&repository(), &["check", "--maxima"]);
}

#[test]
fn a_changed_coefficient_in_a_worksheet_names_the_kernel() {
    let _turn = turn();
    let project = small_project();
    let worksheet = project.path().join("maxima-ref/turnaround.mac");
    let text = fs::read_to_string(&worksheet).unwrap();
    fs::write(&worksheet, text + "\ndefine(d2In(a2Max,tIn), a2Max*tIn^2/7)$\n").unwrap();
    refuses(project.path(), &["check", "--maxima"], &["turnaround::ramp_in", "d2In", "closedform derive"]);
    refuses(project.path(), &["check"], &["turnaround.ref was made before a change of", "closedform derive"]);
}

#[test]
fn a_changed_sign_in_a_generated_file_names_file_and_remedy() {
    let _turn = turn();
    let project = small_project();
    let before = kernels(project.path());
    edit(&project.path().join("kernels/src/generated/turnaround.rs"), "root + ", "root - ");
    refuses(project.path(), &["check"], &["turnaround.rs was changed after it was generated", "closedform generate"]);
    succeeds(project.path(), &["generate", "--points", "5"]);
    assert_eq!(kernels(project.path()), before);
}

#[test]
fn a_bound_that_the_text_does_not_prove_names_kernel_and_step() {
    let _turn = turn();
    let project = small_project();
    let family = project.path().join("kernels/src/generated/turnaround.rs");
    edit(&family, "bound = 4.51", "bound = 4.01");
    restamp(&family);
    let texts =
        ["bound of `turnaround::t_in`, re-derived from its Rust text", "`t_in`: the bound is stated as 4.01 ulp"];
    refuses(project.path(), &["check"], &texts);
    edit(&family, "    2.0 * cancelling / (root + polynomial2)", "    2.0 * cancelling / (root - polynomial2)");
    restamp(&family);
    refuses(project.path(), &["check"], &["`turnaround::t_in`", "`root - polynomial2` may cancel"]);
}

#[test]
fn missing_and_orphaned_files_are_named() {
    let _turn = turn();
    let project = small_project();
    let before = kernels(project.path());
    let folder = project.path().join("kernels/src/generated");
    fs::rename(folder.join("pvt.rs"), folder.join("forgotten.rs")).unwrap();
    refuses(project.path(), &["check"], &["missing: ", "pvt.rs", "made by nothing", "forgotten.rs"]);
    succeeds(project.path(), &["generate", "--points", "5"]);
    assert_eq!(kernels(project.path()), before);
}

#[test]
fn a_second_run_changes_nothing() {
    let _turn = turn();
    let project = small_project();
    let output = closedform(project.path(), &["generate", "--points", "5"]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("; 0 files changed"));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("Symbolica"), "the notice belongs on standard error");
}

#[test]
fn a_second_command_at_the_same_time_is_told_to_wait() {
    let _turn = turn();
    let project = small_project();
    let path = std::env::temp_dir().join("closedform-symbolica.lock");
    let lock = OpenOptions::new().create(true).truncate(false).write(true).open(path).unwrap();
    lock.lock().unwrap();
    let before = kernels(project.path());
    let said = failure(&closedform_waiting(project.path(), &["generate"], 0), &["generate"]);
    assert!(said.contains("another closedform command") && said.contains("wait"), "{said}");
    assert_eq!(before, kernels(project.path()));
}

#[test]
fn a_reference_with_an_unbalanced_parenthesis_is_shown() {
    let _turn = turn();
    let project = small_project();
    edit(&project.path().join("maxima-ref/pvt.ref"), "(2*t1*v0+dV*t1)/2", "((2*t1*v0+dV*t1)/2");
    refuses(project.path(), &["generate"], &["pvt.ref", "`(` without its `)`"]);
}

#[test]
fn an_unknown_function_is_named() {
    let _turn = turn();
    let project = small_project();
    edit(&project.path().join("maxima-ref/pvt.ref"), "dV/t1", "gamma(dV)/t1");
    refuses(project.path(), &["generate"], &["gamma", "pvt.ref"]);
}

#[test]
fn a_missing_variable_in_a_contract_is_named() {
    let _turn = turn();
    let project = small_project();
    edit(&project.path().join("maxima-ref/pvt.toml"), r#""v0", "dV", "t1""#, r#""v0", "dV", "t9""#);
    refuses(project.path(), &["generate"], &["t9", "pvt.toml"]);
}

#[test]
fn an_empty_domain_is_shown() {
    let _turn = turn();
    let project = small_project();
    edit(
        &project.path().join("maxima-ref/pvt.toml"),
        r#"domain = ["v0 > 0", "a1 < 0"]"#,
        r#"domain = ["v0 > 0", "v0 < 0", "a1 < 0"]"#,
    );
    refuses(project.path(), &["generate"], &["turn_out", "v0 < 0"]);
}

#[test]
fn a_worksheet_of_ones_own_becomes_a_crate_that_passes_its_judges() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let worksheet = repository().join("codegen/command/tests/classic.mac");
    let out = folder.path().join("mine");
    let arguments = making(&worksheet, &out);
    succeeds(&repository(), &arguments);
    let again = closedform(&repository(), &arguments);
    assert!(again.status.success(), "{}", String::from_utf8_lossy(&again.stderr));
    let catalogue = Catalogue::open(&Project::at(&out).unwrap()).unwrap();
    for name in ["quotient_root", "fourth_power_less_one", "three_consecutive", "blasius"] {
        let precision = catalogue.find(name).unwrap().kernel.meta.precision;
        assert_ne!(precision, Precision::Certified, "{name}: the bound of its stable form is proved");
    }
    for entry in catalogue.entries() {
        let bounds = entry.kernel.meta.results.iter().map(|result| result.bound.unwrap());
        assert!(bounds.fold(0.0, f64::max) <= 2.0, "{}: digits come before time", entry.name);
    }
    succeeds(&out, &["verify", "--points", "2000", "--seed", "2"]);
    let mut test = Command::new(env!("CARGO"));
    test.args(["test", "--quiet", "--offline"]).current_dir(&out);
    let output = test.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("mine")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn every_formula_that_no_kernel_is_made_of_is_named() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (worksheet, out) = (folder.path().join("my.mac"), folder.path().join("mine"));
    fs::write(&worksheet, "f(x) := sqrt(-1-x^2)$ g(x) := x+1$ h(x) := sqrt(-2-x^2)$").unwrap();
    let said = fails(&repository(), &[&making(&worksheet, &out)[..], &["--strict"]].concat());
    assert!(
        said.contains("`my::f` has an empty domain") && said.contains("`my::h`") && !said.contains("my::g"),
        "{said}"
    );
    assert!(!out.exists());
}

#[test]
fn a_contract_of_a_domain_alone_keeps_two_ulp() {
    let _turn = turn();
    let folder = tempfile::tempdir().unwrap();
    let (worksheet, out) = (folder.path().join("my.mac"), folder.path().join("mine"));
    fs::write(&worksheet, "sum(u,v,c) := (u+v)/(1+u*v/c^2)$").unwrap();
    let contract = r#"
        [family]
        title = "Velocities"
        [inputs]
        u = { name = "u", unit = "m/s" }
        v = { name = "v", unit = "m/s" }
        c = { name = "c", unit = "m/s" }
        [[kernel]]
        name = "sum"
        doc = "Sum of two velocities."
        inputs = ["u", "v", "c"]
        domain = ["c > 0", "abs(u) < c", "c > abs(v)"]
        [[kernel.result]]
        name = "sum"
        worksheet = "sum"
        unit = "m/s"
    "#;
    fs::write(worksheet.with_extension("toml"), contract).unwrap();
    let arguments = making(&worksheet, &out);
    succeeds(&repository(), &arguments);
    let catalogue = Catalogue::open(&Project::at(&out).unwrap()).unwrap();
    let sum = &catalogue.find("sum").unwrap().kernel;
    assert_eq!(sum.meta.results[0].bound, Some(0.51));
    assert!(succeeds(&out, &["eval", "sum", "u=0.75", "v=0.75", "c=1"]).contains("0.96"));
    assert!(fails(&out, &["eval", "sum", "u=0.75", "v=-1", "c=1"]).contains("c > abs(v)"));
}

#[test]
fn the_readme_shows_an_evaluation_that_works() {
    let readme = fs::read_to_string(repository().join("README.md")).unwrap();
    let (_, command) = readme.split_once("`target/debug/closedform eval ").unwrap();
    let (arguments, _) = command.split_once('`').unwrap();
    let arguments: Vec<&str> = std::iter::once("eval").chain(arguments.split_whitespace()).collect();
    assert!(succeeds(&repository(), &arguments).contains("t_in = 0.0350254182534948"));
}

#[test]
fn a_folder_that_holds_something_else_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.tex"), "words").unwrap();
    let worksheet = folder.path().join("my.mac");
    fs::write(&worksheet, "f(x) := x$").unwrap();
    let arguments = making(&worksheet, folder.path());
    assert!(fails(&repository(), &arguments).contains("holds something else"));
}

#[test]
fn a_worksheet_that_only_maxima_can_run_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let worksheet = folder.path().join("my.mac");
    fs::write(&worksheet, "s: solve(x^2=2,x)$\nf(x) := rhs(s[1])*x$").unwrap();
    let out = folder.path().join("out");
    let arguments = making(&worksheet, &out);
    let said = fails(&repository(), &arguments);
    assert!(said.contains("closedform derive") && said.contains("solve"), "{said}");
    assert!(!out.exists());
}
