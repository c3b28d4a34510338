//! Every name that Maxima takes becomes a Rust name, and no two of a file the same one.

use std::collections::BTreeSet;

use closedform_project::contract::{Contract, free_module_name, is_device, rust_name};
use closedform_project::family::Family;
use closedform_project::sample::Random;

/// What names are made of: cases, words of Rust and of Maxima, escapes, letters of the world.
const PARTS: &str = "a|A|aB|ab|a_b|a__b|_a|a_|B1|b_1|b1_|x|X|x2|x_2|xValue|x_value|fn|self|Self|crate|super|r|f64|R|PI|pi|\
    main|lib|batch|sqrt|max|%a|%x_2|\\1a|a\\-b|a\\ b|a\\+b|\\[1\\]|\u{3b1}|\u{391}|\u{dc}n\u{ef}|\
    \u{65e5}\u{672c}|a\u{301}|\\\u{b2}|gen|closedform";

/// A name of one part, or of several.
fn name(random: &mut Random) -> String {
    let parts: Vec<&str> = PARTS.split('|').collect();
    let many = *random.pick(&[1, 1, 1, 2, 3]);
    (0..many).map(|_| *random.pick(&parts)).collect()
}

/// The contract that a worksheet of this text and name comes to.
fn contract(file: &str, text: &str) -> Contract {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(file);
    std::fs::write(&path, text).unwrap();
    let sheet = Family::sheet(&path).unwrap_or_else(|error| panic!("{text}: {error}"));
    assert!(sheet.error.as_ref().is_none_or(|error| !error.is_of_file()), "{text}: {:?}", sheet.error);
    sheet.family.contract
}

fn unique<'a>(names: impl Iterator<Item = &'a str>, of: &str, text: &str) {
    let mut seen = BTreeSet::new();
    for name in names {
        assert!(seen.insert(name), "two {of} are called {name}: {text}");
    }
}

/// What must hold of all names of a worksheet.
fn judge(contract: &Contract, text: &str) {
    for name in
        contract.kernels.iter().map(|kernel| &kernel.name).chain(contract.inputs.values().map(|input| &input.name))
    {
        assert_eq!(rust_name(name), Ok(()), "{name}: {text}");
    }
    unique(contract.kernels.iter().map(|kernel| kernel.name.as_str()), "kernels", text);
    unique(contract.inputs.values().map(|input| input.name.as_str()), "inputs", text);
    unique(contract.kernels.iter().filter_map(|kernel| kernel.returns.as_deref()), "structs", text);
    for kernel in &contract.kernels {
        unique(kernel.results.iter().map(|result| result.name.as_str()), "fields", text);
        let is_type = |name: &str| name.starts_with(|c: char| c.is_ascii_uppercase()) && name.is_ascii();
        assert!(kernel.returns.as_deref().is_none_or(is_type), "{:?}: {text}", kernel.returns);
        for result in &kernel.results {
            assert_eq!(rust_name(&result.name), Ok(()), "{}: {text}", result.name);
        }
    }
}

#[test]
fn every_name_is_one_of_kernels_inputs_and_fields() {
    let mut random = Random::new(1);
    let drawn: Vec<String> = (0..300).map(|_| name(&mut random)).collect();
    for name in PARTS.split('|').map(str::to_owned).chain(drawn) {
        for text in [
            format!("{name}(other_input) := other_input^2+1$"),
            format!("{name}: other_input^2+1$"),
            format!("other_kernel({name}) := {name}^2+1$"),
            format!("other_kernel: 2*{name}+1$"),
            format!("other_kernel(y) := [{name} = y+1, z = y*2]$"),
        ] {
            let contract = contract("names.mac", &text);
            assert_eq!(contract.kernels.len(), 1, "{text}");
            judge(&contract, &text);
        }
    }
}

#[test]
fn names_that_become_the_same_are_told_apart() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let mut text = String::new();
        for _ in 0..6 {
            let (kernel, one, other, free) =
                (name(&mut random), name(&mut random), name(&mut random), name(&mut random));
            text += &match random.below(4) {
                0 => format!("{kernel}: {one}+2*{other}^2-{free}$ "),
                1 => format!("{kernel}: [{one}+1, 3*{other}]$ "),
                2 => format!("{kernel}(p,q) := [{one} = p+q, {other} = p*q]$ "),
                _ if one == other => format!("{kernel}({one}) := {one}+{free}$ "),
                _ => format!("{kernel}({one},{other}) := {one}*{other}+{free}$ "),
            };
        }
        judge(&contract("names.mac", &text), &text);
    }
    let alike = "aB(x) := x+1$ ab(x) := x+2$ a_b(x) := x+3$ AB(x,X) := x+4*X$ a_B: x_1+X_1+x1$";
    let contract = contract("alike.mac", alike);
    assert_eq!(contract.kernels.len(), 5);
    judge(&contract, alike);
}

#[test]
fn every_file_name_gives_a_module() {
    let mut random = Random::new(7);
    for _ in 0..2000 {
        let stem: String = (0..1 + random.below(4))
            .map(|_| format!("{}{}", name(&mut random), random.pick(&[" ", "-", ".", ""])))
            .collect();
        let module = free_module_name(&stem);
        assert_eq!(rust_name(&module), Ok(()), "{stem}");
        assert!(!is_device(&module) && module.len() <= 64, "{stem}");
    }
}
