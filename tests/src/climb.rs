//! A search that climbs towards the worst error of a kernel by moves on the bits of its inputs.

use crate::check::Judge;
use crate::failure::Failure;
use crate::inputs::Points;
use crate::random::Random;

/// How far a climb got.
#[derive(Clone, Debug)]
pub struct Maximum {
    /// The errors of the results in ulp.
    pub errors: Vec<f64>,
    /// The inputs.
    pub inputs: Vec<f64>,
    /// The largest error as a fraction of its bound.
    pub score: f64,
}

/// Climbs from every start for so many steps; the highest maximum, none where there is no start.
///
/// # Errors
///
/// A point where a bound is broken.
pub fn climb(judge: &Judge, starts: &Points, steps: usize, seed: u64) -> Result<Option<Maximum>, Box<Failure>> {
    let mut random = Random::new(seed, judge.kernel.info.name);
    let origin = format!("climb from {}", starts.origin);
    let mut highest: Option<Maximum> = None;
    for start in &starts.list {
        let mut maximum = visit(judge, start.clone(), &origin)?;
        for _ in 0..steps {
            let moved = stepped(&maximum.inputs, &mut random);
            if !judge.space.admits(&moved) {
                continue;
            }
            let reached = visit(judge, moved, &origin)?;
            maximum = if reached.score >= maximum.score { reached } else { maximum };
        }
        highest = highest.filter(|highest| highest.score >= maximum.score).or(Some(maximum));
    }
    Ok(highest)
}

fn visit(judge: &Judge, inputs: Vec<f64>, origin: &str) -> Result<Maximum, Box<Failure>> {
    let errors = judge.errors(&inputs, origin)?;
    let shares = errors.iter().enumerate().map(|(result, ulp)| ulp / judge.bound(result));
    let score = shares.fold(0.0, f64::max);
    Ok(Maximum { errors, inputs, score })
}

/// The point with one input, or two, moved by their bits.
fn stepped(point: &[f64], random: &mut Random) -> Vec<f64> {
    let mut moved = point.to_vec();
    for _ in 0..=random.below(2) {
        let input = random.below(point.len());
        moved[input] = step(moved[input], random);
    }
    moved
}

fn step(value: f64, random: &mut Random) -> f64 {
    match random.below(8) {
        0 => value * 2.0,
        1 => value / 2.0,
        2 => value.next_up(),
        3 => value.next_down(),
        4 => f64::from_bits(value.to_bits().wrapping_add(1 << random.below(52))),
        5 => f64::from_bits(value.to_bits().wrapping_sub(1 << random.below(52))),
        _ => f64::from_bits(value.to_bits() ^ (1 << random.below(52))),
    }
}
