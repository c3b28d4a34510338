//! Kernels need neither the standard library nor a way to panic: proved by building them.

use std::path::Path;

use closedform_tests::bare::{self, Bare};

/// What kernels may call that is not theirs: every target of Rust has them.
const PROVIDED: [&str; 3] = ["memcpy", "memmove", "memset"];

#[test]
fn kernels_are_bare() {
    let bare = bare::build(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("bare"));
    for name in ["closedform", "closedform_kernels"] {
        assert!(bare.crates.contains(&(name.to_owned(), true)), "{name} has features: {:?}", bare.crates);
    }
    let complaints: Vec<String> = bare::functions().iter().flat_map(|function| complaints(&bare, function)).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    // No proof unless a panic would have been found.
    assert!(foreign(&bare, bare::PANICS).iter().any(|way| way.contains("panic")), "panics have another name");
}

/// The ways from a function of the crate out of it.
fn foreign(bare: &Bare, function: &str) -> Vec<String> {
    let ending = format!("{}{function}", function.len());
    let mut symbols = bare.assembly.symbols().filter(|symbol| symbol.ends_with(&ending));
    let symbol = symbols.next().unwrap_or_else(|| panic!("`{function}` is not in the assembly"));
    let foreign = bare.assembly.foreign(symbol).into_iter();
    foreign.filter(|(name, _)| !PROVIDED.contains(name)).map(|(_, way)| way.join(" -> ")).collect()
}

fn complaints(bare: &Bare, function: &str) -> Vec<String> {
    foreign(bare, function).iter().map(|way| format!("{function}: {way}")).collect()
}
