//! What the driver said, sorted.

use super::super::contract::{Contract, KernelContract};
use super::super::family::Paths;
use super::super::maxima_process::Message;
use super::decimal;
use super::error::{DeriveError, PointFailure};

/// All messages of one run.
pub(super) struct Reply {
    /// Maxima's version.
    pub(super) version: String,
    messages: Vec<Message>,
}

impl Reply {
    pub(super) fn read(messages: Vec<Message>) -> Self {
        let version = messages.iter().find_map(|message| message.text.strip_prefix("version|"));
        Self { version: version.unwrap_or("of unknown version").to_owned(), messages }
    }

    /// The text of the reference expressions, one definition a line.
    pub(super) fn references(&self, contract: &Contract, paths: &Paths) -> Result<String, DeriveError> {
        contract.results().map(|(kernel, result)| self.reference(kernel, &result.worksheet, paths)).collect()
    }

    fn reference(&self, kernel: &KernelContract, worksheet: &str, paths: &Paths) -> Result<String, DeriveError> {
        let undefined = || DeriveError::Undefined {
            worksheet: worksheet.to_owned(),
            kernel: kernel.name.clone(),
            inputs: kernel.inputs.join(","),
            path: paths.worksheet.clone(),
        };
        let (head, _) = self.about("head", worksheet).filter(|(head, _)| !head.is_empty()).ok_or_else(undefined)?;
        let promised = format!("{worksheet}({})", kernel.inputs.join(","));
        if head != promised {
            let path = paths.worksheet.clone();
            return Err(DeriveError::Parameters { found: head.to_owned(), promised, path });
        }
        match self.about("reference", worksheet) {
            Some((expression, [])) if !expression.is_empty() => Ok(format!("{promised}:={expression}$\n")),
            Some(("", noise)) => Err(DeriveError::Application { function: promised, message: noise.join(" ") }),
            Some((_, noise)) => Err(DeriveError::Printed { function: promised, printed: noise.join(" ") }),
            None => Err(undefined()),
        }
    }

    /// What was said under this word of a function, and what was printed before.
    fn about(&self, word: &str, worksheet: &str) -> Option<(&str, &[String])> {
        self.messages.iter().find_map(|message| {
            let text =
                message.text.strip_prefix(word)?.strip_prefix('|')?.strip_prefix(worksheet)?.strip_prefix('|')?;
            Some((text, message.noise.as_slice()))
        })
    }

    /// The values of a task: the position of each point with its results.
    pub(super) fn values(&self, task: usize) -> impl Iterator<Item = (usize, Vec<Result<String, PointFailure>>)> {
        self.messages.iter().filter_map(move |message| {
            let text = message.text.strip_prefix("values|")?.strip_prefix(&format!("{task}|"))?;
            let (point, results) = text.split_once('|')?;
            Some((point.parse().ok()?, results.split('|').map(result).collect()))
        })
    }
}

fn result(text: &str) -> Result<String, PointFailure> {
    match text.strip_prefix('=') {
        Some(number) => decimal::round(number).ok_or_else(|| PointFailure::Symbols(number.to_owned())),
        None => Err(match text.split_once(' ') {
            Some(("symbols", left)) => PointFailure::Symbols(left.to_owned()),
            _ if text == "complex" => PointFailure::Complex,
            _ if text == "unstable" => PointFailure::Unstable,
            _ => PointFailure::NoValue,
        }),
    }
}
