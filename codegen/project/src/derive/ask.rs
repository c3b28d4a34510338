//! What Maxima is asked of a family, and the text of the references that it answers with.

use super::driver::{self, Task};
use super::error::DeriveError;
use super::reply::Reply;
use crate::contract::Contract;
use crate::family::Paths;
use crate::layout::Limits;
use crate::maxima_process::Maxima;
use closedform_system::limit::LimitError;

/// How golden values are made.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Options {
    /// Which Maxima.
    pub maxima: Maxima,
    /// Points a kernel.
    pub points: usize,
    /// Seed of the points.
    pub seed: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self { maxima: Maxima::default(), points: 24, seed: 0x636c_6f73_6564 }
    }
}

impl Options {
    /// The usual ones, within the limits of the environment or of a project.
    ///
    /// # Errors
    ///
    /// When the environment says no limit.
    pub fn within(limits: &Limits) -> Result<Self, LimitError> {
        Ok(Self { maxima: Maxima::within(limits)?, ..Self::default() })
    }
}

/// Runs the worksheet, and asks for the references and some values.
pub(super) fn ask(paths: &Paths, contract: &Contract, tasks: &[Task], options: &Options) -> Result<Reply, DeriveError> {
    let messages = options.maxima.run(&paths.worksheet, &driver::driver(contract, tasks))?;
    Ok(Reply::read(messages))
}

/// The text of the references.
pub(super) fn reference_text(
    name: &str,
    reply: &Reply,
    contract: &Contract,
    paths: &Paths,
) -> Result<String, DeriveError> {
    let header = header(name, "reference expressions", &reply.version, "/* ", " */");
    Ok(header + reply.references(contract, paths)?.as_str())
}

/// How a file of a family begins.
pub(super) fn header(name: &str, what: &str, version: &str, open: &str, close: &str) -> String {
    format!(
        "{open}{what}, written by `closedform derive {name}` from {name}.mac and {name}.toml; do not edit{close}\n\
         {open}Maxima {version}{close}\n"
    )
}
