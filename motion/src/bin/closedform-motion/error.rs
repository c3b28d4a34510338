//! What goes wrong: one line that says cause, place and remedy, and the exit code.

use std::path::Path;

use closedform_motion::PlanError;
use closedform_motion::plan::milling::gcode::GcodeError;
use closedform_motion::plot::PlotError;
use closedform_motion::table::TableError;

/// Why the command stops.
#[derive(Debug)]
pub enum Failure {
    /// The input is at fault: exit code 2.
    Input(String),
    /// Anything else: exit code 1.
    Other(String),
}

/// The result of all commands.
pub type Outcome<T> = Result<T, Failure>;

impl Failure {
    /// The line to print.
    pub fn message(&self) -> &str {
        match self {
            Self::Input(message) | Self::Other(message) => message,
        }
    }

    /// What the process returns.
    pub fn code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Other(_) => 1,
        }
    }

    /// The same, with the file it is about.
    pub fn at(self, path: &Path) -> Self {
        let place = |message: String| format!("{}: {message}", path.display());
        match self {
            Self::Input(message) => Self::Input(place(message)),
            Self::Other(message) => Self::Other(place(message)),
        }
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Other(error.to_string())
    }
}

impl From<PlanError> for Failure {
    fn from(error: PlanError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<GcodeError> for Failure {
    fn from(error: GcodeError) -> Self {
        match error {
            GcodeError::Read { .. } => Self::Other(error.to_string()),
            _ => Self::Input(error.to_string()),
        }
    }
}

impl From<TableError> for Failure {
    fn from(error: TableError) -> Self {
        match error {
            TableError::Io(_) => Self::Other(error.to_string()),
            _ => Self::Input(error.to_string()),
        }
    }
}

impl From<PlotError> for Failure {
    fn from(error: PlotError) -> Self {
        match error {
            PlotError::Io(_) => Self::Other(error.to_string()),
            _ => Self::Input(error.to_string()),
        }
    }
}
