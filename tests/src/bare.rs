//! A crate that calls every kernel in every shape, built in release without the standard library.

use std::path::Path;
use std::process::Command;
use std::{fs, iter};

use closedform::Info;

use crate::assembly::Assembly;
use crate::{kernels, workspace};

/// The function of the crate that can panic.
pub const PANICS: &str = "takes_any_index";

/// The function of the crate that reaches the table of kernels.
pub const TABLE: &str = "table";

/// The crate's assembly, and that of all crates below it.
#[derive(Debug)]
pub struct Bare {
    /// The crates by name, and whether they were built without features.
    pub crates: Vec<(String, bool)>,
    /// What the compiler made of them.
    pub assembly: Assembly,
}

/// The functions of the crate that must be there and must not panic.
pub fn functions() -> Vec<String> {
    let of_kernel = |info: &Info| Shape::ALL.map(|shape| shape.function(info));
    kernels::all().flat_map(|kernel| of_kernel(kernel.info)).chain([TABLE.to_owned()]).collect()
}

/// Builds the crate in `folder`.
///
/// # Panics
///
/// It does not build.
pub fn build(folder: &Path) -> Bare {
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    };
    fs::create_dir_all(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let kernels = workspace::root().join("kernels");
    write("Cargo.toml", &MANIFEST.replace("KERNELS", &format!("{:?}", kernels.display().to_string())));
    // The versions that the workspace builds with.
    write("Cargo.lock", &fs::read_to_string(workspace::root().join("Cargo.lock")).expect("Cargo.lock can be read"));
    write("lib.rs", &source());
    read(&folder.join("target"), &compile(folder))
}

const MANIFEST: &str = r#"[package]
name = "bare"
edition = "2024"

[lib]
path = "lib.rs"

[dependencies]
closedform-kernels = { path = KERNELS, default-features = false }

[workspace]
"#;

/// The messages of cargo about what it built.
fn compile(folder: &Path) -> String {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--offline", "--quiet", "--message-format", "json"]);
    // With a target, flags are for it alone: not for the macro and what it is built from.
    cargo.args(["--target", &host()]).arg("--target-dir").arg(folder.join("target"));
    cargo.arg("--manifest-path").arg(folder.join("Cargo.toml"));
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.env("RUSTFLAGS", "--emit=asm -Ccodegen-units=1 -Csymbol-mangling-version=v0");
    workspace::output(&mut cargo)
}

/// The machine that runs this.
fn host() -> String {
    let version = workspace::output(Command::new(env!("CARGO")).arg("-vV"));
    version.lines().find_map(|line| line.strip_prefix("host: ")).expect("cargo names its host").to_owned()
}

/// Reads the assembly that lies beside every library for the target.
fn read(target: &Path, messages: &str) -> Bare {
    let mut bare = Bare { crates: Vec::new(), assembly: Assembly::default() };
    let libraries = target.join(host()).join("release/deps/lib");
    let libraries = libraries.to_str().expect("a path in UTF-8");
    for message in messages.lines() {
        let library = message.split('"').find_map(|file| file.strip_prefix(libraries)?.strip_suffix(".rmeta"));
        let Some(library) = library else { continue };
        let path = target.join(host()).join(format!("release/deps/{library}.s"));
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let name = library.rsplit_once('-').map_or(library, |(name, _)| name);
        bare.crates.push((name.to_owned(), message.contains(r#""features":[]"#)));
        bare.assembly.read(name, &text);
    }
    bare
}

/// What calls by rows are given.
const ROWS: &str = "rows: &[Inputs], results: &mut [Results]";

/// The ways to call a kernel.
#[derive(Clone, Copy)]
enum Shape {
    Default,
    Checked,
    Faithful,
    Fast,
    WithBound,
    Batch,
    FastBatch,
    Single,
    Named,
    Rows,
    FastRows,
}

impl Shape {
    const ALL: [Self; 11] = [
        Self::Default,
        Self::Checked,
        Self::Faithful,
        Self::Fast,
        Self::WithBound,
        Self::Batch,
        Self::FastBatch,
        Self::Single,
        Self::Named,
        Self::Rows,
        Self::FastRows,
    ];

    fn function(self, info: &Info) -> String {
        let name = info.name.replace("::", "_");
        match self {
            Self::Default => format!("default_{name}"),
            Self::Checked => format!("checked_{name}"),
            Self::Faithful => format!("faithful_{name}"),
            Self::Fast => format!("fast_{name}"),
            Self::WithBound => format!("with_bound_{name}"),
            Self::Batch => format!("batch_{name}"),
            Self::FastBatch => format!("fast_batch_{name}"),
            Self::Single => format!("single_{name}"),
            Self::Named => format!("named_{name}"),
            Self::Rows => format!("rows_{name}"),
            Self::FastRows => format!("fast_rows_{name}"),
        }
    }

    /// The function that makes this call of the kernel by its structs.
    fn of_records(self, info: &Info, declared: &str, call: &str) -> String {
        let (kernel, function) = (format!("closedform_kernels::{}", info.name), self.function(info));
        let declared = declared.replace("Inputs", &format!("{kernel}::Inputs"));
        let declared = declared.replace("Results", &format!("{kernel}::Results"));
        let call = call.replace("kernel", &kernel);
        format!("#[inline(never)]\npub fn {function}({declared}) {{\n    let _ = black_box({call});\n}}\n\n")
    }

    fn text(self, info: &Info) -> String {
        let (kernel, function) = (info.name, self.function(info));
        let names = |prefix: char, count: usize| (0..count).map(move |i| format!("{prefix}{i}"));
        let (inputs, results) = (names('x', info.inputs.len()), names('y', info.results.len()));
        let (kind, path) = match self {
            Self::Default => ("f64", ""),
            Self::Checked => ("f64", "::checked"),
            Self::Faithful => ("f64", "::faithful"),
            Self::Fast => ("f64", "::fast"),
            Self::WithBound => ("f64", "::with_bound"),
            Self::Batch => ("&[f64]", "::batch"),
            Self::FastBatch => ("&[f64]", "::fast_batch"),
            Self::Single => ("f32", "::f32"),
            Self::Named => return self.of_records(info, "inputs: Inputs", "inputs.call()"),
            Self::Rows => return self.of_records(info, ROWS, "kernel::rows(rows, results)"),
            Self::FastRows => return self.of_records(info, ROWS, "kernel::fast_rows(rows, results)"),
        };
        let results =
            results.filter(|_| matches!(self, Self::Batch | Self::FastBatch)).map(|name| (name, "&mut [f64]"));
        let parameters: Vec<(String, &str)> = inputs.zip(iter::repeat(kind)).chain(results).collect();
        let declared: String = parameters.iter().map(|(name, kind)| format!("{name}: {kind}, ")).collect();
        let given: String = parameters.iter().map(|(name, _)| format!("{name}, ")).collect();
        let call = format!("closedform_kernels::{kernel}{path}({given})");
        format!("#[inline(never)]\npub fn {function}({declared}) {{\n    let _ = black_box({call});\n}}\n\n")
    }
}

fn source() -> String {
    let calls: String = kernels::all().flat_map(|kernel| Shape::ALL.map(|shape| shape.text(kernel.info))).collect();
    format!(
        "#![no_std]\n#![allow(clippy::all)]\n\nuse core::hint::black_box;\n\n{calls}\
         #[inline(never)]\npub fn {TABLE}() {{\n    black_box(&closedform_kernels::ALL);\n}}\n\n\
         #[inline(never)]\npub fn {PANICS}(values: &[f64], index: usize) -> f64 {{\n    values[index]\n}}\n"
    )
}
