//! `closedform plan` and `closedform plot`: handed on to the command `closedform-motion`.
//!
//! It is a command of its own, because who plans moves shall not have to build what derives formulas.

use miette::{Diagnostic, IntoDiagnostic};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use thiserror::Error;

/// The other command.
const PROGRAM: &str = "closedform-motion";

/// How it learns that it was handed on to: its help then names the command that was typed.
const HANDS_ON: &str = "CLOSEDFORM_HANDS_ON";

/// What stands behind `plan` or `plot`: the other command's arguments, `--help` among them.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Args {
    /// The kind of move, and what is known of it; `--help` shows all
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

/// Why nothing can be handed on.
#[derive(Debug, Error, Diagnostic)]
enum MotionError {
    /// It is nowhere.
    #[error("the command `{PROGRAM}` is not installed")]
    #[diagnostic(help(
        "run `cargo install --path motion` in a checkout of closedform, or put it beside `closedform` or on the PATH"
    ))]
    Missing,
}

/// Runs `closedform-motion` with the command's name and its arguments; its exit code is the answer.
///
/// # Errors
///
/// When it is neither beside this command, nor on the path, nor to be built in the project `root`.
pub fn run(name: &str, args: &Args, root: &Path) -> miette::Result<ExitCode> {
    let mut command = found().or_else(|| built_in(root)).ok_or(MotionError::Missing)?;
    let status = command.env(HANDS_ON, "1").arg(name).args(&args.arguments).status().into_diagnostic()?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}

/// Beside this command, or on the path.
fn found() -> Option<Command> {
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let own = std::env::current_exe().ok();
    let beside = own.as_deref().and_then(Path::parent).map(Path::to_owned);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = beside.into_iter().chain(std::env::split_paths(&path));
    folders.map(|folder: PathBuf| folder.join(&name)).find(|file| file.is_file()).map(Command::new)
}

/// By cargo, where its source is.
fn built_in(root: &Path) -> Option<Command> {
    let manifest = root.join("motion/Cargo.toml");
    manifest.is_file().then(|| {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["run", "--quiet", "--manifest-path"]).arg(manifest).arg("--");
        cargo
    })
}
