//! Worst-case search: a search that climbs towards the inputs at which the results of a kernel are worst.

mod budget;
mod climb;
mod estimate;
mod moves;
mod starts;
mod target;
mod zeros;

use std::time::Instant;

use crate::accuracy::{ValueError, Worst};
use climb::Climber;
use closedform_project::sample::EmptyDomain;

pub use budget::{Budget, parse_duration};
pub use target::Target;

/// What a search brought home.
#[derive(Clone, Debug)]
pub struct Found {
    /// For each result the worst points, worst first, all of them confirmed by the reference.
    pub worst: Vec<Vec<Worst>>,
    /// How many points were looked at.
    pub looked: u64,
}

/// Searches all results of a kernel; `known` holds for each result the points to start from.
///
/// # Errors
///
/// When the domain has no points, or the reference no value at one.
pub fn search(target: &Target, known: &[Vec<Vec<f64>>], budget: Budget, seed: u64) -> Result<Found, SearchError> {
    let begin = Instant::now();
    let results = target.kernel.meta.results.len();
    let mut found = Found { worst: Vec::new(), looked: 0 };
    for result in 0..results {
        let mut allowance = budget.allowance(begin, results - result);
        let known = known.get(result).map_or(&[][..], |known| known);
        let seed = seed.wrapping_add(result as u64 * 0x1_0000);
        found.worst.push(Climber::new(target, result, seed)?.climb(known, &mut allowance)?);
        found.looked += allowance.spent();
    }
    Ok(found)
}

/// Why a kernel cannot be searched.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
#[non_exhaustive]
pub enum SearchError {
    /// Its domain has no points.
    Empty(#[from] EmptyDomain),
    /// Its reference has no value at a point of its domain.
    Value(#[from] ValueError),
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::{Reference, measure};
    use crate::catalogue::{Entry, fixture};
    use closedform_project::sample::sample;

    fn target(entry: &Entry) -> Target<'_> {
        let (reference, domain) = (Reference::of(&entry.kernel).unwrap(), entry.domain().unwrap());
        Target { kernel: &entry.kernel, reference, domain, inputs: entry.inputs() }
    }

    fn worst(found: &Found) -> Vec<f64> {
        found.worst.iter().map(|worst| worst.first().map_or(0.0, |worst| worst.ulp)).collect()
    }

    #[test]
    fn searches_find_worse_than_samples_and_always_the_same() {
        let (_folder, catalogue) = fixture::catalogue();
        let target = target(catalogue.find("line::root").unwrap());
        let searched = search(&target, &[], Budget::Steps(20_000), 1).unwrap();
        let points = sample(&target.domain, &target.inputs.iter().collect::<Vec<_>>(), 2000, 1).unwrap();
        let sampled = measure(target.kernel, &target.reference, &points, || ()).unwrap().worst[0].clone().unwrap();
        assert!(worst(&searched)[0] > sampled.ulp, "{:?} {}", worst(&searched), sampled.ulp);
        assert_eq!(worst(&search(&target, &[], Budget::Steps(20_000), 1).unwrap()), worst(&searched));
        assert_eq!(searched.looked, 20_000);
    }

    #[test]
    fn what_is_known_is_not_lost() {
        let (_folder, catalogue) = fixture::catalogue();
        let target = target(catalogue.find("plane::slope").unwrap());
        let found = search(&target, &[vec![], vec![vec![5.0], vec![f64::NAN]]], Budget::Steps(0), 1).unwrap();
        assert_eq!(worst(&found)[0], 0.0);
        assert!(found.worst[0].is_empty() && found.worst[1].len() == 1, "{found:?}");
    }

    #[test]
    fn a_zero_is_searched_too() {
        let source = "#[kernel(maxima = \"f(x):=0*x\")]\npub fn f(x: f64) -> f64 { 0.0 * x }";
        let kernel = closedform_syntax::parse_file(source).unwrap().remove(0);
        let target = Target {
            reference: Reference::of(&kernel).unwrap(),
            domain: closedform_project::domain::Domain::new(vec!["x".to_owned()], Vec::new()),
            inputs: target(fixture::catalogue().1.find("plane::slope").unwrap()).inputs,
            kernel: &kernel,
        };
        assert_eq!(search(&target, &[], Budget::Steps(200), 1).unwrap().worst[0].len(), 1);
    }
}
