//! What users document: an application with kernels of its own gets pages without a warning, formulas and links in them.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use closedform_tests::workspace;

const MANIFEST: &str = r#"[package]
name = "user-application"
edition = "2024"

[lib]
path = "lib.rs"

[dependencies]
closedform = { path = "RUNTIME", default-features = false }

[workspace]
"#;

/// Names that are keywords, or those of what the macro makes; formulas that are known, and one that is not.
const LIBRARY: &str = r##"//! An application.
#![deny(missing_docs)]

use closedform::{Record, kernel};

/// Leg of a right triangle.
///
/// By *Pythagoras*.
#[kernel(
    latex = "l = \\sqrt{c^{2}-a^{2}} \\\\ \\frac{a_{1,\\mathrm{Max}}}{2} < 1",
    result(unit = "m"),
    example(path = "leg", inputs(5.0, 3.0), results(4.0))
)]
pub fn leg(
    /// Length of the longest side
    #[input(unit = "m")]
    hypotenuse: f64,
    #[input(maxima = "a", unit = "m*s")] other: f64,
) -> f64 {
    sqrt(hypotenuse * hypotenuse - other * other)
}

/// Two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Record)]
pub struct Pair {
    /// One.
    pub sum: f64,
    /// The other.
    pub r#type: f64,
}

/// A keyword.
#[kernel(latex = "\\unknown{x}")]
pub fn r#type(r#in: f64, inputs: f64, call: f64) -> Pair {
    Pair { sum: r#in + inputs, r#type: call }
}

/// Named like its own input.
#[kernel]
pub fn inputs(inputs: f64) -> f64 {
    inputs
}

/// Named like a method.
#[kernel]
pub fn call(checked: f64) -> f64 {
    checked
}

/// Named like a function of the module.
#[kernel]
pub fn rows(rows: f64) -> f64 {
    rows
}

/// A module whose kernels nobody sees.
mod inner {
    use closedform::kernel;

    #[kernel]
    pub(crate) fn undocumented(x: f64) -> f64 {
        x
    }
}

/// Calls it.
pub fn calls(x: f64) -> f64 {
    inner::undocumented(x)
}
"##;

/// Runs cargo in the folder of the application, by the versions that the workspace builds with; every warning is an error.
fn cargo(folder: &Path, arguments: &[&str]) {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(arguments).args(["--offline", "--quiet"]).arg("--target-dir").arg(folder.join("target"));
    cargo.arg("--manifest-path").arg(folder.join("Cargo.toml"));
    cargo.env("RUSTDOCFLAGS", "--deny warnings").env("RUSTFLAGS", "--deny warnings");
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    workspace::output(&mut cargo);
}

#[test]
fn an_application_is_documented_without_a_warning() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("documented");
    let runtime = workspace::root().join("runtime").display().to_string();
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("Cargo.toml"), MANIFEST.replace("RUNTIME", &runtime)).unwrap();
    fs::write(folder.join("Cargo.lock"), fs::read_to_string(workspace::root().join("Cargo.lock")).unwrap()).unwrap();
    fs::write(folder.join("lib.rs"), LIBRARY).unwrap();
    cargo(&folder, &["doc", "--no-deps"]);
    cargo(&folder, &["test", "--doc"]);
    let page = |name: &str| fs::read_to_string(folder.join("target/doc/user_application").join(name)).unwrap();
    let leg = page("fn.leg.html");
    for part in [
        "<msqrt><mrow><msup><mi>c</mi>",
        "<mo>&lt;</mo>",
        "href=\"leg/struct.Inputs.html\"",
        "href=\"leg/index.html\"",
        "href=\"leg/fn.rows.html\"",
        "By <em>Pythagoras</em>",
    ] {
        assert!(leg.contains(part), "{part} is not on the page:\n{leg}");
    }
    let inputs = page("leg/struct.Inputs.html");
    for part in ["In m: Length of the longest side.", "In the worksheet <code>a</code>.", "href=\"../fn.leg.html\""] {
        assert!(inputs.contains(part), "{part} is not on the page:\n{inputs}");
    }
    let keyword = page("fn.type.html");
    assert!(!keyword.contains("<math") && keyword.contains("href=\"type/struct.Inputs.html\""), "{keyword}");
}
