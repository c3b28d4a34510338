//! The judge: points of a kernel, what is right at each, computed once, and mutants held to it.

use std::cell::OnceCell;

use closedform_syntax::{Kernel, Violation};
use rug::Float;

use super::error::MutateError;
use super::points::Points;
use closedform_measure::accuracy::{REFERENCE_BITS, Reference, covers, results, ulp_error, ulp_text};
use closedform_measure::catalogue::Entry;
use closedform_project::domain::Domain;

/// The share of its bound by which a result must move before its reference is asked.
const MOVED: f64 = 0.25;

/// A point, and what the kernel makes of it.
struct Point {
    inputs: Vec<f64>,
    /// The results, or the first condition that is violated.
    right: Result<Vec<f64>, usize>,
    /// The values of the reference, once they were asked for; `None` where it has none.
    expected: OnceCell<Option<Vec<Float>>>,
}

/// The judge of one kernel and its mutants.
pub struct Judge<'a> {
    entry: &'a Entry,
    kernel: &'a Kernel,
    domain: Domain,
    reference: Reference,
    bounds: Vec<f64>,
    /// The points that killed last come first.
    points: Vec<Point>,
}

impl<'a> Judge<'a> {
    /// The judge of a kernel at these points.
    ///
    /// # Errors
    ///
    /// When the kernel has no domain or reference, or decides its domain otherwise than its contract.
    pub fn new(entry: &'a Entry, points: &Points) -> Result<Self, MutateError> {
        let kernel = &entry.kernel;
        let bounds = kernel.meta.results.iter().map(|result| result.bound.unwrap_or(f64::INFINITY)).collect();
        let (domain, reference) = (entry.domain()?, Reference::of(kernel)?);
        let mut judge = Judge { entry, kernel, domain, reference, bounds, points: Vec::new() };
        for inputs in &points.list {
            judge.points.extend(judge.point(inputs)?);
        }
        Ok(judge)
    }

    /// The kernel itself.
    pub fn kernel(&self) -> &Kernel {
        self.kernel
    }

    /// A point with what is right there; `None` where the promise does not cover it.
    fn point(&self, inputs: &[f64]) -> Result<Option<Point>, MutateError> {
        if !covers(self.kernel, inputs) {
            return Ok(None);
        }
        let (decided, right) = (self.domain.violated(inputs), results(self.kernel, inputs));
        let agreed = match (&right, decided) {
            (Ok(_), None) => true,
            (Err(Violation::Require(at)), Some(decided)) => *at == decided,
            _ => false,
        };
        if !agreed {
            return Err(self.guilty(inputs, format!("{right:?}, but the contract says {decided:?}")));
        }
        let right = right.map_err(|_| decided.unwrap_or_default());
        Ok(Some(Point { inputs: inputs.to_vec(), right, expected: OnceCell::new() }))
    }

    fn guilty(&self, inputs: &[f64], what: String) -> MutateError {
        let inputs = self.kernel.inputs.iter().zip(inputs).map(|(input, value)| format!("{} = {value:?}", input.name));
        MutateError::Guilty { kernel: self.entry.full_name(), inputs: inputs.collect::<Vec<_>>().join(", "), what }
    }

    /// Whether a point tells the mutant from a right kernel.
    ///
    /// # Errors
    ///
    /// When the kernel itself is wrong where a mutant is.
    pub fn kills(&mut self, mutant: &Kernel) -> Result<bool, MutateError> {
        for at in 0..self.points.len() {
            if self.kills_at(mutant, &self.points[at])? {
                self.points[..=at].rotate_right(1);
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether one more point tells.
    ///
    /// # Errors
    ///
    /// As [`kills`](Self::kills).
    pub fn kills_with(&mut self, mutant: &Kernel, inputs: &[f64]) -> Result<bool, MutateError> {
        let Some(point) = self.point(inputs)? else { return Ok(false) };
        let kills = self.kills_at(mutant, &point)?;
        if kills {
            self.points.insert(0, point);
        }
        Ok(kills)
    }

    /// The points inside at which the mutant is farthest from the kernel, farthest first.
    pub fn farthest(&self, mutant: &Kernel, count: usize) -> Vec<Vec<f64>> {
        let inside = self.points.iter().filter(|point| point.right.is_ok());
        let mut ranked: Vec<(f64, &Point)> =
            inside.map(|point| (self.distance(mutant, &point.inputs), point)).collect();
        ranked.sort_by(|(one, _), (other, _)| other.total_cmp(one));
        ranked.into_iter().take(count).map(|(_, point)| point.inputs.clone()).collect()
    }

    /// How far the mutant's results are from the kernel's, in units of its bounds; infinite where only one decides that
    /// the point is in its domain.
    pub fn distance(&self, mutant: &Kernel, inputs: &[f64]) -> f64 {
        match (results(self.kernel, inputs), results(mutant, inputs)) {
            (Ok(right), Ok(got)) => {
                let moved =
                    right.iter().zip(&got).zip(&self.bounds).map(|((right, got), bound)| apart(*right, *got) / bound);
                moved.fold(0.0, f64::max)
            }
            (Err(right), Err(got)) if right == got => 0.0,
            _ => f64::INFINITY,
        }
    }

    fn kills_at(&self, mutant: &Kernel, point: &Point) -> Result<bool, MutateError> {
        match (results(mutant, &point.inputs), &point.right) {
            (Err(Violation::Require(got)), Err(right)) => Ok(got != *right),
            (Ok(got), Ok(right)) => self.is_beyond(mutant, point, &got, right),
            _ => Ok(true),
        }
    }

    /// Whether a result of the mutant is beyond its bound.
    fn is_beyond(&self, mutant: &Kernel, point: &Point, got: &[f64], right: &[f64]) -> Result<bool, MutateError> {
        let moved = got.iter().zip(right).zip(&self.bounds);
        if !{ moved }.any(|((got, right), bound)| apart(*right, *got) > MOVED * bound) {
            return Ok(false);
        }
        let Some(expected) = self.expected(point, right)? else { return Ok(false) };
        let beyond = got.iter().zip(expected).zip(&self.bounds);
        let beyond = { beyond }.any(|((got, expected), bound)| ulp_error(*got, expected) > *bound);
        // What is no number is no matter of over- or underflow at these magnitudes.
        Ok(beyond && (got.iter().any(|got| got.is_nan()) || covers(mutant, &point.inputs)))
    }

    /// The values of the reference, to which the kernel itself is held first.
    fn expected<'p>(&self, point: &'p Point, right: &[f64]) -> Result<Option<&'p Vec<Float>>, MutateError> {
        if let Some(expected) = point.expected.get() {
            return Ok(expected.as_ref());
        }
        let values = match self.reference.values(&point.inputs, REFERENCE_BITS) {
            Ok(values) => Some(values),
            Err(_) if right.iter().all(|value| !value.is_finite()) => None,
            Err(cause) => return Err(self.guilty(&point.inputs, cause.to_string())),
        };
        for ((got, expected), bound) in right.iter().zip(values.iter().flatten()).zip(&self.bounds) {
            let ulp = ulp_error(*got, expected);
            if ulp > *bound {
                return Err(self.guilty(&point.inputs, format!("{} ulp beyond the bound {bound}", ulp_text(ulp))));
            }
        }
        Ok(point.expected.get_or_init(|| values).as_ref())
    }
}

/// How many ulp two results are apart.
fn apart(right: f64, got: f64) -> f64 {
    if right.to_bits() == got.to_bits() {
        return 0.0;
    }
    let spacing = right.abs().next_up() - right.abs();
    let apart = (got - right).abs() / spacing;
    if apart.is_nan() { f64::INFINITY } else { apart }
}
