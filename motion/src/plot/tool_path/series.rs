//! A curve over time that takes no more memory than a picture of it needs.

use crate::plot::curve::thinned;

/// Points that are held before those that nobody sees are left out.
const MOST: usize = 100_000;

/// Columns of the whole time within which nothing is told apart.
const COLUMNS: f64 = 4000.0;

/// Times and values.
#[derive(Debug, Clone, Default)]
pub(super) struct Series {
    points: Vec<(f64, f64)>,
}

impl Series {
    pub(super) fn push(&mut self, time: f64, value: f64) {
        if let [.., before, last] = self.points.as_mut_slice()
            && before.1 == value
            && last.1 == value
        {
            last.0 = time;
            return;
        }
        self.points.push((time, value));
        if self.points.len() > MOST {
            self.points = thinned(std::mem::take(&mut self.points), time / COLUMNS);
        }
    }

    pub(super) fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// The least and the largest value.
    pub(super) fn range(&self) -> (f64, f64) {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        self.points.iter().fold(start, |(low, high), (_, value)| (low.min(*value), high.max(*value)))
    }
}
