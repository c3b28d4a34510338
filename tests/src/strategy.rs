//! Input makers as proptest strategies, whose points shrink to round numbers without leaving the domain.

use proptest::prelude::{Strategy, any};
use proptest::strategy::{NewTree, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

use crate::check::Judge;
use crate::inputs::{Maker, Space, shortened};
use crate::random;

/// The points that a maker makes for a kernel.
#[derive(Debug)]
pub struct PointStrategy<'a> {
    space: &'a Space,
    maker: Maker,
}

/// A point on its way to a simpler one.
#[derive(Debug)]
pub struct PointTree<'a> {
    space: &'a Space,
    /// The simplest point that still fails.
    kept: Vec<f64>,
    /// The point on trial.
    trial: Vec<f64>,
    /// The simplifications of `kept` not tried yet.
    left: Vec<Vec<f64>>,
}

impl<'a> PointStrategy<'a> {
    /// The strategy of a maker that the kernel has points of.
    pub fn new(space: &'a Space, maker: Maker) -> Self {
        PointStrategy { space, maker }
    }
}

impl<'a> Strategy for PointStrategy<'a> {
    type Tree = PointTree<'a>;
    type Value = Vec<f64>;

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        let seed = any::<u64>().new_tree(runner)?.current();
        let point = self.space.inside(self.maker, seed, 1).list.remove(0);
        Ok(PointTree { space: self.space, left: simpler(self.space, &point), kept: point.clone(), trial: point })
    }
}

impl PointTree<'_> {
    /// Puts the next simplification on trial, or, after the last one, the simplest point that fails.
    fn advance(&mut self) -> bool {
        let next = self.left.pop();
        let more = next.is_some();
        self.trial = next.unwrap_or_else(|| self.kept.clone());
        more
    }
}

impl ValueTree for PointTree<'_> {
    type Value = Vec<f64>;

    fn current(&self) -> Vec<f64> {
        self.trial.clone()
    }

    fn simplify(&mut self) -> bool {
        self.kept = self.trial.clone();
        self.left = simpler(self.space, &self.kept);
        self.advance()
    }

    fn complicate(&mut self) -> bool {
        self.advance()
    }
}

/// Points inside the domain with one input simplified, the simplest last.
fn simpler(space: &Space, point: &[f64]) -> Vec<Vec<f64>> {
    let mut points = Vec::new();
    for bits in (0..52).rev() {
        for input in 0..point.len() {
            let candidates = if bits == 0 { vec![1.0, 0.0] } else { Vec::new() };
            for value in [vec![shortened(point[input], bits)], candidates].concat() {
                let mut candidate = point.to_vec();
                candidate[input] = value;
                if complexity(value) < complexity(point[input]) && space.admits(&candidate) {
                    points.push(candidate);
                }
            }
        }
    }
    points
}

/// How many bits a number has after its leading one; zero is the simplest, then one, then powers of two.
fn complexity(value: f64) -> u32 {
    match value {
        0.0 => 0,
        1.0 => 1,
        _ => 54 - (value.to_bits() | 1 << 52).trailing_zeros().min(52),
    }
}

/// Judges `count` points of a maker; a failure is shrunk first.
///
/// # Errors
///
/// The text of the failure.
pub fn shrink(judge: &Judge, maker: Maker, count: u32) -> Result<(), String> {
    let seed = random::seed();
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let config = Config { cases: count, failure_persistence: None, max_shrink_iters: 10_000, ..Config::default() };
    let origin = format!("proptest of {maker:?}, seed {seed}");
    let fails = |point: &[f64]| judge.errors(point, &origin).map(drop);
    let outcome = TestRunner::new_with_rng(config, rng).run(&PointStrategy::new(&judge.space, maker), |point| {
        fails(&point).map_err(|failure| TestCaseError::fail(failure.to_string()))
    });
    match outcome {
        Ok(()) => Ok(()),
        Err(TestError::Fail(_, point)) => Err(fails(&point).expect_err("a shrunk point still fails").to_string()),
        Err(TestError::Abort(reason)) => Err(reason.to_string()),
    }
}
