//! Climbs towards the worst error of one result, and the local maxima they reach.

use super::budget::Allowance;
use super::moves::Mover;
use super::starts::Starts;
use super::target::Target;
use crate::accuracy::{ValueError, Worst};
use closedform_project::sample::{EmptyDomain, Random};

/// Moves in a row that gain nothing before a climb ends.
const PATIENCE: usize = 600;

/// How much more patient a climb from a maximum is.
const PERSEVERANCE: usize = 4;

/// Starts of which the best is climbed from.
const TOURNAMENT: usize = 16;

/// Local maxima that are kept to climb on from.
const POOL: usize = 12;

/// Where a climber is.
#[derive(Clone, Debug)]
struct Place {
    inputs: Vec<f64>,
    /// The estimated error, in ulp.
    score: f64,
}

/// A climber of one result.
pub(super) struct Climber<'a> {
    target: &'a Target<'a>,
    result: usize,
    mover: Mover<'a>,
    starts: Starts,
    random: Random,
    /// Where climbs ended, worst first: confirmed by the reference.
    pool: Vec<Worst>,
}

impl<'a> Climber<'a> {
    pub(super) fn new(target: &'a Target<'a>, result: usize, seed: u64) -> Result<Self, EmptyDomain> {
        let starts = Starts::new(target, seed)?;
        Ok(Climber { target, result, mover: Mover::new(target), starts, random: Random::new(seed), pool: Vec::new() })
    }

    /// Climbs until the allowance is empty, after a look at the known points; the worst points, worst first.
    ///
    /// # Errors
    ///
    /// When the reference has no value at a point.
    pub(super) fn climb(mut self, known: &[Vec<f64>], allowance: &mut Allowance) -> Result<Vec<Worst>, ValueError> {
        known.iter().try_for_each(|point| self.keep(point))?;
        while allowance.pay() {
            let (start, patience) = match self.maximum() {
                Some(maximum) => (self.visit(maximum), PERSEVERANCE * PATIENCE),
                None => (self.tournament(allowance), PATIENCE),
            };
            if let Some(start) = start {
                let reached = self.ascend(start, patience, allowance);
                self.keep(&reached.inputs)?;
            }
        }
        Ok(self.pool)
    }

    /// Every other time a point of the pool, the worse the likelier.
    fn maximum(&mut self) -> Option<Vec<f64>> {
        if self.random.below(2) == 0 {
            return None;
        }
        let count = self.pool.len() as u64;
        let place = self.random.below(count).min(self.random.below(count));
        self.pool.get(place as usize).map(|worst| worst.inputs.clone())
    }

    /// The best of some new points.
    fn tournament(&mut self, allowance: &mut Allowance) -> Option<Place> {
        let mut best: Option<Place> = None;
        for _ in 0..TOURNAMENT {
            if !allowance.pay() {
                break;
            }
            let point = self.starts.next(self.target, &mut self.random);
            let visited = self.visit(point);
            best = best.into_iter().chain(visited).max_by(|a, b| a.score.total_cmp(&b.score));
        }
        best
    }

    /// The point with its error, if it counts.
    fn visit(&self, inputs: Vec<f64>) -> Option<Place> {
        let score = self.target.estimate(self.result, &inputs)?;
        self.target.counts(&inputs).then_some(Place { inputs, score })
    }

    fn ascend(&mut self, mut place: Place, patience: usize, allowance: &mut Allowance) -> Place {
        let mut vain = 0;
        while vain < patience && allowance.pay() {
            let other = self.pool.get(self.random.below(POOL as u64) as usize).map(|worst| &worst.inputs[..]);
            let inputs = self.mover.moved(&place.inputs, other, &mut self.random);
            vain += 1;
            let Some(score) = self.target.estimate(self.result, &inputs) else { continue };
            if score >= place.score && inputs != place.inputs && self.target.counts(&inputs) {
                vain = if score > place.score { 0 } else { vain };
                place = Place { inputs, score };
            }
        }
        place
    }

    /// Adds a point to the pool, with its true error, if the bound covers it and the pool has no equal of it: points of
    /// one error are mostly one point in other units.
    fn keep(&mut self, point: &[f64]) -> Result<(), ValueError> {
        let errors = self.target.confirm(point)?;
        let found = errors.and_then(|errors| errors.into_iter().nth(self.result));
        let new = found.filter(|found| self.pool.iter().all(|worst| worst.ulp != found.ulp));
        self.pool.extend(new);
        self.pool.sort_by(|a, b| b.ulp.total_cmp(&a.ulp));
        self.pool.truncate(POOL);
        Ok(())
    }
}
