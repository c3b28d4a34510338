//! A worksheet that nobody wrote a contract for: its definitions are its reference expressions.

mod cores;
mod judged;
mod mistake;
mod summary;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use closedform_build::{Stamp, hash};

use super::super::contract::{self, Contract, FamilyInfo, Input, KernelContract, ResultContract, TYPICAL};
use super::super::domain::Domain;
use super::super::script::Script;
use super::super::source;
use super::super::worksheet;
use super::{Family, FamilyError, Paths, natural_domain};
use crate::beside::beside;
use crate::worksheet::Formula;
use closedform_maxima::Definition;
use judged::{Judged, Sound, assumptions_of};
pub use mistake::{WorksheetError, WorksheetMistake};
pub use summary::{Passed, Summary};

/// What of a worksheet can become kernels.
#[derive(Debug)]
pub struct Sheet {
    /// The kernels with whose formulas nothing is wrong so far; perhaps none.
    pub family: Family,
    /// What is wrong with the others, if there are any.
    pub error: Option<WorksheetError>,
    /// What was taken, and what was not.
    pub summary: Summary,
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
            return Ok(Sheet {
                family: Family::derived(&name, contract, paths)?,
                error: None,
                summary: Summary::default(),
            });
        }
        contract => contract,
    };
    let is_derived = contract.is_none() && derived(&paths)?;
    let script = Script::load(if is_derived { &paths.reference } else { path })?;
    let reading = match is_derived {
        true => worksheet::closed(script.text()),
        false => worksheet::read(script.text(), files_beside(path, script.text())),
    };
    let judged = Judged::new(script.text(), reading);
    let needs_maxima = judged.reading.refused.iter().any(|(_, because)| because.remedy == worksheet::COMPUTE);
    let mut contract = contract.unwrap_or_else(|| contract_of(&file_name(path), &judged.reading.formulas));
    let (sound, mistakes) = judged.against(&contract);
    let Sound { kernels, references, mut summary } = sound;
    for kernel in &kernels {
        let own = |reference: &&Definition| kernel.results.iter().any(|result| result.worksheet == reference.name);
        let bodies = references.iter().filter(own).map(|reference| &reference.body);
        let open: Vec<String> = bodies.flat_map(|body| natural_domain::left_open(body, &kernel.inputs)).collect();
        if !open.is_empty() {
            let (name, open) = (&kernel.name, open.join("`, `"));
            summary
                .lines
                .push(format!("`{name}` needs `{open}` too, which is left open: it is no condition of its domain"));
        }
    }
    if is_derived {
        let note = format!("the formulas are those that Maxima derived: {}", paths.reference.display());
        summary.lines.insert(0, note);
    } else if needs_maxima {
        summary.lines.push(format!("what must be computed: `closedform derive {}` lets Maxima do it", path.display()));
    }
    contract.kernels = kernels;
    let error = (!mistakes.is_empty()).then(|| WorksheetError::new(path, script.shown(), mistakes));
    let places = script.places(references.iter().map(|reference| reference.span.start));
    Ok(Sheet { family: Family { name, contract, references, places, paths }, error, summary })
}

/// Whether Maxima has derived formulas from a worksheet as it is now.
fn derived(paths: &Paths) -> Result<bool, FamilyError> {
    if !paths.reference.exists() {
        return Ok(false);
    }
    let [reference, worksheet] = [&paths.reference, &paths.worksheet].map(|path| source::read_bytes(path));
    let (reference, worksheet) = (reference?, worksheet?);
    let stamp = Stamp::read(&String::from_utf8_lossy(&reference));
    match stamp.is_some_and(|stamp| stamp.inputs == hash([&*worksheet])) {
        true => Ok(true),
        false => Err(FamilyError::Stale { reference: paths.reference.clone(), worksheet: paths.worksheet.clone() }),
    }
}

/// The texts of worksheets beside this one, by the names under which it mentions them.
fn files_beside(path: &Path, text: &str) -> BTreeMap<String, String> {
    let files = beside(path, text).into_iter();
    files.map(|(name, file)| (name, file.script.text().to_owned())).collect()
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
    let summary = Summary::of_mistakes(script.text(), &mistakes);
    let error = (!mistakes.is_empty()).then(|| WorksheetError::new(path, script.shown(), mistakes));
    let places = script.places(references.iter().map(|reference| reference.span.start));
    Ok(Sheet { family: Family { name, contract, references, places, paths }, error, summary })
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// What can be promised without anybody's word: every definition is a kernel, every quantity without a unit, and digits
/// go before time.
fn contract_of(file: &str, formulas: &[Formula]) -> Contract {
    let mut kernels: Vec<KernelContract> = Vec::new();
    let mut inputs: BTreeMap<String, Input> = BTreeMap::new();
    let (mut taken_kernels, mut taken_inputs) = (BTreeSet::new(), BTreeSet::new());
    let mut taken_types = BTreeSet::new();
    for formula in formulas {
        let name = unused_name(&formula.name, &mut taken_kernels);
        kernels.push(kernel(formula, name, file, &mut taken_types));
        for parameter in &formula.inputs {
            let unused = || input(unused_name(parameter, &mut taken_inputs));
            inputs.entry(parameter.clone()).or_insert_with(unused);
        }
    }
    let title = format!("The formulas of the worksheet {file}");
    Contract { family: FamilyInfo { title, source: String::new() }, inputs, kernels }
}

fn kernel(formula: &Formula, name: String, file: &str, types: &mut BTreeSet<String>) -> KernelContract {
    let several = formula.results.len() > 1;
    let what = if formula.parameters > 0 { "function" } else { "formula" };
    let mut fields = BTreeSet::new();
    let mut result = |field: &str| ResultContract {
        name: if several { unused_name(field, &mut fields) } else { name.clone() },
        worksheet: formula.worksheet_name(field),
        unit: "1".to_owned(),
    };
    let results = formula.results.iter().map(|(field, _)| result(field)).collect();
    KernelContract {
        doc: format!("The {what} {} of {file}.", formula.name),
        source: file.to_owned(),
        inputs: formula.inputs.clone(),
        domain: Domain::new(formula.inputs.clone(), assumptions_of(formula)),
        branch: None,
        few_roundings: true,
        one_division: false,
        edges: None,
        returns: several.then(|| contract::free_type_name(&name, types)),
        results,
        name,
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
