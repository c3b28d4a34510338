//! The list of mutants that are the same function for a reason that no program here finds.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use serde::Deserialize;

use super::error::MutateError;
use super::exam::Outcome;
use super::place::Change;
use closedform_project::ReadError;

/// Where the list stands below the root of a project.
const PATH: &str = "tests/EQUIVALENT.toml";

/// The list.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equivalents {
    #[serde(default)]
    equivalent: Vec<Entry>,
}

/// Mutants of one statement that are the same function for one reason.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    kernel: String,
    was: String,
    is: Vec<String>,
    /// Whether it leaves a branch out that is never taken: mutants of that branch are the same function too.
    #[serde(default)]
    unreached: bool,
    reason: String,
}

/// An entry whose mutant is gone, or killed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unneeded {
    /// The kernel.
    pub kernel: String,
    /// The statement of the kernel.
    pub was: String,
    /// The statement of the mutant.
    pub is: String,
}

impl Equivalents {
    /// The list of a project; empty where it has none.
    ///
    /// # Errors
    ///
    /// When it cannot be read.
    pub fn load(root: &Path) -> Result<Self, MutateError> {
        let path = root.join(PATH);
        match fs::read_to_string(&path) {
            Ok(text) => Self::parse(&text).map_err(|cause| MutateError::Equivalents { path, cause: cause.into() }),
            Err(cause) if cause.kind() == ErrorKind::NotFound => Ok(Self::default()),
            Err(cause) => {
                let remedy = "make it readable, or name another folder with --root".to_owned();
                Err(ReadError { path, cause, remedy }.into())
            }
        }
    }

    fn parse(text: &str) -> Result<Self, toml::de::Error> {
        toml::from_str(text)
    }

    /// Why a mutant is the same function, if the list says so.
    pub fn reason(&self, kernel: &str, change: &Change) -> Option<&str> {
        self.entry(kernel, change).map(|entry| entry.reason.as_str())
    }

    fn entry(&self, kernel: &str, change: &Change) -> Option<&Entry> {
        let of_statement = self.equivalent.iter().filter(|entry| entry.kernel == kernel && entry.was == change.was);
        { of_statement }.find(|entry| entry.is.contains(&change.is))
    }

    /// Whether a mutant leaves out what is never reached, as the list says.
    pub fn is_unreached(&self, kernel: &str, change: &Change) -> bool {
        self.entry(kernel, change).is_some_and(|entry| entry.unreached)
    }

    /// What the list says beyond the mutants that survived, of kernels that were judged, and of all others if `every`
    /// kernel was.
    pub fn unneeded(&self, outcomes: &[Outcome], every: bool) -> Vec<Unneeded> {
        let judged = |entry: &&Entry| every || outcomes.iter().any(|outcome| outcome.kernel == entry.kernel);
        let listed = self.equivalent.iter().filter(judged);
        let listed = listed.flat_map(|entry| entry.is.iter().map(|is| unneeded(&entry.kernel, &entry.was, is)));
        let survived = |listed: &Unneeded| {
            let own = outcomes.iter().filter(|outcome| outcome.kernel == listed.kernel);
            { own }.any(|outcome| outcome.survivors().any(|change| change.was == listed.was && change.is == listed.is))
        };
        listed.filter(|listed| !survived(listed)).collect()
    }
}

fn unneeded(kernel: &str, was: &str, is: &str) -> Unneeded {
    Unneeded { kernel: kernel.to_owned(), was: was.to_owned(), is: is.to_owned() }
}
