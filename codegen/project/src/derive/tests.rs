//! Derivation with a real Maxima, and one clear error for each way in which a worksheet can fail.

use std::time::Duration;

use super::*;
use crate::drawn::{drawn, has};
use crate::maxima_process::Maxima;

const CONTRACT: &str = r#"[family]
title = "A family"
[inputs]
x = { name = "x", unit = "m", typical = [1e-2, 1e2] }
y = { name = "y", unit = "m", typical = [1e-2, 1e2] }
[[kernel]]
name = "difference"
doc = "Difference."
inputs = ["x", "y"]
domain = ["x >= 0", "y >= x"]
returns = "Difference"
[[kernel.result]]
name = "of_roots"
worksheet = "d"
unit = "1"
[[kernel.result]]
name = "root"
worksheet = "r"
unit = "1"
"#;

const WORKSHEET: &str = "/* é */ assume(x > 0)$ x: 3$ d(x,y) := sqrt(y) - sqrt(x^2)/sqrt(x)$\n\
    define(r('x,'y), positive_root('(z^2 + y*z - (x+1)), z))$ fpprintprec: 4$ linel: 20$ numer: true$ e: 5$";

fn folder(worksheet: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("family.mac"), worksheet).unwrap();
    std::fs::write(folder.path().join("family.toml"), CONTRACT).unwrap();
    folder
}

fn options(limit: Duration) -> Options {
    let maxima = Maxima { limit, ..Maxima::default() };
    Options { maxima, ..Options::default() }
}

/// The report of a derivation that must fail and leave its folder as it was.
#[track_caller]
fn failure(worksheet: &str, limit: Duration) -> String {
    failure_with(worksheet, &options(limit))
}

/// The same of a worksheet that may start programs.
#[track_caller]
fn failure_of_programs(worksheet: &str, limit: Duration) -> String {
    let mut options = options(limit);
    options.maxima.allow_system = true;
    failure_with(worksheet, &options)
}

#[track_caller]
fn failure_with(worksheet: &str, options: &Options) -> String {
    let folder = folder(worksheet);
    let error = derive(folder.path(), "family", options).unwrap_err();
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "the folder has changed");
    drawn(&error).replace(&folder.path().display().to_string(), "FOLDER")
}

#[track_caller]
fn fails(worksheet: &str, words: &[&str]) {
    has(&failure(worksheet, Duration::from_secs(60)), words);
}

#[test]
fn a_family_is_derived_written_and_confirmed() {
    let folder = folder(WORKSHEET);
    let options = Options { points: 50, ..Options::default() };
    let derived = derive(folder.path(), "family", &options).unwrap();
    let lines: Vec<&str> = derived.reference.lines().collect();
    assert!(lines[0].starts_with("/* reference expressions, written by `closedform derive family`"), "{}", lines[0]);
    let stamp = closedform_build::Stamp::read(&derived.reference).unwrap();
    assert!(stamp.is_of(&derived.reference));
    assert!(lines[2].starts_with("/* Maxima 5."), "{}", lines[2]);
    assert_eq!(lines[3], "d(x,y):=sqrt(y)-sqrt(x)$");
    assert_eq!(lines[4], "r(x,y):=positive_root(z^2+y*z-x-1,z)$");
    assert_eq!(derived.values.len(), 2 * options.points);
    let equal: Vec<_> =
        derived.values.iter().filter(|v| v.worksheet == "d" && v.inputs[0].1 == v.inputs[1].1).collect();
    assert!(!equal.is_empty() && equal.iter().all(|value| value.value == "0"), "exact zeros");
    derived.write().unwrap();
    assert_eq!(golden::load(&derived.paths.golden).unwrap(), derived.values);
    assert_eq!(rederive(folder.path(), "family", &options).unwrap(), derived.definitions);
    assert_eq!(compare(folder.path(), "family", &options).unwrap(), Compared::default());
}

#[test]
fn a_golden_value_is_what_the_formula_is_worth() {
    let folder = folder(WORKSHEET);
    let derived = derive(folder.path(), "family", &Options::default()).unwrap();
    for value in &derived.values {
        let (x, y) = (value.inputs[0].1, value.inputs[1].1);
        let stable = if value.worksheet == "d" {
            if x == y { 0.0 } else { (y - x) / (y.sqrt() + x.sqrt()) }
        } else {
            2.0 * (x + 1.0) / (y + (y * y + 4.0 * (x + 1.0)).sqrt())
        };
        let golden: f64 = value.value.parse().unwrap();
        assert!((golden - stable).abs() <= 1e-15 * stable.abs(), "{value:?} {stable}");
    }
}

#[test]
fn what_a_formula_needs_by_itself_is_added_to_its_domain() {
    let folder =
        folder("q: map(rhs, solve(y*z^2 + 3*z + x = 0, z))$ define(d('x,'y), q[2])$ define(r('x,'y), sqrt(x))$");
    let derived = derive(folder.path(), "family", &Options::default()).unwrap();
    assert_eq!(derived.added, [("difference".to_owned(), vec!["9-4*x*y >= 0".to_owned()])]);
    assert_eq!(derived.values.len(), 2 * Options::default().points);
    let exactly = |value: f64| num_rational::BigRational::from_float(value).unwrap();
    for value in &derived.values {
        let [x, y] = [0, 1].map(|at| exactly(value.inputs[at].1));
        let four = exactly(4.0);
        assert!(four * &x * &y <= exactly(9.0) && y >= x && y != exactly(0.0), "{value:?}");
    }
    derived.write().unwrap();
    assert_eq!(compare(folder.path(), "family", &Options::default()).unwrap(), Compared::default());
    // what no condition on the inputs mends stays an error
    fails("d(x,y) := sqrt(-1-x^2)$ r(x,y) := x$", &["the kernel `difference` at x=", "the value is not real"]);
    fails("d(x,y) := x+foo$ r(x,y) := x$", &["foo"]);
}

#[test]
fn a_golden_value_that_changed_is_named() {
    let folder = folder(WORKSHEET);
    let derived = derive(folder.path(), "family", &Options::default()).unwrap();
    derived.write().unwrap();
    let mut values = derived.values.clone();
    values[0].value = format!("-{}", values[1].value);
    std::fs::write(&derived.paths.golden, golden::print(&values)).unwrap();
    let named = compare(folder.path(), "family", &Options::default()).unwrap().disagreements;
    assert_eq!(named.len(), 1);
    assert_eq!((&named[0].golden, &named[0].now), (&values[0], &Ok(derived.values[0].value.clone())));
}

#[test]
fn a_worksheet_runs_once_to_be_derived_and_once_to_be_compared() {
    let folder = folder("");
    let runs = folder.path().join("runs");
    let worksheet = format!("system(\"echo run >> {}\")$ d(x,y) := y-x$ r(x,y) := y$", runs.display());
    std::fs::write(folder.path().join("family.mac"), worksheet).unwrap();
    let mut options = options(Duration::from_secs(60));
    options.maxima.allow_system = true;
    derive(folder.path(), "family", &options).unwrap().write().unwrap();
    assert_eq!(std::fs::read_to_string(&runs).unwrap(), "run\n");
    assert_eq!(compare(folder.path(), "family", &options).unwrap(), Compared::default());
    assert_eq!(std::fs::read_to_string(&runs).unwrap(), "run\n".repeat(2));
}

#[test]
fn questions_are_shown_with_their_statement() {
    fails(
        "a: 1$\nb: integrate(1/(t^2+c), t, 0, 1)$\n",
        &["Maxima asks: Is c positive or negative?", "family.mac:2:1", "assume"],
    );
    fails("b: read(\"how much?\")$", &["Maxima asks: how much?"]);
    fails("d(x,y) := integrate(1/(t^2+c), t, 0, 1)$", &["Maxima asks: Is c positive", "assume"]);
}

#[test]
fn statements_that_fail_are_pointed_at() {
    fails(
        "kill(all)$ x: 1$\n/* error */ error(\"no\", x, \"way\")$ y: 2$",
        &["Maxima stops: no 1 way", ",-[FOLDER/family.mac:2:13]"],
    );
    fails("x: 1$\n y: 1/0$", &["expt: undefined: 0 to a negative exponent", "family.mac:2:2"]);
    fails("x: 1$\n\ny: (2+)$ z: 1$", &["incorrect syntax", "family.mac:3:1"]);
    fails("x: 1$\ny: (2+", &["does not end", "family.mac:2:1"]);
    fails("x: 1$\nquit()$\ny: 2$", &["ends Maxima", "family.mac:2:1"]);
}

#[test]
fn loops_are_stopped() {
    let start = std::time::Instant::now();
    let report = failure("x: 1$\nwhile true do x: x$ y: 1$", Duration::from_secs(2));
    assert!(report.contains("did not finish in 2 s") && report.contains("family.mac:2:1"), "{report}");
    fails(
        "while true do print(\"again and again and again and again and again and again and again\")$",
        &["without end"],
    );
    assert!(start.elapsed() < Duration::from_secs(60));
}

#[test]
fn functions_that_do_not_fit_are_named() {
    fails("", &["family.mac defines no function `d`, which the kernel `difference` needs", "add define(d(x,y), ..)$"]);
    fails("d(y,x) := x$ r(x,y) := x$", &["defines d(y,x), but the contract promises d(x,y)"]);
    fails("d(x,y) := (print(\"hello\"), x)$ r(x,y) := x$", &["d(x,y) printed something", "hello"]);
    fails("d(x,y) := error(\"never\")$ r(x,y) := x$", &["d(x,y) cannot be applied to its own symbols: never"]);
    fails("d(x,y) := x+q$ r(x,y) := x$", &["`d` contains `q`"]);
    fails("d(x,y) := [x,y]$ r(x,y) := x$", &["`d` is not a closed form"]);
    fails("d(x,y) := sqrt(-1-x)$ r(x,y) := x$", &["the kernel `difference` at x=", "the value is not real"]);
    fails("d(x,y) := 1/(x-x*y/y+0*y)$ r(x,y) := x$", &["cannot be applied", "0 to a negative exponent"]);
    fails(
        "d(x,y) := 1/(sqrt(x)*sqrt(y)-sqrt(x*y))$ r(x,y) := x$",
        &["has values at", "instead of 24", "exclude by `domain`"],
    );
}

#[test]
fn a_missing_maxima_says_how_to_get_one() {
    let folder = folder(WORKSHEET);
    let maxima = Maxima { program: "no-such-maxima".into(), ..Maxima::default() };
    let error = derive(folder.path(), "family", &Options { maxima, ..Options::default() }).unwrap_err();
    let report = drawn(&error);
    assert!(report.contains("apt-get install maxima") && report.contains("CLOSEDFORM_MAXIMA"), "{report}");
}

#[test]
fn a_worksheet_prints_what_it_likes() {
    let noise = "print(\"hello\")$ display2d: false$ 1+1; x^2/3; printf(true, \"~a~%\", \"end\")$";
    let folder = folder(&format!("{noise} {WORKSHEET} {noise}"));
    assert!(derive(folder.path(), "family", &Options::default()).is_ok());
}

/// Whatever way a name is put together, the machine is left alone; `failure` sees that no file was made.
#[test]
fn a_worksheet_that_reaches_beyond_itself_is_refused() {
    let refused = "reaches beyond the worksheet";
    for (worksheet, words) in [
        ("system(\"touch made\")$", "the worksheet calls `system`"),
        ("apply(concat(sys, tem), [\"touch made\"])$", refused),
        ("block([f: concat(sys, tem)], apply(f, [\"touch made\"]))$", refused),
        ("eval_string(sconcat(\"sys\", \"tem(\\\"touch made\\\")\"))$", refused),
        ("eval_string(sconcat(\"?\", \"car([1])\"))$", "Lisp is run with --allow-system only"),
        ("apply(concat(with_std, out), [\"made\", 1])$", refused),
        ("apply(concat(string, out), [\"made\", [x]])$", refused),
        ("apply(concat(open, w), [\"made\"])$", refused),
        ("apply(concat(lo, ad), [\"family.mac\"])$", refused),
        ("apply(concat(bat, ch), [\"family.mac\"])$", refused),
        ("apply(concat(plot, \"2d\"), [x, [x,0,1]])$", refused),
        ("g() := apply(concat(sys, tem), [\"touch made\"])$ define(h(x), g())$", refused),
    ] {
        fails(&format!("{worksheet} d(x,y) := x$ r(x,y) := y$"), &[words]);
    }
}

#[test]
fn what_is_allowed_is_run() {
    let folder = folder("system(\"touch made\")$ d(x,y) := y-x$ r(x,y) := y$");
    let mut options = options(Duration::from_secs(60));
    options.maxima.allow_system = true;
    derive(folder.path(), "family", &options).unwrap();
    assert!(folder.path().join("made").exists());
}

#[test]
fn files_that_somebody_else_wrote_stay() {
    let folder = folder("d(x,y) := y-x$ r(x,y) := y$");
    std::fs::write(folder.path().join("family.ref"), "d(x,y):=y-x$ /* by hand */\n").unwrap();
    let error = derive(folder.path(), "family", &options(Duration::from_secs(60))).unwrap_err();
    has(&drawn(&error), &["family.ref", "rename it if it is yours"]);
}

#[test]
fn waiting_costs_no_processor_time_but_ends_too() {
    let sleep = "x: 1$ system(\"sleep 3\")$";
    has(&failure_of_programs(sleep, Duration::from_millis(1500)), &["family.mac defines no function `d`"]);
    let report = failure_of_programs("x: 1$\nsystem(\"sleep 1000\")$", Duration::from_millis(500));
    has(&report, &["Maxima did not finish in 10 s, of which it used 0 s", "family.mac:2:1", "sleeps or waits"]);
}

#[test]
fn children_of_maxima_count() {
    let start = std::time::Instant::now();
    let report = failure_of_programs("x: 1$\nsystem(\"yes >/dev/null\")$", Duration::from_secs(2));
    has(&report, &["did not finish in 2 s of processor time", "family.mac:2:1", "--limit"]);
    assert!(start.elapsed() < Duration::from_secs(60));
}

/// The text that Maxima leaves of a worksheet without a contract, without its first lines; and what was passed over.
fn left(files: &[(&str, &str)]) -> Result<(String, Vec<String>), String> {
    let folder = tempfile::tempdir().unwrap();
    files.iter().for_each(|(name, text)| std::fs::write(folder.path().join(name), text).unwrap());
    let path = folder.path().join(files[0].0);
    let sheet = derive_sheet(&path, &options(Duration::from_secs(60))).map_err(|error| drawn(&error))?;
    sheet.write().unwrap();
    let family = crate::family::Family::sheet(&path).unwrap();
    assert!(family.summary.lines[0].contains("that Maxima derived"), "{:?}", family.summary);
    let text = sheet.text.lines().skip(3).collect::<Vec<_>>().join("\n");
    std::fs::write(&path, "f(x) := x$").unwrap();
    has(&drawn(&crate::family::Family::sheet(&path).unwrap_err()), &["derived from another", "closedform derive"]);
    Ok((text, sheet.passed))
}

#[test]
fn a_worksheet_without_a_contract_leaves_formulas() {
    let text = "assume(a > 0)$ s: solve(x^2 = a, x)$ root: rhs(s[2])$ plot2d(x, [x,0,1])$\n\
                area(r) := integrate(2*t*a, t, 0, r)$ load(\"elsewhere\")$ loud(x) := print(x)$ word: done$ k: 3$";
    let (text, passed) = left(&[("calc.mac", text)]).unwrap();
    assert_eq!(text, "assume(a > 0)$\ns:[x = -sqrt(a),x = sqrt(a)]$\nroot:sqrt(a)$\narea(r):=a*r^2$\nk:3$");
    has(&passed.join("; "), &["line 1: passed over: it calls `plot2d`", "load(\"elsewhere\")", "`loud`: a program"]);
}

#[test]
fn worksheets_beside_are_run_too_and_guarded_as_well() {
    let main = ("main.mac", "load(\"part.mac\")$ y: diff(h(t), t)$");
    let (text, _) = left(&[main, ("part.mac", "g: 10$ h(x) := g*x^2$")]).unwrap();
    assert_eq!(text, "y:20*t$");
    let said = left(&[main, ("part.mac", "h(x) := x$ apply(concat(sys, tem), [\"touch made\"])$")]).unwrap_err();
    has(&said, &["reaches beyond the worksheet"]);
    let said = left(&[main, ("part.mac", "h(x) := x$ system(\"touch made\")$")]).unwrap_err();
    has(&said, &["the worksheet calls `system`", "part.mac"]);
}

#[test]
fn questions_are_answered_where_they_are_asked() {
    let said = left(&[("calc.mac", "x: 1$\ny: integrate(t^n, t)$")]).unwrap_err();
    has(&said, &["Maxima asks: Is n equal to - 1?", "assume(notequal(n,- 1))$", "calc.mac:2:1"]);
    let (text, passed) = left(&[("calc.mac", "f(n) := integrate(t^n, t)$ g(x) := x+1$")]).unwrap();
    assert_eq!(text, "g(x):=x+1$", "a function that asks is passed over");
    has(&passed.join("; "), &["`f`: Maxima has no value", "Maxima asks: Is n equal to"]);
    has(&left(&[("calc.mac", "solve(x, x)$")]).unwrap_err(), &["leaves no formula"]);
}

#[test]
fn what_ends_maxima_does_not_end_the_derivation() {
    let (text, passed) = left(&[("calc.mac", "y: diff(x^2, x)$\nquit()$\ny: error(\"not read\")$")]).unwrap();
    assert_eq!(text, "y:2*x$");
    assert_eq!(passed, ["line 2: passed over: `quit`, and what follows it"]);
}

#[test]
fn an_error_of_a_package_is_told_with_its_place() {
    let said = left(&[("calc.mac", "y: diff(x^2, x)$\nprintf(y, \"a\")$")]).unwrap_err();
    has(&said, &["Maxima stops", "printf", "calc.mac:2:1"]);
}

#[test]
fn elements_of_arrays_stay_inputs() {
    let text = "y: x[1]^2+integrate(t,t,0,x[2])$ f(v) := v[1]*integrate(t,t,0,v[2])$ g(a) := a^2+b[1,2]$";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("calc.mac");
    std::fs::write(&path, text).unwrap();
    derive_sheet(&path, &options(Duration::from_secs(60))).unwrap().write().unwrap();
    let kernels = crate::family::Family::sheet(&path).unwrap().family.contract.kernels;
    let inputs: Vec<String> = kernels.iter().map(|kernel| kernel.inputs.join(",")).collect();
    assert_eq!(inputs, ["x_2,x_1", "v_1,v_2", "a,b_1_2"]);
}
