//! `closedform plan` and `closedform plot`: handed on to the command `closedform-motion`.
//!
//! It is a command of its own, because who plans moves shall not have to build what derives formulas.

use crate::program::MOTION;
use miette::IntoDiagnostic;
use std::ffi::OsString;
use std::process::{Command, ExitCode};

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

/// Runs `closedform-motion` with the command's name and its arguments; its exit code is the answer.
///
/// # Errors
///
/// When it is neither beside this command, nor on the path, nor in the checkout that this command was built in.
pub fn run(name: &str, args: &Args) -> miette::Result<ExitCode> {
    let status =
        Command::new(MOTION.find()?).env(HANDS_ON, "1").arg(name).args(&args.arguments).status().into_diagnostic()?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
