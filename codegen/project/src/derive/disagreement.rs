//! Golden values computed again, and those that Maxima no longer agrees with.

use std::collections::BTreeMap;

use super::decimal;
use super::driver::Task;
use super::error::{DeriveError, PointFailure};
use super::reply::Reply;
use crate::contract::Contract;
use crate::golden::GoldenValue;

/// A golden value that Maxima no longer agrees with.
#[derive(Debug, Clone, PartialEq)]
pub struct Disagreement {
    /// What the file says.
    pub golden: GoldenValue,
    /// What Maxima computes now, or why it computes nothing.
    pub now: Result<String, PointFailure>,
}

/// Golden values by the functions that they are values of.
pub(super) struct ByFunction<'a>(BTreeMap<&'a str, Vec<&'a GoldenValue>>);

impl<'a> ByFunction<'a> {
    pub(super) fn new(golden: &'a [GoldenValue]) -> Self {
        let mut by_function: BTreeMap<&str, Vec<&GoldenValue>> = BTreeMap::new();
        for value in golden {
            by_function.entry(&value.worksheet).or_default().push(value);
        }
        Self(by_function)
    }

    /// The tasks to compute all of them again.
    ///
    /// # Errors
    /// When values have other inputs than their kernels.
    pub(super) fn tasks(&self, contract: &Contract) -> Result<Vec<Task>, DeriveError> {
        self.0.iter().map(|(worksheet, values)| again(contract, worksheet, values)).collect()
    }

    /// Every value that is another one by the reply to those tasks.
    pub(super) fn disagreements(&self, reply: &Reply) -> Vec<Disagreement> {
        let mut disagreements = Vec::new();
        for (index, values) in self.0.values().enumerate() {
            let now = reply.values(index).map(|(_, results)| results.into_iter().next());
            disagreements.extend(values.iter().zip(now).filter_map(|(golden, now)| disagreement(golden, now?)));
        }
        disagreements
    }
}

fn disagreement(golden: &GoldenValue, now: Result<String, PointFailure>) -> Option<Disagreement> {
    let agrees = now.as_ref().is_ok_and(|now| decimal::agree(now, &golden.value));
    (!agrees).then(|| Disagreement { golden: golden.clone(), now })
}

/// The task to compute golden values of one function again.
fn again(contract: &Contract, worksheet: &str, values: &[&GoldenValue]) -> Result<Task, DeriveError> {
    let kernel = contract.results().find(|(_, result)| result.worksheet == worksheet).map(|(kernel, _)| kernel);
    let inputs = kernel.map(|kernel| kernel.inputs.clone()).unwrap_or_default();
    let same = |value: &&GoldenValue| value.inputs.iter().map(|(name, _)| name).eq(&inputs);
    if !values.iter().all(same) {
        return Err(DeriveError::StaleGolden { worksheet: worksheet.to_owned() });
    }
    let points = values.iter().map(|value| value.inputs.iter().map(|(_, value)| *value).collect()).collect();
    Ok(Task { results: vec![worksheet.to_owned()], inputs, points, wanted: usize::MAX })
}
