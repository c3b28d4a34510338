//! What is missing: kernels without contract, reference, golden values or bound, and any of these without a kernel.

use std::collections::BTreeSet;

use closedform::Info;

use crate::contract::{self, Contract};
use crate::golden::{self, GoldenValue};
use crate::reference::References;
use crate::worksheets;

/// Golden values that every result must have.
pub const GOLDEN_VALUES: usize = 24;

/// All that exists for one family.
#[derive(Debug)]
pub struct Family<'a> {
    /// Its name.
    pub name: String,
    /// Its kernels.
    pub kernels: Vec<&'a Info>,
    /// Their contracts.
    pub contracts: Vec<Contract>,
    /// The reference expressions.
    pub references: References,
    /// The golden values.
    pub golden: Vec<GoldenValue>,
}

/// All families that have a kernel or a file, and what exists for each.
pub fn families<'a>(kernels: &[&'a Info]) -> Vec<Family<'a>> {
    let mut names: BTreeSet<String> = kernels.iter().map(|info| info.family.to_owned()).collect();
    ["toml", "ref", "tsv", "mac"].iter().for_each(|extension| names.extend(worksheets::families(extension)));
    names.iter().map(|name| Family::load(name, kernels)).collect()
}

impl<'a> Family<'a> {
    /// All that exists for the family of this name, of whose kernels these are some.
    pub fn load(name: &str, kernels: &[&'a Info]) -> Self {
        Family {
            name: name.to_owned(),
            kernels: kernels.iter().filter(|info| info.family == name).copied().collect(),
            contracts: contract::load(name),
            references: References::load(name),
            golden: golden::load(name),
        }
    }

    /// One line for everything that has no kernel.
    pub fn strangers(&self) -> Vec<String> {
        let mut gaps = Vec::new();
        let kernels: BTreeSet<&str> = self.kernels.iter().map(|info| info.name).collect();
        let of_kernels = self.kernels.iter().flat_map(|info| info.results).map(|result| result.worksheet);
        let worksheets: BTreeSet<&str> = of_kernels.collect();
        let contracts = self.contracts.iter().map(|contract| contract.name.as_str());
        let golden: BTreeSet<&str> = self.golden.iter().map(|value| value.worksheet.as_str()).collect();
        gaps.extend(strangers("contract", contracts, &kernels));
        gaps.extend(strangers("reference", self.references.names(), &worksheets));
        gaps.extend(strangers("golden value", golden.into_iter(), &worksheets));
        gaps.into_iter().map(|gap| format!("{}: {gap}", self.name)).collect()
    }

    /// One line for everything that a kernel lacks.
    pub fn gaps_of(&self, info: &Info) -> Vec<String> {
        let mut gaps = Vec::new();
        let worksheets: Vec<&str> = info.results.iter().map(|result| result.worksheet).collect();
        match self.contracts.iter().find(|contract| contract.name == info.name) {
            None => gaps.push(format!("no contract for {}", info.name)),
            Some(contract) if contract.worksheets != worksheets => {
                gaps.push(format!("{} returns {worksheets:?}, its contract {:?}", info.name, contract.worksheets));
            }
            Some(_) => {}
        }
        for result in info.results {
            let golden = self.golden.iter().filter(|value| value.worksheet == result.worksheet).count();
            if self.references.get(result.worksheet).is_none() {
                gaps.push(format!("no reference `{}` for {}", result.worksheet, info.name));
            }
            if golden < GOLDEN_VALUES {
                gaps.push(format!("only {golden} golden values of `{}` for {}", result.worksheet, info.name));
            }
            if result.bound_ulp.is_none() {
                gaps.push(format!("no bound for `{}` of {}", result.name, info.name));
            }
        }
        gaps
    }
}

fn strangers<'a>(what: &str, found: impl Iterator<Item = &'a str>, known: &BTreeSet<&str>) -> Vec<String> {
    found.filter(|name| !known.contains(name)).map(|name| format!("{what} `{name}` without a kernel")).collect()
}
