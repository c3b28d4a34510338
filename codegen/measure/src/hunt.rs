//! Hunting: a search that climbs towards the inputs at which the results of a kernel are worst.

mod budget;
mod climb;
mod estimate;
mod moves;
mod prey;
mod starts;
mod zeros;

use std::time::Instant;

use crate::accuracy::{ValueError, Worst};
use climb::Climber;
use closedform_project::sample::EmptyDomain;

pub use budget::{Budget, parse_duration};
pub use prey::Prey;

/// What a hunt brought home.
#[derive(Clone, Debug)]
pub struct Bag {
    /// For each result the worst points, worst first, all of them confirmed by the reference.
    pub worst: Vec<Vec<Worst>>,
    /// How many points were looked at.
    pub looked: u64,
}

/// Hunts all results of a kernel; `known` holds for each result the points to start from.
///
/// # Errors
///
/// When the domain has no points, or the reference no value at one.
pub fn hunt(prey: &Prey, known: &[Vec<Vec<f64>>], budget: Budget, seed: u64) -> Result<Bag, HuntError> {
    let begin = Instant::now();
    let results = prey.kernel.meta.results.len();
    let mut bag = Bag { worst: Vec::new(), looked: 0 };
    for result in 0..results {
        let mut purse = budget.purse(begin, results - result);
        let known = known.get(result).map_or(&[][..], |known| known);
        let seed = seed.wrapping_add(result as u64 * 0x1_0000);
        bag.worst.push(Climber::new(prey, result, seed)?.climb(known, &mut purse)?);
        bag.looked += purse.spent();
    }
    Ok(bag)
}

/// Why a kernel cannot be hunted.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
pub enum HuntError {
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

    fn prey(entry: &Entry) -> Prey<'_> {
        let (reference, domain) = (Reference::of(&entry.kernel).unwrap(), entry.domain().unwrap());
        Prey { kernel: &entry.kernel, reference, domain, inputs: entry.inputs() }
    }

    fn worst(bag: &Bag) -> Vec<f64> {
        bag.worst.iter().map(|worst| worst.first().map_or(0.0, |worst| worst.ulp)).collect()
    }

    #[test]
    fn hunts_find_worse_than_samples_and_always_the_same() {
        let (_folder, catalogue) = fixture::catalogue();
        let prey = prey(catalogue.find("line::root").unwrap());
        let hunted = hunt(&prey, &[], Budget::Steps(20_000), 1).unwrap();
        let points = sample(&prey.domain, &prey.inputs.iter().collect::<Vec<_>>(), 2000, 1).unwrap();
        let sampled = measure(prey.kernel, &prey.reference, &points, || ()).unwrap().worst[0].clone().unwrap();
        assert!(worst(&hunted)[0] > sampled.ulp, "{:?} {}", worst(&hunted), sampled.ulp);
        assert_eq!(worst(&hunt(&prey, &[], Budget::Steps(20_000), 1).unwrap()), worst(&hunted));
        assert_eq!(hunted.looked, 20_000);
    }

    #[test]
    fn what_is_known_is_not_lost() {
        let (_folder, catalogue) = fixture::catalogue();
        let prey = prey(catalogue.find("plane::slope").unwrap());
        let bag = hunt(&prey, &[vec![], vec![vec![5.0], vec![f64::NAN]]], Budget::Steps(0), 1).unwrap();
        assert_eq!(worst(&bag)[0], 0.0);
        assert!(bag.worst[0].is_empty() && bag.worst[1].len() == 1, "{bag:?}");
    }

    #[test]
    fn a_zero_is_hunted_too() {
        let source = "#[kernel(maxima = \"f(x):=0*x\")]\npub fn f(x: f64) -> f64 { 0.0 * x }";
        let kernel = closedform_syntax::parse_file(source).unwrap().remove(0);
        let prey = Prey {
            reference: Reference::of(&kernel).unwrap(),
            domain: closedform_project::domain::Domain::new(vec!["x".to_owned()], Vec::new()),
            inputs: prey(fixture::catalogue().1.find("plane::slope").unwrap()).inputs,
            kernel: &kernel,
        };
        assert_eq!(hunt(&prey, &[], Budget::Steps(200), 1).unwrap().worst[0].len(), 1);
    }
}
