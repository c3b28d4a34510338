//! Contracts: what `NAME.toml` promises of every kernel of a family.

mod check;
mod error;
mod names;
mod raw;

use std::collections::BTreeMap;
use std::path::Path;

pub use error::{ContractError, Mistake};
pub use names::{
    RustNameError, free_module_name, free_module_name_beside, free_name, free_type_name, is_device, is_keyword,
    module_name, rust_name, snake_case,
};

use super::domain::Domain;
use super::source;

/// The magnitudes that samplers use for an input whose contract does not say.
pub const TYPICAL: [f64; 2] = [1e-3, 1e3];

/// What a family promises; every value of this type is valid.
#[derive(Debug, Clone, PartialEq)]
pub struct Contract {
    /// The family as a whole.
    pub family: FamilyInfo,
    /// Every input of the family's kernels, by Maxima name.
    pub inputs: BTreeMap<String, Input>,
    /// The kernels, in the order of the file.
    pub kernels: Vec<KernelContract>,
}

/// What a family is about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FamilyInfo {
    /// One line.
    pub title: String,
    /// The sections of the seed it comes from.
    pub source: String,
}

/// One input variable of a family.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Rust name.
    pub name: String,
    /// Unit, `"1"` if there is none.
    pub unit: String,
    /// The range of magnitudes that samplers use.
    pub typical: [f64; 2],
    /// What it is.
    pub doc: String,
}

/// What a kernel promises.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelContract {
    /// Rust name of the function.
    pub name: String,
    /// One sentence.
    pub doc: String,
    /// Cell of the seed.
    pub source: String,
    /// Maxima names of the inputs, in the order of the arguments.
    pub inputs: Vec<String>,
    /// Where the promise holds.
    pub domain: Domain,
    /// Which of several solutions this is.
    pub branch: Option<String>,
    /// Whether digits go before time: no result is to be off by more than 2 ulp.
    pub few_roundings: bool,
    /// Whether its quotients are to share one division.
    pub one_division: bool,
    /// What happens at the edges of the domain.
    pub edges: Option<String>,
    /// Name of the struct that a kernel of several results returns.
    pub returns: Option<String>,
    /// The results, in the order of the fields.
    pub results: Vec<ResultContract>,
}

/// One result of a kernel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResultContract {
    /// Rust name of the field.
    pub name: String,
    /// The Maxima function that the worksheet defines.
    pub worksheet: String,
    /// Unit, `"1"` if there is none.
    pub unit: String,
}

impl Contract {
    /// Every result with its kernel, in contract order.
    pub fn results(&self) -> impl Iterator<Item = (&KernelContract, &ResultContract)> {
        self.kernels.iter().flat_map(|kernel| kernel.results.iter().map(move |result| (kernel, result)))
    }

    /// What the contract says of the inputs of a kernel, in the order of its arguments.
    pub fn inputs_of<'a>(&'a self, kernel: &'a KernelContract) -> Vec<&'a Input> {
        kernel.inputs.iter().map(|name| &self.inputs[name]).collect()
    }
}

/// Reads and checks a contract; all mistakes are reported at once.
pub fn load(path: &Path) -> Result<Contract, ContractError> {
    parse(path, &read(path)?)
}

/// As [`load`], of a worksheet whose name need not be that of a module.
pub fn load_under_any_name(path: &Path) -> Result<Contract, ContractError> {
    checked(path, &read(path)?, None)
}

fn read(path: &Path) -> Result<String, ContractError> {
    Ok(source::read(
        path,
        "correct the name, or write the contract of this worksheet; `closedform schema contract` says what it may hold",
    )?)
}

/// Checks the text of a contract; `path` names it in errors.
pub fn parse(path: &Path, text: &str) -> Result<Contract, ContractError> {
    checked(path, text, path.file_stem().map(|stem| stem.to_string_lossy().into_owned()))
}

/// Checks the text of a contract, and the name of its family, if that must be one.
fn checked(path: &Path, text: &str, family: Option<String>) -> Result<Contract, ContractError> {
    let mistakes = match toml::from_str::<raw::Contract>(text) {
        Err(error) => vec![Mistake::toml(&error)],
        Ok(raw) => match check::check(raw, family, text) {
            Ok(contract) => return Ok(contract),
            Err(mistakes) => mistakes,
        },
    };
    Err(ContractError::mistakes(path, text, mistakes))
}

#[cfg(test)]
mod tests;
