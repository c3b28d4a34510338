//! C: a crate that builds a static and a shared library, their header, files for CMake and pkg-config, examples, C99 source.

mod about;
mod build;
mod example;
mod header;
mod names;
mod rust;
mod source;
mod text;

use crate::error::BindError;
use crate::library::Library;
use crate::tree::Tree;
use closedform_system::way::way;
use names::Names;
use std::path::Path;

/// The language, as the command names it.
pub const LANGUAGE: &str = "c";

const RUST: (&str, &str) = ("// ", "");
const C: (&str, &str) = ("/* ", " */");
const HASH: (&str, &str) = ("# ", "");

/// The files of the binding, to be written to the folder `out`, from where the crate of the kernels is looked for.
///
/// # Errors
///
/// When two things would have one name in C.
pub fn tree(library: &Library, out: &Path) -> Result<Tree, BindError> {
    let names = Names::new(library)?;
    let kernels = way(out, &library.package.folder);
    let mut tree = Tree::default();
    let mut add = |path: &str, comment, text: &str| tree.add(LANGUAGE, path, comment, text);
    add("Cargo.toml", HASH, &build::manifest(&library.package, &names, &kernels));
    add("CMakeLists.txt", HASH, &build::cmake(&names));
    add(&format!("{}.pc", names.library), HASH, &build::pkg_config(&library.package, &names));
    add(&format!("include/{}.h", names.prefix), C, &header::header(library, &names));
    add("src/lib.rs", RUST, &rust::library(library, &names));
    add("src/about.rs", RUST, &about::about(library));
    add("src/boundary.rs", RUST, include_str!("../../template/c/boundary.rs"));
    add("src/export.rs", RUST, include_str!("../../template/c/export.rs"));
    add("src/info.rs", RUST, include_str!("../../template/c/info.rs"));
    add("examples/record.c", C, &example::record(library, &names));
    add("examples/controller.c", C, &example::controller(library, &names));
    add(&format!("c99/{}_tier1.h", names.prefix), C, &source::header(library, &names));
    add(&format!("c99/{}_tier1.c", names.prefix), C, &source::source(library, &names));
    add("c99/arithmetic.h", C, &source::arithmetic(&names));
    Ok(tree)
}
