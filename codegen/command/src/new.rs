//! `closedform new`: a project that builds, tests and checks at once, with one derivation to replace.

use crate::own_crate::{self, Runtime};
use clap::Args as ClapArgs;
use closedform_project::Project;
use closedform_system::output;
use std::path::PathBuf;

/// Make a new project: a worksheet, its contract, the crate of its kernels, a recipe for CI
#[derive(Debug, ClapArgs)]
pub struct Args {
    /// The folder of the project: a new or an empty one
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Where its crate takes the runtime from: `version`, the URL of a git repository, or a folder [default: the folder
    /// that this command was built from, as a relative path]
    #[arg(long, value_name = "WHERE")]
    runtime: Option<Runtime>,
}

/// Makes the project, or nothing.
///
/// # Errors
///
/// When the folder holds something, or cannot be written.
pub fn run(args: &Args) -> miette::Result<()> {
    let notes = own_crate::start(&args.folder, &args.runtime.clone().unwrap_or_default())?;
    notes.iter().for_each(|note| output::note(note));
    let project = Project::at(&args.folder)?;
    output::tell(&format!(
        "a project in {folder}\n\
         \x20 {worksheets}  the derivation: replace it by yours, then\n\
         \x20     closedform derive      lets Maxima run it\n\
         \x20     closedform generate    makes and proves the kernels\n\
         \x20     cargo test             judges them\n\
         \x20 make check runs what CI runs\n",
        folder = args.folder.display(),
        worksheets = project.shown(&project.worksheets.join("braking.mac")),
    ))?;
    Ok(())
}
