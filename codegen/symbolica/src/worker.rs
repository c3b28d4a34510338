//! The generator at work: it generates or proves, says how far it is, and ends with the command that asked.

use crate::ALGEBRA;
use closedform_generator::pipeline::{PipelineError, all, generate, generate_what_can_be, kernels_refused, unproved};
use closedform_project::derive::{DeriveError, Options, rederive};
use closedform_project::family::{Family, FamilyError, families};
use closedform_project::generated::{Generated, Word, would_be_fine};
use closedform_project::layout::Limits;
use closedform_system::limit::LimitError;
use miette::Diagnostic;
use rustix::process::{Signal, getpid, kill_process};
use std::collections::BTreeSet;
use std::io;
use std::os::unix::process::parent_id;
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, thread};
use thiserror::Error;

/// What is to be done.
#[derive(Clone, Debug)]
pub enum Task {
    /// All families of a folder are generated.
    Folder(PathBuf),
    /// One worksheet is generated.
    Worksheet {
        /// The worksheet.
        worksheet: PathBuf,
        /// The module that its kernels stand in.
        module: String,
        /// Whether nothing of it may be left out.
        strict: bool,
        /// Kernels that are not tried.
        except: BTreeSet<String>,
    },
    /// Nothing is generated: the kernels of a folder are proved equal to what Maxima derives from the worksheets of another.
    Rederived {
        /// The worksheets.
        folder: PathBuf,
        /// The kernels.
        kernels: PathBuf,
    },
}

/// Why it is not done.
#[derive(Debug, Error, Diagnostic)]
pub enum WorkError {
    /// A file cannot be read, or the command not be told.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The families are wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Family(#[from] FamilyError),
    /// A worksheet cannot be run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Derive(#[from] DeriveError),
    /// How long a worksheet may run is not said.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Limit(#[from] LimitError),
    /// Kernels are no longer what the worksheets derive.
    #[error("{}", all(.0))]
    #[diagnostic(help(
        "the worksheet derives something else than the checked-in reference: if the worksheet is right, run `closedform \
         derive` and `closedform generate`"
    ))]
    Changed(Vec<PipelineError>),
    /// Kernels cannot be made.
    #[error("{}\n{}", all(causes), would_be_fine(*fine))]
    Pipeline {
        /// Why not.
        causes: Vec<PipelineError>,
        /// How many others can be made.
        fine: usize,
    },
}

/// Generates, and sends the result.
///
/// # Errors
/// When a family is wrong, or a kernel cannot be made or proved.
pub fn work(task: &Task, parent: u32) -> Result<(), WorkError> {
    thread::spawn(move || end_with(parent));
    let generated = match task {
        Task::Folder(folder) => generated(&families(folder)?, true)?,
        // the command has said what is wrong with the formulas that are not there
        Task::Worksheet { worksheet, module, strict, except } => {
            let family = Family { name: module.clone(), ..Family::sheet(worksheet)?.family };
            generated(&[family.without(except)], *strict)?
        }
        Task::Rederived { folder, kernels } => {
            rederived(folder, kernels)?;
            Generated::default()
        }
    };
    Ok(Word::Made(generated).send()?)
}

/// A command that was killed has nobody to stop its worker, which would keep others waiting.
fn end_with(parent: u32) {
    while parent_id() == parent {
        thread::sleep(Duration::from_millis(100));
    }
    _ = kill_process(getpid(), Signal::KILL);
}

fn generated(families: &[Family], strict: bool) -> Result<Generated, WorkError> {
    let kernels = families.iter().map(|family| family.contract.kernels.len()).sum();
    Word::Kernels(kernels).send()?;
    let made = match strict {
        true => generate(ALGEBRA, families, begun),
        false => generate_what_can_be(ALGEBRA, families, begun),
    };
    made.map_err(|causes| {
        let fine = kernels.saturating_sub(kernels_refused(&causes));
        WorkError::Pipeline { causes, fine }
    })
}

/// Proves the kernels as checked in equal to what the worksheets derive now.
fn rederived(folder: &Path, kernels: &Path) -> Result<(), WorkError> {
    let mut families = families(folder)?;
    let options = Options::within(&Limits::default())?; // the command has put the limit of its project into the environment
    for family in &mut families {
        begun(&family.name, &family.paths.worksheet.to_string_lossy());
        family.references = rederive(folder, &family.name, &options)?;
    }
    let mut causes = Vec::new();
    for family in &families {
        let text = fs::read_to_string(kernels.join(format!("{}.rs", family.name)))?;
        causes.extend(unproved(ALGEBRA, family, &text, begun));
    }
    if causes.is_empty() { Ok(()) } else { Err(WorkError::Changed(causes)) }
}

/// If nobody listens, the worker ends anyway.
fn begun(what: &str, place: &str) {
    _ = Word::begun(what, place).send();
}
