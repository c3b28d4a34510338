//! `closedform completions SHELL` and `closedform man DIR`: what shells and readers of manuals want to know of the command.

use std::io::{self, Write};
use std::path::PathBuf;

use clap_complete::Shell;
use closedform_system::output;
use miette::miette;

/// Print the completions of a shell: put them where that shell looks for them
#[derive(Debug, clap::Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// Write the manual pages of this command and its parts, one file each
#[derive(Debug, clap::Args)]
pub struct Man {
    /// The folder, such as share/man/man1 of an installation
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Prints the completions of a command.
///
/// # Errors
///
/// When they cannot be written.
pub fn print(args: &Completions, mut command: clap::Command) -> miette::Result<()> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command, "closedform", &mut text);
    output::unless_closed(io::stdout().write_all(&text).and_then(|()| io::stdout().flush()))?;
    Ok(())
}

/// Writes the pages of a command.
///
/// # Errors
///
/// When they cannot be written.
pub fn write_manual(args: &Man, command: clap::Command) -> miette::Result<()> {
    let written = std::fs::create_dir_all(&args.folder).and_then(|()| clap_mangen::generate_to(command, &args.folder));
    written.map_err(|cause| {
        miette!(
            help = "name a folder that can be written",
            "cannot write manual pages to {}: {cause}",
            args.folder.display()
        )
    })
}
