//! A worksheet that nobody wrote a contract for: its definitions are its reference expressions.

mod cores;
mod inline;
mod judged;
mod mistake;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::super::contract::{self, Contract, FamilyInfo, Input, KernelContract, ResultContract, TYPICAL};
use super::super::domain::Domain;
use super::super::script::Script;
use super::{Family, FamilyError, Paths};
use closedform_maxima::Definition;
use judged::Judged;
pub use mistake::{WorksheetError, WorksheetMistake};

/// What of a worksheet can become kernels.
#[derive(Debug)]
pub struct Sheet {
    /// The kernels with whose formulas nothing is wrong so far; perhaps none.
    pub family: Family,
    /// What is wrong with the others, if there are any.
    pub error: Option<WorksheetError>,
}

impl Sheet {
    /// The family, if nothing is wrong with any formula.
    pub(super) fn whole(self) -> Result<Family, FamilyError> {
        self.error.map_or(Ok(self.family), |error| Err(error.into()))
    }
}

/// The formulas of a worksheet, with the contract and reference expressions beside it, if there are any.
pub(super) fn load(path: &Path) -> Result<Sheet, FamilyError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let paths = Paths { worksheet: path.to_owned(), ..Paths::new(folder, &stem) };
    let name = contract::free_module_name(&stem);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(CORES)) {
        return load_cores(path, name, paths);
    }
    let contract = match paths.contract.exists() {
        true => Some(contract::load_under_any_name(&paths.contract)?),
        false => None,
    };
    let contract = match contract {
        Some(contract) if paths.reference.exists() => {
            return Ok(Sheet { family: Family::derived(&name, contract, paths)?, error: None });
        }
        contract => contract,
    };
    let script = Script::load(path)?;
    let judged = Judged::new(script.text());
    let mut contract = contract.unwrap_or_else(|| contract_of(&file_name(path), &judged.definitions));
    let ((kernels, references), mistakes) = judged.against(&contract);
    contract.kernels = kernels;
    let error = (!mistakes.is_empty()).then(|| WorksheetError::new(path, script.shown(), mistakes));
    let places = script.places(references.iter().map(|reference| reference.span.start));
    Ok(Sheet { family: Family { name, contract, references, places, paths }, error })
}

/// How the names of files of FPCores end.
const CORES: &str = "fpcore";

fn load_cores(path: &Path, name: String, paths: Paths) -> Result<Sheet, FamilyError> {
    let script = Script::load(path)?;
    let (contract, references, mut mistakes) = cores::judged(script.text(), &file_name(path), contract_of);
    if paths.contract.exists() {
        mistakes.push(WorksheetMistake::Contract { contract: paths.contract.clone() });
    }
    mistakes.sort_by_key(|mistake| mistake.span().map(|span| span.offset()));
    let error = (!mistakes.is_empty()).then(|| WorksheetError::new(path, script.shown(), mistakes));
    let places = script.places(references.iter().map(|reference| reference.span.start));
    Ok(Sheet { family: Family { name, contract, references, places, paths }, error })
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// What can be promised without anybody's word: every definition is a kernel, every quantity without a unit, and digits
/// go before time.
fn contract_of(file: &str, definitions: &[Definition]) -> Contract {
    let mut kernels: Vec<KernelContract> = Vec::new();
    let mut inputs: BTreeMap<String, Input> = BTreeMap::new();
    let (mut taken_kernels, mut taken_inputs) = (BTreeSet::new(), BTreeSet::new());
    for definition in definitions {
        kernels.push(kernel(definition, unused_name(&definition.name, &mut taken_kernels), file));
        for parameter in &definition.parameters {
            let unused = || input(unused_name(parameter, &mut taken_inputs));
            inputs.entry(parameter.clone()).or_insert_with(unused);
        }
    }
    let title = format!("The formulas of the worksheet {file}");
    Contract { family: FamilyInfo { title, source: String::new() }, inputs, kernels }
}

fn kernel(definition: &Definition, name: String, file: &str) -> KernelContract {
    let result = ResultContract { name: name.clone(), worksheet: definition.name.clone(), unit: "1".to_owned() };
    KernelContract {
        name,
        doc: format!("The function {} of {file}.", definition.name),
        source: file.to_owned(),
        inputs: definition.parameters.clone(),
        domain: Domain::new(definition.parameters.clone(), Vec::new()),
        branch: None,
        few_roundings: true,
        one_division: false,
        edges: None,
        returns: None,
        results: vec![result],
    }
}

fn input(name: String) -> Input {
    Input { name, unit: "1".to_owned(), typical: TYPICAL, doc: String::new() }
}

/// A Rust name for a Maxima name that is not taken yet, and is from then on.
fn unused_name(maxima: &str, taken: &mut BTreeSet<String>) -> String {
    let name = contract::free_name(maxima, |name| contract::rust_name(name).is_ok() && !taken.contains(name));
    taken.insert(name.clone());
    name
}
