//! Triggers: when pixels begin, at constant velocity on the lines.

use super::planned::{RasterPlan, count_of};
use crate::segment::State;

/// When and where a pixel begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trigger {
    /// Counted from 0.
    pub line: u64,
    /// Counted from 0, along the direction of the line.
    pub pixel: u64,
    /// In s, from the start of the raster.
    pub time: f64,
    /// Of the fly axis and of the step axis, in m.
    pub position: [f64; 2],
}

impl RasterPlan {
    /// When a line begins, in s: the fly axis has come to the scan velocity before, or just then.
    #[must_use]
    pub fn line_start(&self, line: u64) -> f64 {
        let count = count_of(&self.lead_in) + line as f64 * self.count;
        let beyond = (self.steady_time - self.line_time) / 2.0;
        // of the quotient that is the time on the line
        let rounding = 8.0 * f64::EPSILON * self.steady_time;
        self.clock.seconds(count) + if beyond > rounding { beyond } else { 0.0 }
    }

    /// The begin of each of so many pixels of every line, in their order.
    pub fn triggers(&self, pixels: u64) -> impl Iterator<Item = Trigger> + '_ {
        let share = move |pixel: u64| pixel as f64 / pixels as f64;
        let at = move |line, pixel| {
            let along = State::rest(self.scan.line_length.abs() * share(pixel));
            Trigger {
                line,
                pixel,
                time: self.line_start(line) + self.line_time * share(pixel),
                position: [self.fly(line, along).position, self.step_position(line)],
            }
        };
        (0..self.scan.lines).flat_map(move |line| (0..pixels).map(move |pixel| at(line, pixel)))
    }
}
