//! A file of FPCores: each core is a kernel, its precondition the domain, what its author says of it the text of its pages.

use std::collections::BTreeSet;

use closedform_maxima::{Definition, print};

use super::super::reference::mistakes_of;
use super::mistake::WorksheetMistake;
use crate::contract::{self, Contract, KernelContract};
use crate::domain::{Condition, Domain};
use crate::fpcore::{Core, CoreMistake, cores};
use crate::worksheet::Formula;

/// The kernels of a file with their definitions, and everything that is wrong with the others.
pub(super) fn judged(
    text: &str,
    file: &str,
    contract_of: fn(&str, &[Formula]) -> Contract,
) -> (Contract, Vec<Definition>, Vec<WorksheetMistake>) {
    let (cores, wrong) = cores(text);
    let mut mistakes: Vec<WorksheetMistake> = wrong.into_iter().map(Into::into).collect();
    let named = named(cores);
    let closed: Vec<Definition> = named.iter().map(|core| core.definition.clone()).collect();
    let mut contract = contract_of(file, &closed.iter().map(formula_of).collect::<Vec<_>>());
    let mut kept = (Vec::new(), Vec::new());
    for (kernel, definition) in contract.kernels.iter().zip(closed) {
        let Some(core) = named.iter().find(|core| core.definition.name == definition.name) else { continue };
        let wrong = mistakes_of(&definition, &kernel.inputs);
        match kernel_of(kernel, core, file) {
            Ok(kernel) if wrong.is_empty() => {
                kept.0.push(kernel);
                kept.1.push(definition);
            }
            Ok(_) => {}
            Err(wrong) => mistakes.extend(wrong.into_iter().map(WorksheetMistake::from)),
        }
        mistakes.extend(wrong.into_iter().map(WorksheetMistake::from));
    }
    contract.kernels = kept.0;
    (contract, kept.1, mistakes)
}

/// A definition with nothing left to put in, as a formula of a worksheet.
fn formula_of(definition: &Definition) -> Formula {
    Formula {
        name: definition.name.clone(),
        inputs: definition.parameters.clone(),
        parameters: definition.parameters.len(),
        results: vec![(String::new(), definition.body.clone())],
        assumed: Vec::new(),
        conditions: Vec::new(),
        span: definition.span.clone(),
    }
}

/// The cores, each under a name of its own: its identifier, or what its title makes.
fn named(cores: Vec<Core>) -> Vec<Core> {
    let mut taken = BTreeSet::new();
    let identifiers: Vec<String> = cores.iter().filter_map(|core| core.identifier.clone()).collect();
    let name = |core: Core| {
        let first = core.identifier.clone().filter(|name| taken.insert(name.clone()));
        let name = first.unwrap_or_else(|| {
            let wished = core.identifier.as_deref().or(core.title.as_deref()).unwrap_or("core");
            let short: String = wished.chars().take(LONGEST_NAME).collect();
            loop {
                let is_free = |name: &str| contract::rust_name(name).is_ok() && !taken.contains(name);
                let name = contract::free_name(&short, is_free);
                taken.insert(name.clone());
                if !identifiers.contains(&name) {
                    return name;
                }
            }
        });
        Core { definition: Definition { name, ..core.definition }, ..core }
    };
    cores.into_iter().map(name).collect()
}

/// Titles are sentences, and names are not.
const LONGEST_NAME: usize = 48;

/// A kernel with the domain and the words of its core, or what of the precondition cannot be decided.
fn kernel_of(kernel: &KernelContract, core: &Core, file: &str) -> Result<KernelContract, Vec<CoreMistake>> {
    if kernel.inputs.is_empty() {
        let what = format!("`{}` has no argument: it is a number, which needs no kernel", kernel.name);
        let remedy = "give the core an argument, or leave it out";
        return Err(vec![CoreMistake::new(what, remedy, core.definition.span.clone())]);
    }
    let (mut conditions, mut mistakes) = (Vec::new(), Vec::new());
    for part in &core.conditions {
        match Condition::read(part, &kernel.inputs) {
            Ok(condition) => conditions.push((print(part), condition)),
            Err(error) => {
                let span = error.span().unwrap_or_else(|| part.span.clone());
                let (what, span) = (format!("`{}`: {error}", kernel.name), span.into());
                mistakes.push(CoreMistake { what, remedy: error.remedy().to_owned(), span });
            }
        }
    }
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    let summary = core.title.as_ref().map(|title| format!("{}.", title.trim_end_matches('.')));
    let mut doc = summary.unwrap_or_else(|| kernel.doc.clone());
    if !core.properties.is_empty() {
        doc += &format!("\n\n{}", core.properties.join("; "));
    }
    let source = core.cited.as_ref().map_or_else(|| file.to_owned(), |cited| format!("{file}, citing {cited}"));
    Ok(KernelContract { doc, source, domain: Domain::new(kernel.inputs.clone(), conditions), ..kernel.clone() })
}
