//! What can go wrong while a worksheet runs.

use std::time::Duration;

use closedform_system::limit::MAXIMA;
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::script::ScriptError;
use super::super::source::Text;
use super::guard::Reaching;

/// Why Maxima did not derive anything.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ProcessError {
    /// The worksheet cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Script(#[from] ScriptError),
    /// The worksheet wants more than to compute.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Reaching(#[from] Box<Reaching>),
    /// Maxima did not even start.
    #[error("cannot run Maxima (`{program}`): {cause}")]
    #[diagnostic(help("{}", cause.remedy()))]
    Lost {
        /// The program.
        program: String,
        /// Why.
        cause: LostMaxima,
    },
    /// The last statement has no end.
    #[error("the worksheet's last statement does not end")]
    #[diagnostic(help("end it with `$` or `;`, and close its strings and comments"))]
    Unended {
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("no `$` or `;` follows")]
        place: SourceSpan,
    },
    /// Maxima asked a question.
    #[error("Maxima asks: {question}")]
    #[diagnostic(help("{remedy}"))]
    Asked {
        /// Statements that answer it, and where to put them.
        remedy: String,
        /// What Maxima wants to know.
        question: String,
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("this statement asks")]
        place: Option<SourceSpan>,
    },
    /// A statement failed.
    #[error("Maxima stops: {message}")]
    #[diagnostic(help("run `maxima -b` on the worksheet to see what led to it"))]
    Failed {
        /// What Maxima printed.
        message: String,
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("this statement fails")]
        place: Option<SourceSpan>,
    },
    /// The worksheet takes too long.
    #[error("Maxima did not finish {used}")]
    #[diagnostic(help("{}", used.remedy()))]
    OutOfTime {
        /// What it has used.
        used: Used,
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("still running")]
        place: Option<SourceSpan>,
    },
    /// The worksheet prints without end.
    #[error("the worksheet prints without end")]
    #[diagnostic(help("look for a loop that never ends, or print less"))]
    TooMuchOutput {
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("still printing")]
        place: Option<SourceSpan>,
    },
    /// The worksheet ended Maxima.
    #[error("the worksheet ends Maxima before its functions can be read")]
    #[diagnostic(help("remove quit() and whatever else ends Maxima; a batch file ends by itself"))]
    Quit {
        /// The worksheet.
        #[source_code]
        text: Text,
        /// The statement; none if a function of the worksheet was being applied.
        #[label("Maxima ends here")]
        place: Option<SourceSpan>,
    },
}

/// The time that was too much.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Used {
    /// All the processor time that it may use.
    #[error("in {} s of processor time", limit.as_secs_f64())]
    Processor {
        /// That time.
        limit: Duration,
    },
    /// Hardly any, but it goes on and on.
    #[error("in {} s, of which it used {} s of processor time", elapsed.as_secs(), processor.as_secs())]
    Waiting {
        /// How long.
        elapsed: Duration,
        /// What it used.
        processor: Duration,
    },
    /// The system does not tell what it used.
    #[error("in {} s", limit.as_secs_f64())]
    Elapsed {
        /// How long it could run.
        limit: Duration,
    },
}

impl Used {
    fn remedy(&self) -> String {
        match self {
            Self::Waiting { .. } => "remove from the worksheet what sleeps or waits for something".to_owned(),
            _ => format!(
                "simplify the statement, or look for a loop that never ends; `closedform derive --limit`, {} sets how many \
                 seconds of processor time a worksheet may use",
                MAXIMA.setting()
            ),
        }
    }
}

/// Why there was no Maxima.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LostMaxima {
    /// No such program.
    #[error("there is no such program")]
    Missing,
    /// It cannot be started.
    #[error("{0}")]
    Start(std::io::Error),
    /// Temporary files cannot be written.
    #[error("cannot write temporary files: {0}")]
    Files(std::io::Error),
    /// The operating system lost it.
    #[error("cannot wait for it: {0}")]
    Wait(std::io::Error),
    /// It ended with an error of its own.
    #[error("it ended with {status} and printed: {printed}")]
    Died {
        /// How.
        status: std::process::ExitStatus,
        /// Its last words.
        printed: String,
    },
}

impl LostMaxima {
    fn remedy(&self) -> &'static str {
        match self {
            Self::Missing => {
                "install it, e.g. apt-get install maxima maxima-share, or name the program in the environment variable CLOSEDFORM_MAXIMA"
            }
            Self::Files(_) => "make room in the folder for temporary files (TMPDIR)",
            _ => "run `maxima --version` to see whether Maxima itself works",
        }
    }
}
