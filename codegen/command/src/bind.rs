//! `closedform bind`: the kernels of the project in another language.

use clap::{Args as ClapArgs, Subcommand};
use closedform_bind::{Library, c};
use closedform_measure::catalogue::Catalogue;
use closedform_project::Project;
use closedform_system::output;
use std::path::PathBuf;

/// Write what another language needs to call the kernels of the project
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  closedform bind c                   a library for C in bindings/c of the project
  closedform bind c --out ../robot    the same in another folder
  closedform --root my-kernels bind c for a crate that `generate --input` made")]
pub struct Args {
    #[command(subcommand)]
    language: Language,
}

#[derive(Debug, Subcommand)]
enum Language {
    /// C: a crate that builds a static and a shared library, their header, C99 source, files for CMake and pkg-config, examples
    C {
        /// The folder to write to; files in it that others wrote stay as they are [default: bindings/c of the project]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
}

/// Writes the files of one language.
///
/// # Errors
///
/// When there are no kernels that others can call, two of them would have one name, or files cannot be written.
pub fn run(args: &Args, project: &Project) -> miette::Result<()> {
    let library = Library::new(project, &Catalogue::open(project)?)?;
    let Language::C { out } = &args.language;
    let out = out.clone().unwrap_or_else(|| project.root.join("bindings").join(c::LANGUAGE));
    let tree = c::tree(&library, &out)?;
    let changed = tree.write(&out)?;
    output::print(&format!(
        "{} kernels of {} for C in {}: {} files, {changed} changed\n\
         \x20 cargo build --release --manifest-path {}\n\
         \x20     builds the static and the shared library; c99/ needs a C compiler only\n",
        library.kernels.len(),
        library.package.name,
        out.display(),
        tree.paths().count(),
        out.join("Cargo.toml").display(),
    ))?;
    Ok(())
}
