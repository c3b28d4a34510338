//! The same random numbers on every machine: splitmix64.

/// A stream of random numbers that its seed fixes.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in `0..limit`; 0 if there is none.
    pub fn below(&mut self, limit: u64) -> u64 {
        ((u128::from(self.bits()) * u128::from(limit)) >> 64) as u64
    }

    /// One of the choices.
    pub fn pick<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len() as u64) as usize]
    }

    /// A magnitude in `low..=high`, as likely in each octave: uniform over bit patterns, so no logarithm rounds it.
    pub fn magnitude(&mut self, [low, high]: [f64; 2]) -> f64 {
        let span = high.to_bits() - low.to_bits();
        f64::from_bits(low.to_bits() + self.below(span.saturating_add(1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_splitmix64() {
        let mut random = Random::new(1234567);
        let first: Vec<u64> = (0..3).map(|_| random.bits()).collect();
        assert_eq!(first, [6457827717110365317, 3203168211198807973, 9817491932198370423]);
    }

    #[test]
    fn magnitudes_fill_their_range() {
        let mut random = Random::new(0);
        let drawn: Vec<f64> = (0..1000).map(|_| random.magnitude([1e-3, 1e3])).collect();
        assert!(drawn.iter().all(|x| (1e-3..=1e3).contains(x)));
        let small = drawn.iter().filter(|x| **x < 1.0).count();
        assert!((400..600).contains(&small), "{small} of 1000 below the middle");
        assert_eq!(random.magnitude([2.0, 2.0]), 2.0);
    }
}
