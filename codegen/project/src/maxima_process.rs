//! Maxima as a process: a worksheet is run as `maxima -b` runs it, then a driver prints what is wanted of it.

mod child;
mod error;
mod guard;
mod question;
mod transcript;
mod watch;

use std::ffi::OsString;
use std::path::Path;
use std::time::Duration;

pub use error::{LostMaxima, ProcessError, Used};
pub use guard::Reaching;
pub(crate) use guard::reaching;
pub use transcript::Message;

use super::beside::beside;
use super::layout::Limits;
use super::script::Script;
use super::statements::statements;
use closedform_system::limit::{self, LimitError};
use closedform_system::scratch::Folder;

/// How many times as long it may take, with whatever else the machine does.
const PATIENCE: u32 = 20;

/// The environment variable that names another Maxima.
pub const PROGRAM_VARIABLE: &str = "CLOSEDFORM_MAXIMA";

/// Which Maxima runs worksheets, and for how long.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Maxima {
    /// The program.
    pub program: OsString,
    /// How much processor time worksheet and driver may use together; how long they may take, where the system does not tell
    /// what they use.
    pub limit: Duration,
    /// Whether a worksheet may start programs, touch files and run Lisp.
    pub allow_system: bool,
}

/// The environment variable that allows it, to processes of ours; the flag `--allow-system` sets it.
pub const ALLOW_SYSTEM_VARIABLE: &str = "CLOSEDFORM_ALLOW_SYSTEM";

impl Default for Maxima {
    /// `maxima`, or what `CLOSEDFORM_MAXIMA` names, within the usual limit.
    fn default() -> Self {
        let program = std::env::var_os(PROGRAM_VARIABLE).unwrap_or_else(|| "maxima".into());
        let allow_system = std::env::var_os(ALLOW_SYSTEM_VARIABLE).is_some();
        Self { program, limit: Duration::from_secs(limit::MAXIMA.usual), allow_system }
    }
}

impl Maxima {
    /// The usual one, within the limit of the environment or of a project.
    ///
    /// # Errors
    ///
    /// When the environment says something else than a number of seconds.
    pub fn within(limits: &Limits) -> Result<Self, LimitError> {
        let seconds = limit::MAXIMA.seconds(limits.maxima)?;
        Ok(Self { limit: Duration::from_secs(seconds), ..Self::default() })
    }

    /// Runs the worksheet, then the driver: Maxima statements that call `closedform_say(text)` to send a message.
    /// Nothing is written outside a temporary folder, unless the worksheet may and does.
    pub fn run(&self, worksheet: &Path, driver: &str) -> Result<Vec<Message>, ProcessError> {
        self.run_script(&Script::load(worksheet)?, worksheet, driver)
    }

    /// As [`run`](Self::run), of the text of the worksheet.
    pub(crate) fn run_script(
        &self,
        script: &Script,
        worksheet: &Path,
        driver: &str,
    ) -> Result<Vec<Message>, ProcessError> {
        let beside = beside(worksheet, script.text());
        if !self.allow_system {
            guard::check(script, &beside)?;
        }
        let marks = Marks::new();
        let places = places(script)?;
        let folder = Folder::new().map_err(|cause| self.lost(LostMaxima::Files(cause)))?;
        let files = Files::new(folder.path());
        let written =
            files.write(script.text(), driver, &marks, &guard::Allowed { system: self.allow_system, beside: &beside });
        written.map_err(|cause| self.lost(LostMaxima::Files(cause)))?;
        let home = worksheet.parent().filter(|home| !home.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let end = child::run(self, &files.arguments(), home, &marks, places.len()).map_err(|cause| self.lost(cause))?;
        transcript::read(&end, &marks).map_err(|failure| failure.at(script, &places))
    }

    /// How long a run may take that uses hardly any processor time.
    fn patience(&self) -> Duration {
        self.limit.saturating_mul(PATIENCE)
    }

    fn lost(&self, cause: LostMaxima) -> ProcessError {
        ProcessError::Lost { program: self.program.to_string_lossy().into_owned(), cause }
    }
}

/// The places of the statements, if the last one ends.
fn places(script: &Script) -> Result<Vec<std::ops::Range<usize>>, ProcessError> {
    let statements = statements(script.text());
    match statements.last().filter(|last| !last.ended) {
        Some(last) => Err(ProcessError::Unended { text: script.shown(), place: last.place.clone().into() }),
        None => Ok(statements.into_iter().map(|statement| statement.place).collect()),
    }
}

/// Texts that only our own output contains, so that nothing a worksheet prints is mistaken for ours.
struct Marks {
    /// Begins what is printed before each statement.
    statement: String,
    /// Begins a question.
    question: String,
    /// Begins a message of the driver.
    message: String,
}

impl Marks {
    fn new() -> Self {
        use std::hash::{BuildHasher, RandomState};
        let nonce = RandomState::new().hash_one(std::process::id());
        let mark = |what: &str| format!("<closedform {what} {nonce:016x}>");
        Self { statement: mark("statement"), question: mark("question"), message: mark("message") }
    }
}

/// The files that one run needs.
struct Files {
    /// Lisp that Maxima loads first.
    marks: std::path::PathBuf,
    /// The worksheet, then a statement that loads the driver.
    batch: std::path::PathBuf,
    /// The driver.
    driver: std::path::PathBuf,
}

impl Files {
    fn new(folder: &Path) -> Self {
        Self {
            marks: folder.join("marks.lisp"),
            batch: folder.join("worksheet.mac"),
            driver: folder.join("driver.mac"),
        }
    }

    fn write(&self, worksheet: &str, driver: &str, marks: &Marks, allowed: &guard::Allowed) -> std::io::Result<()> {
        let Marks { statement, question, message } = marks;
        // the variables with which a front end tells prompts and questions from results
        let lisp = format!("(setq *general-display-prefix* \"{statement}\" *prompt-prefix* \"{question}\")\n");
        let guard = guard::lisp(message, &self.driver, &self.batch, allowed);
        std::fs::write(&self.marks, format!("{lisp}{guard}"))?;
        std::fs::write(&self.batch, format!("{worksheet}\nload({:?})$\n", self.driver.display().to_string()))?;
        std::fs::write(&self.driver, format!("{SETTINGS}{driver}\nclosedform_say(\"{}\")$\n", transcript::END))
    }

    /// No initialisation file: what a worksheet derives may not depend on whose machine it is.
    fn arguments(&self) -> Vec<OsString> {
        let option = |name: &str, path: &Path| [OsString::from(name), path.into()];
        let init = ["--init=closedform-reads-no-init-file".into()];
        init.into_iter().chain(option("-p", &self.marks)).chain(option("-b", &self.batch)).collect()
    }
}

/// Whatever the worksheet chose, the driver prints whole expressions with all digits, and computes exactly.
const SETTINGS: &str = "display2d: false$ fpprintprec: 0$ obase: 10$ ratprint: false$ numer: false$ float: false$ \
                        keepfloat: false$ bftorat: false$ simp: true$ sqrtdispflag: true$ exptdispflag: true$ \
                        noundisp: false$\n";
