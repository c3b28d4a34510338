//! Families on disk: what fits, and one clear error for each thing that does not.

use std::path::Path;

use closedform_maxima::print;

use super::*;
use crate::drawn::{drawn, has};

const CONTRACT: &str = r#"[family]
title = "A family"
[inputs]
x = { name = "x", unit = "m" }
tOut = { name = "t_out", unit = "s" }
[[kernel]]
name = "speed"
doc = "Speed."
inputs = ["x", "tOut"]
[[kernel.result]]
name = "speed"
worksheet = "v"
unit = "m/s"
[[kernel]]
name = "root"
doc = "Root."
inputs = ["x"]
[[kernel.result]]
name = "root"
worksheet = "r"
unit = "m"
"#;

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    files.iter().for_each(|(name, text)| std::fs::write(folder.path().join(name), text).unwrap());
    folder
}

fn with_reference(reference: &str) -> String {
    let folder = folder(&[("family.toml", CONTRACT), ("family.ref", reference)]);
    drawn(&Family::load(folder.path(), "family").unwrap_err())
}

fn stranger(text: &str) -> Result<Family, String> {
    let folder = folder(&[("my.mac", text)]);
    Family::from_worksheet(&folder.path().join("my.mac")).map_err(|error| drawn(&error))
}

#[test]
fn references_come_in_contract_order() {
    let reference = "/* made */\nr(x):=positive_root(z^2-x,z)$\nv(x,tOut):=sqrt(x)/tOut+%pi$\n";
    let folder = folder(&[("family.toml", CONTRACT), ("family.ref", reference)]);
    let families = families(folder.path()).unwrap();
    let names: Vec<&str> = families[0].references.iter().map(|definition| definition.name.as_str()).collect();
    assert_eq!(names, ["v", "r"]);
    let results: Vec<&str> = families[0].results().map(|(kernel, ..)| kernel.name.as_str()).collect();
    assert_eq!(results, ["speed", "root"]);
}

#[test]
fn missing_files_say_what_makes_them() {
    let folder = folder(&[("family.toml", CONTRACT)]);
    let error = drawn(&Family::load(folder.path(), "family").unwrap_err());
    has(&error, &["family.ref", "closedform derive family"]);
    assert!(families(Path::new("/nowhere")).is_err());
}

#[test]
fn references_that_do_not_fit_are_pointed_at() {
    has(&with_reference("v(x,tOut):=x$"), &["no reference expression `r` for the kernel `root`", "closedform derive"]);
    has(
        &with_reference("v(x,tOut):=x$r(x):=x$w(x):=x$"),
        &["no kernel has a result `w`", "does not name this function"],
    );
    has(
        &with_reference("v(tOut,x):=x$r(x):=x$"),
        &["parameters of `v` are (tOut,x)", "inputs of its kernel are (x,tOut)"],
    );
    has(&with_reference("v(x,tOut):=x$r(x):=x+tIn$"), &["`r` contains `tIn`", "not a parameter", "^"]);
    has(&with_reference("v(x,tOut):=x$r(x):=1+erf(x)$"), &["`r` calls `erf`", "sqrt(x), abs(x)"]);
    has(&with_reference("v(x,tOut):=x$r(x):=[x]$"), &["`r` is not a closed form"]);
    has(&with_reference("v(x,tOut):=x$r(x):=positive_root(x^2-1,x)$"), &["`r` is not a closed form"]);
    has(&with_reference("v(x,tOut):=x$r(x):=x+$"), &["expected"]);
    has(&with_reference("v(x,tOut):=x$r(x):=x$r(x):=2*x$"), &["`r` is defined twice"]);
}

#[test]
fn a_stranger_needs_no_contract() {
    let family = stranger("g(x,T):=hypot(x,1)+T$ /* c */ hypot(a,b):=sqrt(a^2+b^2)$ fA(t,T,fn):=t*T*fn$").unwrap();
    let bodies: Vec<String> = family.references.iter().map(|definition| print(&definition.body)).collect();
    assert_eq!(bodies, ["sqrt(x^2+1^2)+T", "sqrt(a^2+b^2)", "t*T*fn"]);
    let kernels: Vec<&str> = family.contract.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    assert_eq!((family.name.as_str(), kernels), ("my", vec!["g", "hypot", "f_a"]));
    let inputs = family.contract.inputs_of(&family.contract.kernels[2]);
    let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
    assert_eq!(names, ["t_value", "t", "fn_value"]);
    assert_eq!((inputs[0].unit.as_str(), inputs[0].typical), ("1", [1e-3, 1e3]));
    assert!(family.contract.kernels[0].domain.holds(&[-1.0, 0.0]));
    assert!(family.contract.kernels.iter().all(|kernel| kernel.few_roundings), "digits before time");
}

#[test]
fn definitions_are_put_in_without_mixing_variables() {
    let family = stranger("r(a):=positive_root(x^2-a*x-1,x)$ s(x):=r(x+1)$ t(a,b):=u(b,a)$ u(a,b):=a-b$").unwrap();
    let body = |at: usize| print(&family.references[at].body);
    assert_eq!(body(1), "positive_root(x_^2-(x+1)*x_-1,x_)");
    assert_eq!(body(2), "b-a");
}

#[test]
fn a_contract_beside_a_stranger_is_used() {
    let text = "v(x,tOut):=h(x)/tOut$ r(x):=h(x)$ h(x):=sqrt(x)$";
    let folder = folder(&[("family.toml", CONTRACT), ("family.mac", text)]);
    let family = Family::from_worksheet(&folder.path().join("family.mac")).unwrap();
    assert_eq!(family.contract.kernels[0].name, "speed");
    assert_eq!(family.references.len(), 2);
}

#[test]
fn strangers_that_need_maxima_are_told_so() {
    has(
        &stranger("f(x):=x$ s: solve(x=1,x)$").unwrap_err(),
        &["`s` must be computed: it calls `solve`", "closedform derive FILE", "my.mac:1:13"],
    );
    has(&stranger("").unwrap_err(), &["the worksheet has no formula", "f(x,y):=sqrt"]);
    has(&stranger("f():=1$ a: 2$ \"text\"$").unwrap_err(), &["the worksheet has no formula"]);
    has(&stranger("f(x):=").unwrap_err(), &["expected"]);
}

#[test]
fn strangers_that_are_no_closed_forms_are_pointed_at() {
    let cycle = stranger("f(x):=g(x)+1$ g(x):=h(x)$ h(x):=g(x)$").unwrap_err();
    has(&cycle, &["call each other without end: g -> h -> g", "without recursion"]);
    has(&stranger("f(x):=f(x)$").unwrap_err(), &["f -> f"]);
    has(&stranger("f(x):=g(x,1)$ g(x):=x$").unwrap_err(), &["`g` takes 1 arguments, but is called with 2"]);
    has(&stranger("f(x,x):=x$").unwrap_err(), &["the parameter `x` twice"]);
    let no_else = "f(x):=if x>0 then (if x>1 then 1) else x$";
    has(&stranger(no_else).unwrap_err(), &["an `if` without `else`", "write `else` and a value"]);
}

#[test]
fn what_no_kernel_computes_is_pointed_at_before_anything_runs() {
    has(&stranger("f(x):=x*(-2)^(1/5)$").unwrap_err(), &["`f`: such a power of -2", "my.mac:1:", "positive numbers"]);
    has(&stranger("f(x):=x*log(-2)$").unwrap_err(), &["`f`: it takes the logarithm of -2", "my.mac:1:"]);
    has(&stranger("f(x):=x+asin(3/2)$").unwrap_err(), &["`f`: it takes the angle of 3/2", "my.mac:1:"]);
    has(
        &stranger("g(x):=x$\nf(x):=1/0+x$").unwrap_err(),
        &["`f`: it divides by zero", "my.mac:2:9", "correct the divisor"],
    );
    has(&stranger("f(x):=x+(2-2)^-1$").unwrap_err(), &["`f`: it divides by zero", "my.mac:1:9"]);
    has(&stranger("f(x):=x+1/(3*(1-1))^2$").unwrap_err(), &["`f`: it divides by zero", "my.mac:1:11"]);
    has(&stranger("f(x):=x*sqrt(1-2)$").unwrap_err(), &["the square root of -", "my.mac:1:9"]);
    has(&stranger("f(x):=x*(-4)^(1/2)$").unwrap_err(), &["the square root of -", "my.mac:1:9"]);
    has(&stranger("f(x):=x+0^0$").unwrap_err(), &["0^0", "my.mac:1:9"]);
}

#[test]
fn constants_and_functions_that_are_not_known_yet_say_what_can_be_done() {
    let said = |text: &str| stranger(text).unwrap_err().split_whitespace().collect::<Vec<_>>().join(" ");
    for formula in ["f(x):=%e^x$", "f(x):=x*%e$", "f(x):=1/(1+%e^(-x))$", "f(x,y):=x^y$", "f(x):=sinh(x)$"] {
        assert!(stranger(formula).is_ok(), "{formula}");
    }
    has(&said("f(x):=erf(x)$"), &["calls `erf`", "kernels know", "not known yet", "make it an input"]);
    assert!(!said("f(x):=frobnicate(x)$").contains("not known yet"));
    has(&said("f(x):=%i*x$"), &["the constant `%i`", "the real and the imaginary part"]);
    assert!(stranger("f(x):=%phi*x$").is_ok_and(|family| print(&family.references[0].body) == "(1+sqrt(5))/2*x"));
    has(&said("f(n):=n!/2$"), &["calls `factorial`"]);
    has(&said("f(do):=do^2$"), &["`do` is a keyword of Maxima", "my.mac:1:3", "choose another one"]);
}

/// The mistakes of a worksheet, each with the line that it points at, and the kernels that can be made all the same.
fn sheet(text: &str) -> (Vec<usize>, Vec<String>, String) {
    let folder = folder(&[("my.mac", text)]);
    let Sheet { family, error, .. } = Family::sheet(&folder.path().join("my.mac")).unwrap();
    let kernels = family.contract.kernels.iter().map(|kernel| kernel.name.clone()).collect();
    let said = error.map_or_else(String::new, |error| drawn(&error));
    let lines = said.split("my.mac:").skip(1).filter_map(|rest| rest.split(':').next()?.parse().ok()).collect();
    (lines, kernels, said)
}

#[test]
fn every_mistake_of_a_worksheet_is_told_at_once() {
    let text = "good(x):=x^2+1$\n\
                torn(x):=x+$\n\
                constant():=2$\n\
                loose(x):=x+y$\n\
                calls(x):=loose(x)+1$\n\
                zero(x):=1/0+x*log(-1)$\n\
                sine(x):=erf(x)$\n\
                endless(x):=endless(x)$\n\
                more(x):=good(x,1)$\n\
                needs(x):=torn(x)$\n\
                strange(x):=2\u{b7}x$\n\
                fine(x):=good(x)/2$\n";
    let (lines, kernels, said) = sheet(text);
    assert_eq!(lines, [2, 6, 6, 7, 8, 9, 11], "{said}");
    assert_eq!(kernels, ["good", "loose", "calls", "fine"]);
    has(&said, &["7 mistakes", "the logarithm of -1", "divides by zero"]);
    let (_, kernels, said) = sheet("good(x):=x^2$ bad(x):=good(x$");
    assert_eq!(kernels, ["good"], "{said}");
    let (lines, kernels, said) = sheet("good(x):=x^2$ fine(x):=good(x)$");
    assert_eq!((lines.len(), kernels.len()), (0, 2), "{said}");
}

#[test]
fn a_kernel_is_whole_or_not_there() {
    let text = "v(x,tOut):=1/0+x$ r(x):=sqrt(x)$";
    let folder = folder(&[("family.toml", CONTRACT), ("family.mac", text)]);
    let Sheet { family, error, .. } = Family::sheet(&folder.path().join("family.mac")).unwrap();
    let kernels: Vec<&str> = family.contract.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    assert_eq!((kernels, family.references.len()), (vec!["root"], 1));
    assert!(family.place("root").ends_with("family.mac:1:19"), "{}", family.place("root"));
    has(&drawn(&error.unwrap()), &["1 mistake", "divides by zero"]);
}

#[test]
fn one_cause_is_told_once() {
    let said = stranger("f(x):=erf(x)+erf(2*x)$ g(x):=erf(x)$ h(y):=f(y)$").unwrap_err();
    assert_eq!(said.matches("calls `erf`").count(), 1, "{said}");
    let said = stranger("a: solve(x=1,x)$ f(y):=a*y$ g(y):=a+y$ h(x):=x$").unwrap_err();
    assert_eq!(said.matches("calls `solve`").count(), 1, "{said}");
    let many: String = (0..1000).map(|number| format!("f{number}(x):=x+sine{number}(x)$\n")).collect();
    let said = stranger(&many).unwrap_err();
    assert!(said.contains("1000 mistakes, of which the first 100 are shown") && said.len() < 100 * 800, "{said}");
}

#[test]
fn a_worksheet_of_any_name_may_have_a_contract() {
    let text = "v(x,tOut):=x/tOut$ r(x):=x$";
    let folder = folder(&[("my sheet.toml", CONTRACT), ("my sheet.mac", text)]);
    let family = Family::from_worksheet(&folder.path().join("my sheet.mac")).unwrap();
    assert_eq!((family.name.as_str(), family.contract.kernels[0].name.as_str()), ("my_sheet", "speed"));
}

#[test]
fn formulas_that_grow_without_measure_are_refused() {
    let mut text = "f0(x):=x+1$".to_owned();
    (1..60).for_each(|level| text += &format!("f{level}(x):=f{}(x)*f{}(x)$", level - 1, level - 1));
    has(&stranger(&text).unwrap_err(), &["grow to more than 100000 terms"]);
}

#[test]
fn cores_become_kernels_with_their_preconditions() {
    let cores = "(FPCore (x) :name \"NMSE example 3.1\" :cite (hamming-1987) :pre (>= x 0) (- (sqrt (+ x 1)) (sqrt x)))\n\
                 (FPCore square (x) (* x x))\n(FPCore (x y) :name \"Calls another.\" (+ (square x) (square (square y))))";
    let folder = folder(&[("my.fpcore", cores)]);
    let family = &families(folder.path()).unwrap()[0];
    let kernel = |at: usize| &family.contract.kernels[at];
    assert_eq!(family.name, "my");
    assert_eq!((kernel(0).name.as_str(), kernel(0).doc.as_str()), ("nmse_example_3_1", "NMSE example 3.1."));
    assert_eq!(kernel(0).source, "my.fpcore, citing hamming-1987");
    assert!(kernel(0).domain.texts().eq(["x>=0"]));
    assert_eq!((kernel(1).name.as_str(), print(&family.references[1].body)), ("square", "x*x".to_owned()));
    assert_eq!(
        (kernel(2).name.as_str(), print(&family.references[2].body)),
        ("calls_another", "x*x+y*y*(y*y)".to_owned())
    );
    assert!(family.places[1].ends_with("my.fpcore:2:1"), "{}", family.places[1]);
}

#[test]
fn what_no_kernel_can_be_made_of_is_named_in_its_file() {
    let cores = "(FPCore f (x)\n  (+ 1 (erfc x)))\n(FPCore g (x)\n :pre (< (sqrt x) 2) x)\n(FPCore h (x)\n (if (+ x 1) x 2))\n\
                 (FPCore fine (x) x)\n(FPCore i (x) (while x))\n(FPCore j () (* 2 PI))\n";
    let folder = folder(&[("my.fpcore", cores)]);
    let Sheet { family, error, summary } = Family::sheet(&folder.path().join("my.fpcore")).unwrap();
    assert_eq!((summary.passed.len(), summary.lines.len()), (5, 5));
    assert!(summary.lines[0].starts_with("line 2: passed over: `f` calls `erfc`"), "{:?}", summary.lines);
    assert_eq!(family.contract.kernels.iter().map(|kernel| kernel.name.as_str()).collect::<Vec<_>>(), ["fine"]);
    has(
        &drawn(&error.unwrap()),
        &[
            "5 mistakes",
            "`f` calls `erfc`, which kernels cannot compute",
            "my.fpcore:2:8",
            "`g`: a side of the domain condition is not a rational function",
            "my.fpcore:4:10",
            "`h`: such a condition has no place",
            "my.fpcore:6:6",
            "`while` is no formula",
            "my.fpcore:8:15",
            "`j` has no argument: it is a number",
            "my.fpcore:9:1",
        ],
    );
    std::fs::write(folder.path().join("my.toml"), CONTRACT).unwrap();
    let sheet = Family::sheet(&folder.path().join("my.fpcore")).unwrap();
    has(&drawn(&sheet.error.unwrap()), &["there is a contract beside the cores", "my.toml"]);
}

#[test]
fn worksheets_of_one_name_have_modules_of_their_own() {
    let folder = folder(&[
        ("a b.mac", "f(x):=x$"),
        ("a-b.wxm", "f(x):=x$"),
        ("a_b.dem", "f(x):=x$"),
        ("a_b.mac", "f(x):=x$"),
        ("con.mac", "f(x):=x$"),
        ("\u{65e5}.mac", "f(x):=x$"),
        ("\u{672c}.mac", "f(x):=x$"),
    ]);
    let found = families(folder.path()).unwrap();
    let file = |family: &Family| family.paths.worksheet.file_name().unwrap().to_string_lossy().into_owned();
    let pairs: Vec<(String, String)> = found.iter().map(|family| (family.name.clone(), file(family))).collect();
    let pairs: Vec<(&str, &str)> = pairs.iter().map(|(name, file)| (name.as_str(), file.as_str())).collect();
    assert_eq!(
        pairs,
        [
            ("a_b", "a_b.mac"),
            ("a_b_2", "a_b.dem"),
            ("a_b_3", "a b.mac"),
            ("a_b_4", "a-b.wxm"),
            ("con_value", "con.mac"),
            ("x", "\u{65e5}.mac"),
            ("x_2", "\u{672c}.mac"),
        ]
    );
    std::fs::write(folder.path().join("a_b.toml"), CONTRACT).unwrap();
    has(&drawn(&families(folder.path()).unwrap_err()), &["a_b.toml has two worksheets", "a_b.mac", "a_b.dem"]);
}
