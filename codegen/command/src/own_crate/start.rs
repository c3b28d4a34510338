//! A new project: the example's files, and those that are written around them.

use std::fs;
use std::path::Path;

use super::place;
use super::runtime::{BUILD, RUNTIME};
use super::{OwnCrateError, Runtime, name, text, workspace};
use crate::schema;

/// What is made of the example's worksheet, for the crate and for the project; a test makes them anew.
const CRATE: [(&str, &str); 4] = [
    ("src/generated/braking.rs", include_str!("../../example/generated/braking.rs")),
    ("src/generated/braking.tsv", include_str!("../../example/generated/braking.tsv")),
    ("src/generated/judges.rs", include_str!("../../example/generated/judges.rs")),
    ("src/generated/mod.rs", include_str!("../../example/generated/mod.rs")),
];
const PROJECT: [(&str, &str); 5] = [
    ("maxima-ref/braking.mac", include_str!("../../example/braking.mac")),
    ("maxima-ref/braking.ref", include_str!("../../example/braking.ref")),
    ("maxima-ref/braking.toml", include_str!("../../example/braking.toml")),
    ("maxima-ref/braking.tsv", include_str!("../../example/braking.tsv")),
    ("records/LEDGER.csv", include_str!("../../example/LEDGER.csv")),
];

/// What editors check its TOML files by; the first lines of those name them.
const SCHEMAS: [(&str, &str); 2] =
    [("schema/contract.schema.json", schema::CONTRACT), ("schema/project.schema.json", schema::PROJECT)];

/// How the project is laid out.
struct Layout {
    /// The folder of the crate, from the project's.
    kernels: &'static str,
    /// The way back.
    worksheets: &'static str,
}

/// In a workspace, the project is a crate that the workspace may hold; elsewhere it is a workspace that holds one.
const MEMBER: Layout = Layout { kernels: ".", worksheets: "maxima-ref" };
const WHOLE: Layout = Layout { kernels: "kernels", worksheets: "../maxima-ref" };

/// Writes a new project; returns what the user should know.
///
/// # Errors
///
/// When the folder is not new or empty, or cannot be written.
pub fn start(folder: &Path, runtime: &Runtime) -> miette::Result<Vec<String>> {
    if folder.is_file() {
        return Err(OwnCrateError::File(folder.to_owned()).into());
    }
    if !place::is_empty(folder)? {
        return Err(OwnCrateError::NotEmpty(folder.to_owned()).into());
    }
    fs::create_dir_all(folder).map_err(|cause| OwnCrateError::write(folder, cause))?;
    let name = name::package(folder)?;
    let enclosing = workspace::enclosing(folder);
    let layout = if enclosing.is_some() { MEMBER } else { WHOLE };
    let kernels = folder.join(layout.kernels);
    fs::create_dir_all(&kernels).map_err(|cause| OwnCrateError::write(&kernels, cause))?;
    let [library, build] = [RUNTIME, BUILD].map(|part| runtime.dependency(&part, &kernels, Path::new("")));
    let manifest = text::manifest(&name.package, &library?, enclosing.as_ref());
    let build = format!("\n[build-dependencies]\nclosedform-build = {}\n", build?);
    place::create(&kernels, "Cargo.toml", &text::with_table(&manifest, &build))?;
    place::create(&kernels, "build.rs", &text::build_script(layout.worksheets))?;
    place::create(&kernels, "src/lib.rs", text::LIBRARY)?;
    for (path, text) in CRATE {
        place::create(&kernels, path, text)?;
    }
    for (path, text) in PROJECT {
        place::create(folder, path, text)?;
    }
    if enclosing.is_none() {
        place::create(folder, "Cargo.toml", text::WORKSPACE)?;
    }
    for (path, text) in SCHEMAS {
        place::create(folder, path, text)?;
    }
    place::create(folder, "README.md", &text::project_readme(&name.package))?;
    place::create(folder, "Makefile", text::MAKEFILE)?;
    place::create(folder, ".github/workflows/kernels.yml", &text::workflow(&runtime.install()))?;
    place::create(folder, ".gitignore", text::IGNORE)?;
    // last: what it stands in is a project, and whole
    place::create(folder, "closedform.toml", &text::project(layout.kernels))?;
    Ok(name.note().into_iter().chain(enclosing.as_ref().and_then(workspace::Enclosing::note)).collect())
}
