//! The worker: a process of its own for everything that needs Symbolica.
//!
//! Symbolica without a licence key prints its notice on standard output and may abort the process. The command therefore
//! starts itself once more, hands the notice on to standard error, and turns an abort into an error.

use crate::algebra::{Turn, TurnError};
use crate::pipeline::{Generated, PipelineError, all, generate, unproved};
use crate::worksheet::derive::{DeriveError, Options, rederive};
use crate::worksheet::family::{Family, FamilyError, families};
use crate::worksheet::maxima_process::ALLOW_SYSTEM_VARIABLE;
use indicatif::{ProgressBar, ProgressStyle};
use miette::Diagnostic;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{fs, io};
use thiserror::Error;

/// What is to be generated.
#[derive(Clone, Debug)]
pub enum Source {
    /// All families of a folder.
    Folder(PathBuf),
    /// One worksheet.
    Worksheet(PathBuf),
    /// Nothing: the kernels of a folder are proved equal to what Maxima derives from the worksheets of another one.
    Rederived {
        /// The worksheets.
        folder: PathBuf,
        /// The kernels.
        kernels: PathBuf,
        /// Whether the worksheets may start programs, touch files and run Lisp.
        allow_system: bool,
    },
}

/// Why the worker gave no result.
#[derive(Debug, Error, Diagnostic)]
pub enum WorkerError {
    /// The process could not be started or its result not be read.
    #[error("cannot run the algebra in a process of its own: {0}")]
    #[diagnostic(help("make the folder for temporary files writable, or point TMPDIR to one that is"))]
    Io(#[from] io::Error),
    /// It has said why.
    #[error("nothing was generated")]
    Failed,
    /// It was ended by a signal.
    #[error("Symbolica ended the process: nothing was generated")]
    #[diagnostic(help(
        "without a licence key Symbolica runs once a machine, and another program that uses it seems to run: end that \
         one, or set SYMBOLICA_LICENSE"
    ))]
    Aborted,
    /// The families are wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Family(#[from] FamilyError),
    /// The lock is taken.
    #[error(transparent)]
    Turn(#[from] TurnError),
    /// A worksheet cannot be run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Derive(#[from] DeriveError),
    /// Kernels are no longer what the worksheets derive.
    #[error("{}", all(.0))]
    #[diagnostic(help(
        "the worksheet derives something else than the checked-in reference: if the worksheet is right, run `closedform \
         derive` and `closedform generate`"
    ))]
    Changed(Vec<PipelineError>),
    /// Kernels cannot be made.
    #[error("{}", all(.0))]
    Pipeline(Vec<PipelineError>),
}

/// The name of the subcommand that does the work.
pub const SUBCOMMAND: &str = "algebra-worker";

/// Generates in a process of its own.
///
/// # Errors
/// When that process fails; it has then said why on standard error.
pub fn run(source: &Source) -> Result<Generated, WorkerError> {
    let output = tempfile::Builder::new().prefix("closedform-").suffix(".json").tempfile()?;
    let mut command = Command::new(std::env::current_exe()?);
    command.arg(SUBCOMMAND).arg(output.path());
    match source {
        Source::Folder(folder) => command.arg("--folder").arg(folder),
        Source::Worksheet(worksheet) => command.arg("--worksheet").arg(worksheet),
        Source::Rederived { folder, kernels, allow_system } => {
            if *allow_system {
                command.env(ALLOW_SYSTEM_VARIABLE, "1");
            }
            command.arg("--folder").arg(folder).arg("--kernels").arg(kernels)
        }
    };
    let status = command.stdin(Stdio::null()).stdout(Stdio::from(io::stderr())).status()?;
    match status.code() {
        Some(0) => Ok(serde_json::from_slice(&fs::read(output.path())?).map_err(io::Error::from)?),
        Some(1) => Err(WorkerError::Failed),
        _ => Err(WorkerError::Aborted),
    }
}

/// What that process does: generates and writes the result to a file.
///
/// # Errors
/// When a family is wrong, the lock is taken, or a kernel cannot be made or proved.
pub fn work(source: &Source, output: &Path) -> Result<(), WorkerError> {
    let generated = match source {
        Source::Folder(folder) => generated(&families(folder)?)?,
        Source::Worksheet(worksheet) => generated(&[Family::from_worksheet(worksheet)?])?,
        Source::Rederived { folder, kernels, .. } => {
            rederived(folder, kernels)?;
            Generated::default()
        }
    };
    fs::write(output, serde_json::to_vec(&generated).map_err(io::Error::from)?)?;
    Ok(())
}

fn generated(families: &[Family]) -> Result<Generated, WorkerError> {
    let _turn = Turn::take()?;
    let bar = progress_bar(families.iter().map(|family| family.contract.kernels.len()).sum());
    let generated = generate(families, |kernel| {
        bar.set_message(kernel.to_owned());
        bar.inc(1);
    })
    .map_err(WorkerError::Pipeline)?;
    bar.finish_and_clear();
    Ok(generated)
}

/// Proves the kernels as checked in equal to what the worksheets derive now.
fn rederived(folder: &Path, kernels: &Path) -> Result<(), WorkerError> {
    let mut families = families(folder)?;
    for family in &mut families {
        family.references = rederive(folder, &family.name, &Options::default())?;
    }
    let _turn = Turn::take()?;
    let mut causes = Vec::new();
    for family in &families {
        let text = fs::read_to_string(kernels.join(format!("{}.rs", family.name)))?;
        causes.extend(unproved(family, &text));
    }
    if causes.is_empty() { Ok(()) } else { Err(WorkerError::Changed(causes)) }
}

/// A bar on standard error; indicatif hides it where that is no terminal.
fn progress_bar(kernels: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    let bar = ProgressBar::new(kernels as u64);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
