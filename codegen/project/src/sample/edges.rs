//! Edges of a domain: where one of its comparisons changes between true and false.

use rug::Rational;

use super::super::domain::{Comparison, Condition, Domain, exact};
use super::bisect::bisect;

/// The comparisons of a domain, and how each depends on single inputs.
pub(super) struct Edges<'a> {
    comparisons: Vec<&'a Comparison>,
    /// For each comparison the inputs that it names.
    named: Vec<Vec<usize>>,
    /// The conditions that name one input only, with that input.
    alone: Vec<(usize, &'a Condition)>,
}

impl<'a> Edges<'a> {
    pub(super) fn new(domain: &'a Domain) -> Self {
        let comparisons = domain.comparisons();
        let inputs = domain.variables().len();
        let alone = domain.conditions().filter_map(|condition| match named(&condition.comparisons(), inputs)[..] {
            [input] => Some((input, condition)),
            _ => None,
        });
        let alone = alone.collect();
        Self { named: comparisons.iter().map(|comparison| named(&[comparison], inputs)).collect(), alone, comparisons }
    }

    pub(super) fn len(&self) -> usize {
        self.comparisons.len()
    }

    /// The inputs that a comparison names.
    pub(super) fn inputs(&self, edge: usize) -> &[usize] {
        &self.named[edge]
    }

    /// The first comparison that does not hold.
    pub(super) fn violated(&self, point: &[f64]) -> Option<usize> {
        let point = exact(point)?;
        self.comparisons.iter().position(|comparison| !comparison.holds(&point))
    }

    /// Whether the conditions that name this input alone hold.
    pub(super) fn allowed_alone(&self, input: usize, value: f64) -> bool {
        let Some(value) = Rational::from_f64(value) else { return false };
        let point = vec![value; input + 1];
        self.alone.iter().filter(|(named, _)| *named == input).all(|(_, condition)| condition.holds(&point))
    }

    /// The value of an input at which the sides of a comparison are equal, if they differ by a linear function of it.
    pub(super) fn solve(&self, edge: usize, input: usize, point: &[f64]) -> Option<f64> {
        let mut moved = exact(point)?;
        let mut difference = |value: i32| {
            moved[input] = Rational::from(value);
            self.comparisons[edge].difference_at(&moved)
        };
        let (first, second, third) = (difference(1)?, difference(2)?, difference(4)?);
        let slope = Rational::from(&second - &first);
        let linear = third - second == Rational::from(&slope + &slope);
        if !linear || slope.is_zero() {
            return None;
        }
        let at = (Rational::from(1) - first / slope).to_f64();
        at.is_finite().then_some(at)
    }

    /// The last value, going from the point's own towards `other`, at which the comparison is as at the point.
    pub(super) fn bisect(&self, edge: usize, input: usize, point: &[f64], other: f64) -> Option<f64> {
        let mut moved = exact(point)?;
        let holds = |value: f64| {
            moved[input] = Rational::from_f64(value)?;
            Some(self.comparisons[edge].holds(&moved))
        };
        bisect(point[input], other, holds).map(|[near, _]| near)
    }
}

/// The inputs that one of the comparisons names.
fn named(comparisons: &[&Comparison], inputs: usize) -> Vec<usize> {
    (0..inputs).filter(|input| comparisons.iter().any(|comparison| comparison.uses(*input))).collect()
}
