//! The attack on a mutant that all points let pass: a climb to where it is farthest from the kernel.

use closedform_syntax::Kernel;

use super::error::MutateError;
use super::judge::Judge;
use super::points::{Maker, moderate};
use closedform_measure::accuracy::results;

/// How often a move goes along the zeros of a part instead of anywhere.
const SLIDES: usize = 4;

/// How hard a mutant is attacked.
#[derive(Clone, Copy, Debug)]
pub struct Attack {
    /// How often an edge is looked for, of the kernel's domain and of the mutant's.
    pub edges: usize,
    /// How many points are tried at which two parts nearly vanish.
    pub double_zeros: usize,
    /// From how many points a climb starts.
    pub climbs: usize,
    /// How many steps each takes.
    pub steps: usize,
}

/// Whether an edge or a climb finds a point that tells the mutant from a right kernel.
///
/// # Errors
///
/// When the kernel itself is wrong where the mutant is.
pub fn attack(judge: &mut Judge, maker: &mut Maker, mutant: &Kernel, with: Attack) -> Result<bool, MutateError> {
    if differs_at_edges(judge, maker, mutant, with.edges)?
        || differs_at_double_zeros(judge, maker, mutant, with.double_zeros)?
    {
        return Ok(true);
    }
    for start in judge.farthest(mutant, with.climbs) {
        let (mut at, mut height) = (start.clone(), judge.distance(mutant, &start));
        for step in 0..with.steps {
            let slid = if step % SLIDES == 0 { maker.slide(&at) } else { None };
            let next = slid.unwrap_or_else(|| maker.step(&at));
            let reached = if moderate(&next) { judge.distance(mutant, &next) } else { 0.0 };
            if reached > height && judge.kills_with(mutant, &next)? {
                return Ok(true);
            }
            if reached >= height && reached.is_finite() {
                (at, height) = (next, reached);
            }
        }
    }
    Ok(false)
}

/// Whether a point tells at which two parts nearly vanish.
fn differs_at_double_zeros(
    judge: &mut Judge,
    maker: &mut Maker,
    mutant: &Kernel,
    count: usize,
) -> Result<bool, MutateError> {
    for point in (0..count).filter_map(|_| maker.double_zero()).collect::<Vec<_>>() {
        if judge.distance(mutant, &point) > 0.0 && judge.kills_with(mutant, &point)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether a neighbour of an edge tells, be it an edge of the kernel's domain or of the mutant's.
fn differs_at_edges(judge: &mut Judge, maker: &mut Maker, mutant: &Kernel, count: usize) -> Result<bool, MutateError> {
    for turn in 0..count {
        let decider = if turn % 2 == 0 { judge.kernel() } else { mutant };
        let edge = maker.edge(|point| results(decider, point).is_ok());
        for point in edge.into_iter().flatten().filter(|point| moderate(point)) {
            if judge.distance(mutant, &point) > 0.0 && judge.kills_with(mutant, &point)? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}
