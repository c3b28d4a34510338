//! The generator as a process of its own, for everything that needs Symbolica.
//!
//! Symbolica without a licence key prints its notice on standard output and aborts the process if another one of the machine
//! uses it. The command therefore starts the program `closedform-symbolica` when it is its turn, hands the notice on to
//! standard error, and tells an abort of Symbolica, after which it tries again, from a crash, which is a mistake.

mod attempt;

use crate::program::{GENERATOR, ProgramError};
use attempt::{Ending, attempt};
use closedform_project::family::{Family, FamilyError, Sheet, WorksheetError, families};
use closedform_project::generated::{Begun, Generated, Refused, would_be_fine};
use closedform_project::layout::Limits;
use closedform_project::maxima_process::Maxima;
use closedform_system::limit::{KERNEL, LimitError, WAIT};
use closedform_system::output::{note, warn};
use closedform_system::turn::{Patience, Turn, TurnError};
use miette::{Diagnostic, Report};
use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use std::time::Duration;
use thiserror::Error;

/// What is to be generated.
#[derive(Clone, Debug)]
pub enum Source {
    /// All families of a folder.
    Folder(PathBuf),
    /// One worksheet.
    Worksheet {
        /// The file.
        worksheet: PathBuf,
        /// The module that its kernels stand in.
        module: String,
        /// Whether nothing of it may be left out.
        strict: bool,
        /// Kernels that are not tried.
        except: BTreeSet<String>,
    },
    /// Nothing: the kernels of a folder are proved equal to what Maxima derives from the worksheets of another one.
    Rederived {
        /// The worksheets.
        folder: PathBuf,
        /// The kernels.
        kernels: PathBuf,
        /// What the worksheets may do.
        maxima: Maxima,
    },
}

/// Why the worker gave no result.
#[derive(Debug, Error, Diagnostic)]
pub enum WorkerError {
    /// The process could not be started or not be heard.
    #[error("cannot run the algebra in a process of its own: {0}")]
    #[diagnostic(help("end other programs if the machine has no more processes or memory"))]
    Io(#[from] io::Error),
    /// It has said why.
    #[error("nothing was generated")]
    Failed,
    /// Some formulas of a worksheet are wrong, which has been said; the others were tried.
    #[error("nothing was generated: formulas of the worksheet are refused; {}", would_be_fine(*fine))]
    #[diagnostic(help("correct the formulas that are named above, or take them out of the worksheet"))]
    Refused {
        /// How many kernels can be made.
        fine: usize,
    },
    /// Some statements of a worksheet are passed over, which is not wanted.
    #[error("nothing was generated: {passed_over} {} of the worksheet would be passed over", if *passed_over == 1 { "statement" } else { "statements" })]
    #[diagnostic(help("take out what is named above, or leave out --strict"))]
    PassedOver {
        /// How many.
        passed_over: usize,
    },
    /// Symbolica runs elsewhere.
    #[error("Symbolica is in use on this machine by a program that does not share the lock of closedform")]
    #[diagnostic(help(
        "without a licence key Symbolica runs once a machine, containers and other temporary folders included: end that \
         program, set {} to more seconds than the {seconds} that this command has waited, or set SYMBOLICA_LICENSE",
        WAIT.setting()
    ))]
    Elsewhere {
        /// How long was waited.
        seconds: u64,
    },
    /// It was ended by a signal, or by a panic.
    #[error("{begun}the algebra crashed ({status}): nothing was generated")]
    #[diagnostic(help(
        "this is a mistake of the generator, or the machine lacks memory: what was said last stands above. Split the \
         formula into smaller ones, and please report it together with its worksheet and contract"
    ))]
    Crashed {
        /// What it worked at.
        begun: Last,
        /// How it ended.
        status: ExitStatus,
    },
    /// It took too long.
    #[error("{begun}not made in {limit} s of processor time: nothing was generated")]
    #[diagnostic(help(
        "split the formula into smaller ones or say more of its signs in a contract's `domain`; {} sets how many seconds \
         one kernel may take",
        KERNEL.setting()
    ))]
    OutOfTime {
        /// What it worked at.
        begun: Last,
        /// How long it could take.
        limit: u64,
    },
    /// The limit is no number.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Limit(#[from] LimitError),
    /// The families are wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Family(#[from] FamilyError),
    /// The lock is taken.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Turn(#[from] TurnError),
    /// There is no generator.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Program(#[from] ProgramError),
}

/// What the worker began last, if it came to that.
#[derive(Debug)]
pub struct Last(Option<Begun>);

impl Display for Last {
    /// As it stands before what became of it.
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match &self.0 {
            Some(Begun { what, place }) if place.is_empty() => write!(f, "`{what}`: "),
            Some(Begun { what, place }) => write!(f, "{place}: `{what}`: "),
            None => f.write_str("before the first kernel: "),
        }
    }
}

/// How long to leave Symbolica to others before another attempt.
const PAUSE: Duration = Duration::from_secs(1);

/// Generates in a process of its own, when it is its turn.
///
/// # Errors
/// When the source is wrong, it is not our turn in time, or that process fails; it has then said why on standard error.
pub fn run(source: &Source, limits: &Limits) -> Result<Generated, WorkerError> {
    made_of(source, source.check()?, limits)
}

/// As [`run`], of a source that is known to be right: it is not read before it is our turn.
///
/// # Errors
/// As of [`run`].
pub fn run_checked(source: &Source, limits: &Limits) -> Result<Generated, WorkerError> {
    made(source, limits)
}

/// As [`run`], of a worksheet, of which every formula and statement that is passed over is named; with `strict` nothing
/// may be passed over.
///
/// # Errors
/// As of [`run`], and when nothing is left, or something is passed over that must not be.
pub fn run_sheet(worksheet: &Path, module: &str, strict: bool, limits: &Limits) -> Result<Generated, WorkerError> {
    let source = |strict| {
        let (worksheet, module) = (worksheet.to_owned(), module.to_owned());
        Source::Worksheet { worksheet, module, strict, except: BTreeSet::new() }
    };
    let Sheet { family, error, summary } = Family::sheet(worksheet)?;
    let nothing = family.contract.kernels.is_empty();
    match error {
        Some(error) if nothing => Err(FamilyError::from(error).into()),
        Some(error) if strict || error.is_of_file() => made_of(&source(true), Some(error), limits),
        _ => {
            summary.lines.iter().for_each(|line| note(line));
            match summary.passed.len() {
                passed_over @ 1.. if strict => Err(WorkerError::PassedOver { passed_over }),
                _ => made(&source(strict), limits),
            }
        }
    }
}

fn made_of(source: &Source, refused: Option<WorksheetError>, limits: &Limits) -> Result<Generated, WorkerError> {
    let Some(refused) = refused else { return made(source, limits) };
    // the other formulas are tried all the same, so that one run tells everything
    warn(&format!("{:?}", Report::new(refused)));
    Err(WorkerError::Refused { fine: made(source, limits)?.kernels.len() })
}

/// What can be made. Of a worksheet a kernel that the generator is not done with in time, or at which it crashes, is left
/// out.
fn made(source: &Source, limits: &Limits) -> Result<Generated, WorkerError> {
    let mut source = source.clone();
    let mut refused = Vec::new();
    loop {
        let error = match made_at_once(&source, limits) {
            Ok(mut generated) => {
                generated.refused.extend(refused);
                return Ok(generated);
            }
            Err(error) => error,
        };
        let Some(kernel) = error.about().and_then(|kernel| source.leave_out(kernel)) else { return Err(error) };
        refused.push(Refused { kernel, because: error.to_string() });
    }
}

fn made_at_once(source: &Source, limits: &Limits) -> Result<Generated, WorkerError> {
    let limit = KERNEL.seconds(limits.kernel)?;
    let generator = GENERATOR.find()?;
    let patience = Patience::of(limits.wait)?;
    let turn = Turn::take(&patience, note)?;
    let mut tried = false;
    loop {
        match attempt(&generator, source, &turn, limit, tried)? {
            Ending::Made(mut generated) => {
                generated.stamp(source.worksheets())?;
                return Ok(generated);
            }
            Ending::Refused if patience.wait(PAUSE) => {}
            Ending::Refused => return Err(WorkerError::Elsewhere { seconds: patience.seconds() }),
        }
        if !tried {
            let seconds = patience.seconds();
            note(&format!("waiting for a program that uses Symbolica elsewhere on this machine, {seconds} s at most"));
        }
        tried = true;
    }
}

impl WorkerError {
    /// The kernel that stopped the generator, if one did.
    fn about(&self) -> Option<&str> {
        match self {
            Self::Crashed { begun, .. } | Self::OutOfTime { begun, .. } => Some(&begun.0.as_ref()?.what),
            _ => None,
        }
    }
}

impl Source {
    /// Leaves out a kernel of a worksheet, `module::kernel`, unless nothing may be left out, or it is left out already.
    fn leave_out(&mut self, kernel: &str) -> Option<String> {
        let Self::Worksheet { module, strict: false, except, .. } = self else { return None };
        let name = kernel.strip_prefix(module.as_str())?.strip_prefix("::")?;
        except.insert(name.to_owned()).then(|| kernel.to_owned())
    }

    /// The folder of the worksheets.
    fn worksheets(&self) -> &Path {
        match self {
            Self::Worksheet { worksheet, .. } => worksheet.parent().unwrap_or(Path::new("")),
            Self::Folder(folder) | Self::Rederived { folder, .. } => folder,
        }
    }

    /// What is wrong is better said before waiting for others than after: what of a worksheet is, if something else is right.
    fn check(&self) -> Result<Option<WorksheetError>, FamilyError> {
        match self {
            Self::Worksheet { worksheet, .. } => match Family::sheet(worksheet)? {
                Sheet { family, error: Some(error), .. } if family.contract.kernels.is_empty() => Err(error.into()),
                Sheet { error, .. } => Ok(error),
            },
            Self::Folder(folder) | Self::Rederived { folder, .. } => families(folder).map(|_| None),
        }
    }
}
