//! A sum that loses no digits, however many numbers it has.

/// A sum with a second number for what the first one rounds off (Neumaier).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// Adds a number.
    pub(super) fn add(&mut self, number: f64) {
        let sum = self.high + number;
        let (large, small) = if self.high.abs() >= number.abs() { (self.high, number) } else { (number, self.high) };
        self.low += (large - sum) + small;
        self.high = sum;
    }

    /// The sum so far.
    pub(super) fn value(&self) -> f64 {
        self.high + self.low
    }
}
