//! Random numbers of the judges: the same for the same seed and purpose, on every platform.

use std::env;

/// The variable that sets another seed.
pub const VARIABLE: &str = "CLOSEDFORM_SEED";

/// The random seed: that of the environment in decimal, else always the same one.
pub fn seed() -> u64 {
    match env::var(VARIABLE) {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("{VARIABLE}={text}: give a whole number")),
        Err(_) => 1,
    }
}

/// The project's stream of random numbers, by purpose, with what makers of inputs ask of it.
#[derive(Clone, Debug)]
pub struct Random(closedform_project::sample::Random);

impl Random {
    /// Numbers that depend on `seed` and on `purpose`, so that kernels and makers do not share theirs.
    pub fn new(seed: u64, purpose: &str) -> Self {
        Random(closedform_project::sample::Random::new(closedform_syntax::fnv_1a(purpose) ^ seed))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.bits()
    }

    /// A number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.0.below(count as u64) as usize
    }

    /// A real from 0 to less than 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A real between two others.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// True in one of `count` cases.
    pub fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    /// One of `items`.
    pub fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        self.0.pick(items)
    }
}
