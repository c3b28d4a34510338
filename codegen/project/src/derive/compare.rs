//! A family derived again and compared: its golden values, and its references as texts, or between two versions of Maxima,
//! which may write one formula in two ways, as values.

use std::collections::BTreeMap;
use std::path::Path;

use closedform_maxima::{Definition, evaluate_stable, print};
use rug::Float;

use super::ask::{Options, ask, reference_text};
use super::disagreement::{ByFunction, Disagreement};
use super::error::DeriveError;
use crate::contract::{self, Contract};
use crate::family::{Paths, check_references};
use crate::golden;
use crate::sample::sample;
use crate::source;

/// How the references and golden values of a family compare with what Maxima derives and computes now.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Compared {
    /// The version of Maxima that wrote them and the one that runs, where these differ and so do the texts.
    pub other_version: Option<(String, String)>,
    /// The functions that are other ones now, each with its kernel.
    pub changed: Vec<(String, String)>,
    /// The golden values that are other ones now.
    pub disagreements: Vec<Disagreement>,
}

/// The bits to which values of both are known, and to which they must agree.
const BITS: u32 = 192;
const AGREED: u32 = 160;

/// Derives the references of a family and computes its golden values again, in one run of its worksheet, and compares.
///
/// # Errors
///
/// When the worksheet fails or does not fulfil its contract, or there are no references or golden values that do.
pub fn compare(folder: &Path, name: &str, options: &Options) -> Result<Compared, DeriveError> {
    let paths = Paths::new(folder, name);
    let contract = contract::load(&paths.contract)?;
    let text = source::read(&paths.reference, format!("say `closedform derive {name}`, which writes this file"))?;
    let written = check_references(&paths.reference, &text, &contract)?;
    let golden = golden::load(&paths.golden)?;
    let golden = ByFunction::new(&golden);
    let reply = ask(&paths, &contract, &golden.tasks(&contract)?, options)?;
    let derived = reference_text(name, &reply, &contract, &paths)?;
    let derived = check_references(&paths.reference, &derived, &contract)?;
    let pairs: Vec<(&Definition, &Definition)> = written.iter().zip(&derived).collect();
    let other = |(one, other): &&(&Definition, &Definition)| print(&one.body) != print(&other.body);
    let differing: Vec<_> = pairs.iter().filter(other).collect();
    let recorded = version(&text).unwrap_or_default();
    let same_version = recorded == reply.version;
    let changed = differing.iter().filter(|(one, other)| same_version || !agree(&contract, one, other, options));
    let kernel = |function: &str| {
        let owner = contract.results().find(|(_, result)| result.worksheet == function);
        owner.map(|(kernel, _)| format!("{name}::{}", kernel.name)).unwrap_or_default()
    };
    let changed = changed.map(|(one, _)| (one.name.clone(), kernel(&one.name))).collect();
    let other_version = (!same_version && !differing.is_empty()).then(|| (recorded.to_owned(), reply.version.clone()));
    Ok(Compared { other_version, changed, disagreements: golden.disagreements(&reply) })
}

/// The version of Maxima that a file of references names.
fn version(text: &str) -> Option<&str> {
    let line = text.lines().find_map(|line| line.strip_prefix("/* Maxima "))?;
    line.strip_suffix(" */")
}

/// Whether two definitions have the same values at points of their kernel's domain.
fn agree(contract: &Contract, one: &Definition, other: &Definition, options: &Options) -> bool {
    let kernel = contract.results().find(|(_, result)| result.worksheet == one.name).map(|(kernel, _)| kernel);
    let points = kernel.map(|kernel| sample(&kernel.domain, &contract.inputs_of(kernel), options.points, options.seed));
    let Some(Ok(points)) = points else { return false };
    points.iter().all(|point| {
        let value = |definition: &Definition| {
            let inputs: BTreeMap<String, f64> =
                definition.parameters.iter().cloned().zip(point.iter().copied()).collect();
            evaluate_stable(&definition.body, &inputs, BITS)
        };
        match (value(one), value(other)) {
            (Ok(one), Ok(other)) => close(&one, &other),
            (one, other) => one.is_err() && other.is_err(),
        }
    })
}

fn close(one: &Float, other: &Float) -> bool {
    let difference = Float::with_val(BITS, one - other).abs();
    difference <= Float::with_val(BITS, one.abs_ref()) >> AGREED
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_tell_formulas_apart_and_no_spelling() {
        let contract = "[family]\ntitle = \"A family\"\n[inputs]\nx = { name = \"x\", unit = \"1\", typical = [0.1, 10.0] }\n\
                        [[kernel]]\nname = \"f\"\ndoc = \"A value.\"\ninputs = [\"x\"]\n[[kernel.result]]\nname = \"f\"\nworksheet = \"f\"\nunit = \"1\"\n";
        let contract = contract::parse(Path::new("t.toml"), contract).unwrap();
        let read = |text: &str| closedform_maxima::definitions(text).unwrap().remove(0);
        let same = |one: &str, other: &str| agree(&contract, &read(one), &read(other), &Options::default());
        assert!(same("f(x):=(x+1)^2$", "f(x):=x^2+2*x+1$") && same("f(x):=1/x$", "f(x):=x/x^2$"));
        assert!(!same("f(x):=(x+1)^2$", "f(x):=x^2+2*x+1+10^-40$"));
    }

    #[test]
    fn the_version_stands_in_the_file() {
        assert_eq!(version("/* reference */\n/* Maxima 5.46.0 */\nf(x):=x$\n"), Some("5.46.0"));
        assert_eq!(version("f(x):=x$\n"), None);
    }
}
