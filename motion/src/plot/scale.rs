//! Scales: which values an axis shows, its ticks at round numbers, and what they say.

use std::ops::Range;

use plotters::coord::ranged1d::{BoldPoints, KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{IntoLogRange, LogCoord};

use super::unit::{fixed, power_of_ten};

/// Ticks are told apart by no more decimals than this.
const MOST_DECIMALS: i32 = 12;

/// The values of an axis.
#[derive(Clone)]
pub(super) struct Scale {
    coordinate: Coordinate,
    ticks: Vec<f64>,
}

/// How values become pixels.
#[derive(Clone)]
enum Coordinate {
    Linear(RangedCoordf64),
    Logarithmic(Range<f64>),
}

impl Scale {
    /// Equal steps for equal differences, and at most so many ticks.
    pub(super) fn linear((low, high): (f64, f64), ticks: usize) -> Self {
        let coordinate = RangedCoordf64::from(low..high);
        Self { ticks: coordinate.key_points(BoldPoints(ticks)), coordinate: Coordinate::Linear(coordinate) }
    }

    /// Equal steps for equal ratios, of positive values.
    pub(super) fn logarithmic((low, high): (f64, f64), ticks: usize) -> Self {
        let range = low..high;
        Self { ticks: logarithmic(&range).key_points(BoldPoints(ticks)), coordinate: Coordinate::Logarithmic(range) }
    }

    /// How many ticks it has.
    pub(super) fn ticks(&self) -> usize {
        self.ticks.len()
    }

    /// Whether 0 is between its ends.
    pub(super) fn has_zero(&self) -> bool {
        self.range().contains(&0.0)
    }

    /// As many as it takes to tell the ticks apart.
    fn decimals(&self) -> usize {
        let step = match self.ticks.as_slice() {
            [first, second, ..] => second - first,
            [only] => *only,
            [] => 1.0,
        };
        let is_whole = |decimals: &i32| {
            let scaled = step * 10_f64.powi(*decimals);
            (scaled - scaled.round()).abs() <= 1e-6 * scaled.abs()
        };
        (0..MOST_DECIMALS).find(is_whole).unwrap_or(MOST_DECIMALS) as usize
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        match &self.coordinate {
            Coordinate::Linear(coordinate) => coordinate.map(value, limit),
            Coordinate::Logarithmic(range) => logarithmic(range).map(value, limit),
        }
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.max_num_points() == 0 { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        match &self.coordinate {
            Coordinate::Linear(coordinate) => coordinate.range(),
            Coordinate::Logarithmic(range) => range.clone(),
        }
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, value: &f64) -> String {
        match self.coordinate {
            Coordinate::Linear(_) => fixed(*value, self.decimals()),
            Coordinate::Logarithmic(_) => power_of_ten(value.log10().round() as i32),
        }
    }
}

fn logarithmic(range: &Range<f64>) -> LogCoord<f64> {
    LogCoord::from(range.clone().log_scale())
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

    fn labels(scale: &Scale) -> Vec<String> {
        scale.ticks.iter().map(|tick| scale.format_ext(tick)).collect()
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(labels(&Scale::linear((-0.12, 0.31), 5)), ["−0.1", "0.0", "0.1", "0.2", "0.3"]);
        assert_eq!(labels(&Scale::linear((-60.0, 60.0), 5)), ["−50", "0", "50"]);
    }

    #[test]
    fn decades_are_ticked() {
        assert_eq!(labels(&Scale::logarithmic((0.5, 2e6), 4)), ["1", "10²", "10⁴", "10⁶"]);
        assert_eq!(labels(&Scale::logarithmic((0.5, 20.0), 4)), ["1", "10"]);
    }
}
