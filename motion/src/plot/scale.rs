//! Scales: from values to pixels, with ticks at round numbers.

use super::unit::{fixed, superscript, ten_to};

/// How values become pixels.
#[derive(Debug, Clone)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    /// The pixels of `low` and `high`.
    pixels: (f64, f64),
    logarithmic: bool,
}

/// Where a number stands, in pixels, and what it says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub at: f64,
    pub label: String,
    pub value: f64,
}

impl Scale {
    /// Equal steps for equal differences.
    pub(super) fn linear((low, high): (f64, f64), pixels: (f64, f64)) -> Self {
        Self { low, high, pixels, logarithmic: false }
    }

    /// Equal steps for equal ratios, of positive values.
    pub(super) fn logarithmic((low, high): (f64, f64), pixels: (f64, f64)) -> Self {
        Self { low: low.log10(), high: high.log10(), pixels, logarithmic: true }
    }

    pub(super) fn at(&self, value: f64) -> f64 {
        let value = if self.logarithmic { value.log10() } else { value };
        let share = (value - self.low) / (self.high - self.low);
        self.pixels.0 + share * (self.pixels.1 - self.pixels.0)
    }

    /// Pixels a unit, of a linear scale.
    pub(super) fn slope(&self) -> f64 {
        (self.pixels.1 - self.pixels.0) / (self.high - self.low)
    }

    /// At most about so many ticks.
    pub(super) fn ticks(&self, most: usize) -> Vec<Tick> {
        if self.logarithmic { self.decades(most) } else { self.round_numbers(most) }
    }

    fn round_numbers(&self, most: usize) -> Vec<Tick> {
        let (digit, exponent) = step(self.high - self.low, most);
        let step = digit * ten_to(exponent);
        let (first, last) = ((self.low / step - 1e-9).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
        let tick = |index: i64| {
            let value = index as f64 * digit * ten_to(exponent);
            Tick { at: self.at(value), label: fixed(value, usize::try_from(-exponent).unwrap_or(0)), value }
        };
        (first..=last).map(tick).collect()
    }

    fn decades(&self, most: usize) -> Vec<Tick> {
        let (first, last) = ((self.low - 1e-9).ceil() as i32, (self.high + 1e-9).floor() as i32);
        let every = (1..).find(|every| (last - first) / every < most as i32).unwrap_or(1);
        let label = |exponent: i32| match exponent {
            0 => "1".to_owned(),
            1 => "10".to_owned(),
            _ => format!("10{}", superscript(exponent)),
        };
        let tick = |exponent| Tick { at: self.at(ten_to(exponent)), label: label(exponent), value: ten_to(exponent) };
        (first..=last).filter(|exponent| exponent % every == 0).map(tick).collect()
    }
}

/// The least 1, 2 or 5 times a power of ten with no more than so many steps in a span.
fn step(span: f64, most: usize) -> (f64, i32) {
    let candidates = (-320..=308).flat_map(|exponent| [1.0, 2.0, 5.0].map(|digit| (digit, exponent)));
    let enough = |(digit, exponent): &(f64, i32)| span <= digit * ten_to(*exponent) * most as f64 * (1.0 + 1e-9);
    let start = candidates.clone().position(|candidate| enough(&candidate)).unwrap_or(0);
    candidates.clone().nth(start).unwrap_or((1.0, 308))
}

/// A range with room around it; one of no extent gets some.
pub(super) fn widened((low, high): (f64, f64), below: f64, above: f64) -> (f64, f64) {
    let extent = high - low;
    if extent > 0.0 && extent > high.abs().max(low.abs()) * 1e-12 {
        return (low - below * extent, high + above * extent);
    }
    let room = if high == 0.0 { 1.0 } else { high.abs() * 0.1 };
    (low - room, high + room)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_few() {
        let scale = Scale::linear((-0.12, 0.31), (0.0, 100.0));
        let labels: Vec<String> = scale.ticks(5).into_iter().map(|tick| tick.label).collect();
        assert_eq!(labels, ["−0.1", "0.0", "0.1", "0.2", "0.3"]);
    }

    #[test]
    fn decades_are_ticked() {
        let scale = Scale::logarithmic((0.5, 2e6), (0.0, 100.0));
        let labels: Vec<String> = scale.ticks(4).into_iter().map(|tick| tick.label).collect();
        assert_eq!(labels, ["1", "10²", "10⁴", "10⁶"]);
    }
}
