//! Where climbs start: points at edges, zeros and near-equal inputs, and three samplings of the domain.

use super::target::Target;
use closedform_project::contract::Input;
use closedform_project::sample::{EmptyDomain, Random, sample};

/// Points of the typical magnitudes, half of them at edges.
const SPECIAL: usize = 64;

/// How often each coordinate is drawn anew.
const SWEEPS: usize = 3;

/// Draws of a coordinate before it stays.
const DRAWS: usize = 8;

/// A distribution of one coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sampling {
    /// Uniform over the bit patterns of finite numbers.
    Patterns,
    /// A sign times 2^U(-20, 20), uniform over bit patterns inside an octave.
    Octaves,
    /// Uniform over the reals up to the largest typical magnitude.
    Reals,
}

impl Sampling {
    /// All samplings.
    pub(super) const ALL: [Sampling; 3] = [Sampling::Patterns, Sampling::Octaves, Sampling::Reals];

    pub(super) fn draw(self, input: &Input, random: &mut Random) -> f64 {
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        match self {
            Sampling::Patterns => sign * random.magnitude([f64::from_bits(1), f64::MAX]),
            Sampling::Octaves => sign * random.magnitude([1.0 / f64::from(1 << 20), f64::from(1 << 20)]),
            Sampling::Reals => sign * input.typical[1] * ((random.bits() >> 11) as f64 / (1_u64 << 53) as f64),
        }
    }
}

/// A stream of starts.
pub(super) struct Starts {
    special: Vec<Vec<f64>>,
    turn: usize,
}

impl Starts {
    pub(super) fn new(target: &Target, seed: u64) -> Result<Self, EmptyDomain> {
        let inputs: Vec<&Input> = target.inputs.iter().collect();
        Ok(Starts { special: sample(&target.domain, &inputs, SPECIAL, seed)?, turn: 0 })
    }

    /// The next start: the special points and the samplings in turn.
    pub(super) fn next(&mut self, target: &Target, random: &mut Random) -> Vec<f64> {
        self.turn += 1;
        let base = random.pick(&self.special).clone();
        match Sampling::ALL.get(self.turn % (Sampling::ALL.len() + 1)) {
            Some(sampling) => resampled(target, base, *sampling, random),
            None => base,
        }
    }
}

/// A point of the sampling inside the domain, from any point inside: every coordinate is drawn anew in turn, which has
/// the sampling restricted to the domain as its limit.
fn resampled(target: &Target, mut point: Vec<f64>, sampling: Sampling, random: &mut Random) -> Vec<f64> {
    for input in (0..SWEEPS).flat_map(|_| 0..target.inputs.len()) {
        let before = point[input];
        for _ in 0..DRAWS {
            point[input] = sampling.draw(&target.inputs[input], random);
            if target.takes(&point) {
                break;
            }
            point[input] = before;
        }
    }
    point
}
