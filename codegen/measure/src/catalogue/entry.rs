//! One kernel of the catalogue, and what follows from its text.

use closedform_syntax::{Input, Kernel};
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::source::function_text;
use closedform_project::contract;
use closedform_project::domain::{Condition, ConditionError, Domain};

/// A kernel with its family.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The module that it belongs to.
    pub family: String,
    /// Its name in that module.
    pub name: String,
    /// The kernel.
    pub kernel: Kernel,
    /// The text of its function.
    pub rust: String,
    /// What its `require!`s say, read from their texts.
    conditions: Vec<Result<Condition, ConditionError>>,
}

/// A condition that samplers cannot decide.
#[derive(Debug, Error, Diagnostic)]
#[error("`{kernel}`: {cause}")]
#[diagnostic(help("{}", cause.remedy()))]
pub struct DomainError {
    /// The kernel.
    pub kernel: String,
    /// Why not.
    pub cause: ConditionError,
    /// The condition.
    #[source_code]
    pub text: String,
    /// Where in it.
    #[label("{}", cause.label())]
    pub place: Option<SourceSpan>,
}

impl Entry {
    pub(super) fn new(family: &str, kernel: Kernel, text: &str) -> Self {
        let name = kernel.name.to_string();
        let rust = function_text(text, &name).to_owned();
        let variables: Vec<String> = kernel.inputs.iter().map(maxima_name).collect();
        let conditions = kernel.requires.iter().map(|require| Condition::parse(&require.text, &variables)).collect();
        Self { family: family.to_owned(), name, kernel, rust, conditions }
    }

    /// `family::name`
    pub fn full_name(&self) -> String {
        format!("{}::{}", self.family, self.name)
    }

    /// The names of its inputs in the worksheet, in order.
    pub fn maxima_names(&self) -> Vec<String> {
        self.kernel.inputs.iter().map(maxima_name).collect()
    }

    /// The position of the input of this name, be it that in Rust or that in the worksheet.
    pub fn input_called(&self, name: &str) -> Option<usize> {
        let inputs = &self.kernel.inputs;
        let rust = inputs.iter().position(|input| input.name == name);
        rust.or_else(|| inputs.iter().position(|input| input.maxima.as_deref() == Some(name)))
    }

    /// The inputs as samplers know them.
    pub fn inputs(&self) -> Vec<contract::Input> {
        let inputs = self.kernel.inputs.iter().map(|input| contract::Input {
            name: input.name.to_string(),
            unit: unit_of(&input.unit).to_owned(),
            typical: input.typical.map_or(contract::TYPICAL, |(low, high)| [low, high]),
            doc: String::new(),
        });
        inputs.collect()
    }

    /// The domain, to be decided exactly.
    ///
    /// # Errors
    ///
    /// When the text of a condition is not one of a contract, as in a kernel written by hand.
    pub fn domain(&self) -> Result<Domain, DomainError> {
        let conditions = self.conditions().map(|(text, condition)| match condition {
            Ok(condition) => Ok((text.to_owned(), condition.clone())),
            Err(cause) => Err(DomainError {
                kernel: self.full_name(),
                place: cause.span().map(Into::into),
                cause: cause.clone(),
                text: text.to_owned(),
            }),
        });
        Ok(Domain::new(self.maxima_names(), conditions.collect::<Result<_, _>>()?))
    }

    /// The text of every condition, and what it says, if it is one of a contract.
    pub fn conditions(&self) -> impl Iterator<Item = (&str, &Result<Condition, ConditionError>)> {
        self.kernel.requires.iter().map(|require| require.text.as_str()).zip(&self.conditions)
    }

    pub(super) fn is_named(&self, name: &str) -> bool {
        self.full_name() == name
    }

    pub(super) fn is_named_briefly(&self, name: &str) -> bool {
        self.name == name
    }

    pub(super) fn has_worksheet_name(&self, name: &str) -> bool {
        self.kernel.meta.results.iter().any(|result| result.worksheet.as_deref() == Some(name))
    }

    /// Everything that it may be called.
    pub(super) fn spellings(&self) -> Vec<String> {
        let worksheet = self.kernel.meta.results.iter().filter_map(|result| result.worksheet.clone());
        [self.full_name(), self.name.clone()].into_iter().chain(worksheet).collect()
    }
}

/// The name of an input in the worksheet; that in Rust where none is given.
pub fn maxima_name(input: &Input) -> String {
    input.maxima.clone().unwrap_or_else(|| input.name.to_string())
}

/// A unit; `"1"` where none is given.
pub fn unit_of(unit: &Option<String>) -> &str {
    unit.as_deref().unwrap_or("1")
}
