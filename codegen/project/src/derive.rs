//! Derivation: Maxima runs a worksheet and prints reference expressions and golden values.

mod ask;
mod compare;
mod decimal;
mod disagreement;
mod driver;
mod error;
mod natural;
mod reply;
mod sheet;

use std::path::Path;

use closedform_build::VERSION;
use closedform_maxima::Definition;

pub use ask::Options;
pub use compare::{Compared, compare};
pub use disagreement::Disagreement;
pub use driver::VALUES;
pub use error::{DeriveError, PointFailure};
pub use natural::Added;
pub use sheet::{DerivedSheet, derive_sheet};

use super::contract::{self, Contract, KernelContract};
use super::family::{Paths, check_references};
use super::files;
use super::golden::{self, GoldenValue};
use super::sample::sample;
use super::source;
use ask::{ask, header, reference_text};
use driver::Task;
use natural::Retry;
use reply::Reply;

/// How many more points are at hand than wanted, for those where a formula has no value.
const SPARE: usize = 3;

/// What was derived, not yet written.
#[derive(Debug, Clone, PartialEq)]
pub struct Derived {
    /// The text of `NAME.ref`.
    pub reference: String,
    /// The text of `NAME.tsv`.
    pub golden: String,
    /// The reference expressions, in contract order.
    pub definitions: Vec<Definition>,
    /// The golden values.
    pub values: Vec<GoldenValue>,
    /// The files of the family.
    pub paths: Paths,
    /// Kernels whose formulas need more than their contracts say, and what: their golden values are where that holds too.
    pub added: Vec<Added>,
}

impl Derived {
    /// Writes `NAME.ref` and `NAME.tsv`, both or none.
    pub fn write(&self) -> Result<(), DeriveError> {
        let files = [(&*self.paths.reference, &*self.reference), (&*self.paths.golden, &*self.golden)];
        Ok(files::write_all(&files)?)
    }
}

/// Derives reference expressions and golden values of a family; writes nothing.
pub fn derive(folder: &Path, name: &str, options: &Options) -> Result<Derived, DeriveError> {
    let paths = Paths::new(folder, name);
    files::replaceable([&*paths.reference, &*paths.golden])?;
    let contract = contract::load(&paths.contract)?;
    let tasks: Vec<Task> =
        contract.kernels.iter().map(|kernel| sampled(&contract, kernel, options)).collect::<Result<_, _>>()?;
    let reply = ask(&paths, &contract, &tasks, options)?;
    let reference = reference_text(name, &reply, &contract, &paths)?;
    let definitions = check_references(&paths.reference, &reference, &contract)?;
    let (values, added) = values(&paths, &contract, &tasks, &reply, &definitions, options)?;
    let golden = header(name, "golden values", &reply.version, "# ", "") + golden::print(&values).as_str();
    let inputs = inputs_of(&paths)?;
    let [reference, golden] = [reference, golden].map(|text| closedform_build::stamped(&text, VERSION, inputs));
    Ok(Derived { reference, golden, definitions, values, paths, added })
}

/// Derives the reference expressions alone, in contract order.
pub fn rederive(folder: &Path, name: &str, options: &Options) -> Result<Vec<Definition>, DeriveError> {
    let paths = Paths::new(folder, name);
    let contract = contract::load(&paths.contract)?;
    let reply = ask(&paths, &contract, &[], options)?;
    let text = reference_text(name, &reply, &contract, &paths)?;
    Ok(check_references(&paths.reference, &text, &contract)?)
}

/// The hash of what a family is derived from.
fn inputs_of(paths: &Paths) -> Result<u64, DeriveError> {
    let [worksheet, contract] = [&paths.worksheet, &paths.contract].map(|path| source::read_bytes(path));
    Ok(closedform_build::hash([&*worksheet?, &*contract?]))
}

/// The golden values of all kernels; kernels that have none at some points of their contracts' domains are asked once more,
/// where their formulas have values, and named with what they need.
fn values(
    paths: &Paths,
    contract: &Contract,
    tasks: &[Task],
    reply: &Reply,
    definitions: &[Definition],
    options: &Options,
) -> Result<(Vec<GoldenValue>, Vec<Added>), DeriveError> {
    let (mut values, mut retries, mut added) = (Vec::new(), Vec::new(), Vec::new());
    for (index, (kernel, task)) in contract.kernels.iter().zip(tasks).enumerate() {
        values.push(golden_values(kernel, task, reply.values(index)).or_else(|error| {
            let retry = Retry::new(index, kernel, &task.points, &own(contract, kernel, definitions));
            let again = retry
                .filter(|_| error.may_be_natural())
                .map(|retry| (sampled(contract, &retry.kernel, options), retry));
            match again {
                // where nothing meets what the formula needs too, the point says more
                Some((Ok(task), retry)) => retries.push((retry, task)),
                _ => return Err(error),
            }
            Ok(Vec::new())
        })?);
    }
    if !retries.is_empty() {
        let (retries, tasks): (Vec<Retry>, Vec<Task>) = retries.into_iter().unzip();
        let reply = ask(paths, contract, &tasks, options)?;
        for (at, (retry, task)) in retries.iter().zip(&tasks).enumerate() {
            values[retry.index] = golden_values(&retry.kernel, task, reply.values(at))?;
        }
        added.extend(retries.into_iter().map(Retry::added));
    }
    Ok((values.concat(), added))
}

/// The reference expressions of a kernel, of those of its contract.
fn own<'a>(contract: &Contract, kernel: &KernelContract, definitions: &'a [Definition]) -> Vec<&'a Definition> {
    let all = contract.results().zip(definitions);
    all.filter(|((owner, _), _)| owner.name == kernel.name).map(|(_, definition)| definition).collect()
}

/// The task to compute all results of a kernel at points of its domain.
fn sampled(contract: &Contract, kernel: &KernelContract, options: &Options) -> Result<Task, DeriveError> {
    let count = SPARE * options.points;
    let points = sample(&kernel.domain, &contract.inputs_of(kernel), count, options.seed)
        .map_err(|cause| DeriveError::EmptyDomain { kernel: kernel.name.clone(), cause })?;
    let results = kernel.results.iter().map(|result| result.worksheet.clone()).collect();
    Ok(Task { results, inputs: kernel.inputs.clone(), points, wanted: options.points })
}

/// The golden values of a kernel, from what Maxima said of each point.
fn golden_values(
    kernel: &KernelContract,
    task: &Task,
    said: impl Iterator<Item = (usize, Vec<Result<String, PointFailure>>)>,
) -> Result<Vec<GoldenValue>, DeriveError> {
    let mut values = Vec::new();
    let mut skipped = Vec::new();
    for (point, results) in said {
        let inputs = || task.inputs.iter().cloned().zip(task.points[point].iter().copied()).collect::<Vec<_>>();
        match results.into_iter().collect::<Result<Vec<String>, PointFailure>>() {
            Ok(results) => values.extend(kernel.results.iter().zip(results).map(|(result, value)| GoldenValue {
                worksheet: result.worksheet.clone(),
                inputs: inputs(),
                value,
            })),
            Err(failure) if failure.is_fatal() => {
                let kernel = kernel.name.clone();
                return Err(DeriveError::Point { kernel, failure, point: error::spell(&inputs()) });
            }
            Err(failure) => skipped.push((failure, inputs())),
        }
    }
    let found = values.len() / kernel.results.len().max(1);
    match skipped.first() {
        Some((failure, inputs)) if found < task.wanted.min(task.points.len()) => Err(DeriveError::TooFewPoints {
            kernel: kernel.name.clone(),
            found,
            wanted: task.wanted,
            failure: failure.clone(),
            point: error::spell(inputs),
        }),
        _ => Ok(values),
    }
}

#[cfg(test)]
mod tests;
