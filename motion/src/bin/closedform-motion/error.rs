//! What goes wrong: one line that says cause, place and remedy.

use std::path::Path;

use closedform_motion::PlanError;
use closedform_motion::plan::milling::gcode::GcodeError;
use closedform_motion::plot::PlotError;
use closedform_motion::table::TableError;

/// Why the command stops.
#[derive(Debug)]
pub struct Failure(pub String);

/// The result of all commands.
pub type Outcome<T> = Result<T, Failure>;

impl Failure {
    /// The line to print.
    pub fn message(&self) -> &str {
        &self.0
    }

    /// The same, with the file it is about.
    pub fn at(self, path: &Path) -> Self {
        Self(format!("{}: {}", path.display(), self.0))
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self(error.to_string())
    }
}

impl From<PlanError> for Failure {
    fn from(error: PlanError) -> Self {
        // what it is about is a field, whose flag has dashes
        let said = error.to_string();
        let (about, is) = said.split_at(said.find(" is ").unwrap_or(0));
        Self(about.replace('_', "-") + is)
    }
}

impl From<GcodeError> for Failure {
    fn from(error: GcodeError) -> Self {
        Self(error.to_string())
    }
}

impl From<TableError> for Failure {
    fn from(error: TableError) -> Self {
        Self(error.to_string())
    }
}

impl From<PlotError> for Failure {
    fn from(error: PlotError) -> Self {
        Self(error.to_string())
    }
}
