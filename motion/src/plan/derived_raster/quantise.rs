//! Times that are multiples of a tick: rounded up, with velocities and accelerations recomputed downwards.
//!
//! A half keeps the ratio of the decelerations at the ends of its ramp out. With longer ramps, or a lower velocity,
//! both are then smaller: no limit is passed, and the half closes.

use super::{DerivedRaster, DerivedRasterPlan, Frame, Half, Ramps};
use crate::error::PlanError;

impl DerivedRaster {
    /// The halves of a plan without a tick, on it.
    pub(super) fn quantised(&self, free: &DerivedRasterPlan, tick: f64) -> Result<Frame, PlanError> {
        let longest = free.period.max(free.line_time);
        if longest / tick > (1_u64 << 53) as f64 {
            let remedy = "give a longer tick: a period of the raster has more of them than 2^53";
            return Err(PlanError::Input { name: "tick", value: tick, remedy });
        }
        let on_tick = |half: &Half, velocity: f64, limit: f64| {
            Half::of_ratio(velocity, up(half.t_in, tick), up(half.t_out, tick), half.ratio(), limit)
        };
        let coarse = |half: &Half, velocity: f64| on_tick(half, velocity, self.a1_max);
        // at velocity 1 distances are times
        let unit = |half: &Half| on_tick(half, 1.0, f64::INFINITY);
        let start = free.back.map_or(free.turn.leaving, |back| back.turn.entering);
        let ends = [unit(&free.turn.leaving), unit(&start)];
        // ramps inside of the line, as time at its velocity
        let inside = if self.ramps == Ramps::Inside { ends[0].d1_in + ends[1].d1_in } else { 0.0 };
        let line_time = up((self.line_length / self.v1_scan - inside).max(tick), tick);
        let v1_scan = (self.line_length / (line_time + inside)).min(self.v1_scan);
        let line = coarse(&free.turn.leaving, v1_scan);
        let Some(back) = free.back else { return Frame::new(self, line, None, line_time, 0.0) };
        let after = coarse(&start, v1_scan);
        let [away, before] = [free.turn.entering, back.turn.leaving];
        let outside = |half: &Half| half.d1_out + if self.ramps == Ramps::Outside { half.d1_in } else { 0.0 };
        // between the two places where the fly axis rests
        let way = self.line_length + (outside(&line) + outside(&after));
        let ramps = [unit(&away), unit(&before)].iter().map(|half| half.d1_in + half.d1_out).sum::<f64>();
        let back_time = up((way / back.v1_return - ramps).max(tick), tick);
        let v1_return = (way / (back_time + ramps)).min(back.v1_return);
        let halves = [coarse(&away, v1_return), coarse(&before, v1_return), after];
        Frame::new(self, line, Some(halves), line_time, back_time)
    }
}

/// The least multiple of a tick that is not less than a positive time; one that is a multiple but for 4 units in the
/// last place, the rounding of the quotient and of the time itself, counts as that multiple.
pub(super) fn up(time: f64, tick: f64) -> f64 {
    (time / tick * (1.0 - 4.0 * f64::EPSILON)).ceil() * tick
}
