//! The list of mutants that are the same function for a reason that no program here finds.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use serde::de::{Deserialize, Deserializer, Error as _};

use super::error::MutateError;
use super::exam::Outcome;
use super::mistake::{Mistake, Nth};
use super::place::Change;
use closedform_project::ReadError;

/// The list's file, among the records of a project.
const FILE: &str = "EQUIVALENT.toml";

/// The list.
#[derive(Clone, Debug, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equivalents {
    #[serde(default)]
    equivalent: Vec<Entry>,
}

/// Mutants of one step that are the same function for one reason.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    kernel: String,
    step: String,
    mistakes: Vec<String>,
    /// Whether they leave branches out that are never taken: mutants of these are the same function too.
    #[serde(default)]
    unreached: bool,
    #[serde(deserialize_with = "reason")]
    reason: String,
}

/// Words: what nobody has given a reason for is not on the list.
fn reason<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let reason = String::deserialize(deserializer)?;
    let has_words = reason.contains(char::is_alphabetic);
    if has_words { Ok(reason) } else { Err(D::Error::custom("write down why the results are the same")) }
}

impl Entry {
    fn mistakes(&self) -> impl Iterator<Item = Mistake> + '_ {
        self.mistakes.iter().map(|kind| Mistake { step: self.step.clone(), kind: Nth::parse(kind) })
    }

    fn is_about(&self, kernel: &str, change: &Change) -> bool {
        let named = || self.mistakes().any(|mistake| mistake == change.mistake);
        self.kernel == kernel && self.unreached == change.unreached && named()
    }
}

/// An entry whose mutant is gone, or killed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unneeded {
    /// The kernel.
    pub kernel: String,
    /// The mistake.
    pub mistake: Mistake,
}

impl Equivalents {
    /// Where the list is among the records of a project.
    #[must_use]
    pub fn path(records: &Path) -> PathBuf {
        records.join(FILE)
    }

    /// The list among the records of a project; empty where they have none.
    ///
    /// # Errors
    ///
    /// When it cannot be read.
    pub fn load(records: &Path) -> Result<Self, MutateError> {
        let path = Self::path(records);
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
        let entry = self.equivalent.iter().find(|entry| entry.is_about(kernel, change));
        entry.map(|entry| entry.reason.as_str())
    }

    /// The mistakes of a kernel that leave out what is never reached, each one made in what those before it leave.
    pub fn unreached(&self, kernel: &str) -> impl Iterator<Item = Mistake> {
        let entries = self.equivalent.iter().filter(move |entry| entry.unreached && entry.kernel == kernel);
        entries.flat_map(Entry::mistakes)
    }

    /// What the list says beyond the mutants that survived, of kernels that were judged, and of all others if `every`
    /// kernel was.
    pub fn unneeded(&self, outcomes: &[Outcome], every: bool) -> Vec<Unneeded> {
        let judged = |entry: &&Entry| every || outcomes.iter().any(|outcome| outcome.kernel == entry.kernel);
        let listed = self.equivalent.iter().filter(judged);
        let listed = listed.flat_map(|entry| entry.mistakes().map(move |mistake| (entry, mistake)));
        let survived = |entry: &Entry, mistake: &Mistake| {
            let own = outcomes.iter().filter(|outcome| outcome.kernel == entry.kernel);
            let mut survivors = own.flat_map(Outcome::survivors);
            survivors.any(|change| change.unreached == entry.unreached && change.mistake == *mistake)
        };
        let unneeded = listed.filter(|(entry, mistake)| !survived(entry, mistake));
        unneeded.map(|(entry, mistake)| Unneeded { kernel: entry.kernel.clone(), mistake }).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exam::Verdict;

    const LIST: &str = "
[[equivalent]]
kernel = 'a::f'
step = 'let root'
mistakes = ['>= as >', 'number doubled #2']
reason = 'r'

[[equivalent]]
kernel = 'a::f'
step = 'result'
mistakes = ['first branch alone']
unreached = true
reason = 'u'
";

    fn change(step: &str, kind: &str, unreached: bool) -> Change {
        let mistake = Mistake { step: step.to_owned(), kind: Nth::parse(kind) };
        Change { unreached, ..Change::new(1, mistake, String::new(), String::new()) }
    }

    #[test]
    fn an_entry_has_a_reason() {
        for none in ["", "..", " "] {
            let error = Equivalents::parse(&LIST.replace("reason = 'r'", &format!("reason = '{none}'"))).unwrap_err();
            assert!(error.message().contains("why the results are the same") && error.span().is_some(), "{error}");
        }
    }

    #[test]
    fn mutants_are_found_by_kernel_step_and_mistake() {
        let list = Equivalents::parse(LIST).unwrap();
        assert_eq!(list.reason("a::f", &change("let root", "number doubled #2", false)), Some("r"));
        for (kernel, step, kind, unreached) in [
            ("a::g", "let root", ">= as >", false),
            ("a::f", "result", ">= as >", false),
            ("a::f", "let root", "number doubled", false),
            ("a::f", "let root", ">= as >", true),
            ("a::f", "result", "first branch alone", false),
        ] {
            assert_eq!(list.reason(kernel, &change(step, kind, unreached)), None, "{kernel} {step} {kind}");
        }
        let unreached: Vec<String> = list.unreached("a::f").map(|mistake| mistake.to_string()).collect();
        assert_eq!(unreached, ["result, first branch alone"]);
        assert_eq!(list.unreached("a::g").count(), 0);
    }

    #[test]
    fn what_did_not_survive_is_not_needed() {
        let list = Equivalents::parse(LIST).unwrap();
        let outcome = |verdict| Outcome {
            kernel: "a::f".to_owned(),
            mutants: vec![
                (change("let root", ">= as >", false), Verdict::Survived),
                (change("let root", "number doubled #2", false), verdict),
                (change("result", "first branch alone", true), Verdict::Survived),
            ],
        };
        let unneeded = |outcomes: &[Outcome], every: bool| -> Vec<String> {
            list.unneeded(outcomes, every).iter().map(|entry| entry.mistake.to_string()).collect()
        };
        assert_eq!(unneeded(&[outcome(Verdict::Survived)], false), [""; 0]);
        assert_eq!(unneeded(&[outcome(Verdict::Killed)], false), ["let root, number doubled #2"]);
        assert_eq!(unneeded(&[], false), [""; 0]);
        assert_eq!(unneeded(&[], true).len(), 3);
    }

    #[test]
    fn entries_by_text_are_refused() {
        let by_text = "[[equivalent]]\nkernel = 'a::f'\nwas = 'x'\nis = ['y']\nreason = 'r'\n";
        assert!(Equivalents::parse(by_text).is_err());
    }
}
