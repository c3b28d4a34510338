//! A planned raster: its times, and its parts on the clock.

use super::gap::{FlyGap, Step, Timed, lead, timed};
use super::input::{Order, RasterScan};
use crate::error::PlanError;
use crate::plan::check::{in_range, segments_in_range};
use crate::plan::clock::Clock;
use crate::plan::fastest::Fastest;
use crate::segment::{Segment, State};

/// Which axis sets the time between two lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slower {
    /// The fly axis, which turns around: the step axis has time to spare.
    Fly,
    /// The step axis, with its time to settle: the fly axis has time to spare.
    Step,
    /// Both, but for a tick.
    Both,
}

/// A planned raster scan.
#[derive(Debug, Clone, PartialEq)]
pub struct RasterPlan {
    /// What was asked for.
    pub scan: RasterScan,
    /// Time on the line itself, in s: its length by the scan velocity.
    pub line_time: f64,
    /// Time at the scan velocity, in s: that of the line, the run-ups, and what the tick adds to them.
    pub steady_time: f64,
    /// Time that the fly axis is not at the scan velocity between two lines, in s.
    pub turn_time: f64,
    /// From the start of a line to the start of the next, in s.
    pub period: f64,
    /// From rest before the first line to rest after the last, in s.
    pub duration: f64,
    /// What of the period is not the line itself, in s.
    pub overhead: f64,
    /// What the tick and the shortest time of a row add to the raster, in s.
    pub tick_cost: f64,
    /// Which axis sets the time between two lines; none where there is one line only.
    pub slower: Option<Slower>,
    pub(super) clock: Clock,
    /// From the start of the steady part to its end, on the clock.
    pub(super) steady: Timed,
    pub(super) lead_in: Vec<Timed>,
    pub(super) lead_out: Vec<Timed>,
    /// From the end of the steady part on.
    pub(super) gap: Vec<Timed>,
    /// The step, from its own start on.
    pub(super) step: Vec<Timed>,
    /// How long before the end of the steady part the step starts.
    pub(super) ahead: f64,
    /// Count of a period.
    pub(super) count: f64,
}

impl RasterScan {
    /// Plans it.
    ///
    /// # Errors
    ///
    /// An input that is not finite, or not positive where it must be; a scan velocity beyond the limit of the fly axis; an
    /// axis with neither acceleration nor jerk limited; more ticks than 2^53; numbers beyond the range of `f64`.
    pub fn plan(&self) -> Result<RasterPlan, PlanError> {
        self.check()?;
        // both axes have limits that make a move, whether they need it or not
        Fastest::new(State::rest(0.0), State::rest(self.line_length), self.fly)?;
        Fastest::new(State::rest(0.0), State::rest(1.0), self.stepping)?;
        let free = Self { tick: None, shortest: 0.0, ..*self }.planned()?;
        if self.tick.is_none() && self.shortest == 0.0 {
            return Ok(free);
        }
        let coarse = self.planned()?;
        let cost = coarse.duration - free.duration;
        let is_rounding = cost.abs() <= 64.0 * f64::EPSILON * coarse.duration;
        Ok(RasterPlan { tick_cost: if is_rounding { 0.0 } else { cost }, ..coarse })
    }

    fn planned(&self) -> Result<RasterPlan, PlanError> {
        let (v, length) = (self.velocity, self.line_length.abs());
        let clock = Clock::new(self.tick, self.shortest);
        let line_time = length / v;
        let steady_count = clock.up(line_time + 2.0 * self.run_up);
        let beyond = (v * clock.seconds(steady_count) - length).max(0.0) / 2.0;
        let ahead = clock.down(self.run_up);
        let fly = FlyGap::fastest(self, &clock, length + 2.0 * beyond)?;
        let step = Step::fastest(self, &clock)?;
        let settle = if step.is_some() { clock.up(self.settle) } else { 0.0 };
        let needed = step.map_or(0.0, |step| step.count() + settle - 2.0 * ahead);
        let gap_count = clock.up(clock.seconds(needed)).max(fly.count());
        let slower = match needed - fly.count() {
            more if more > clock.same(gap_count) => Slower::Step,
            more if more < -clock.same(gap_count) => Slower::Fly,
            _ => Slower::Both,
        };
        let stretched = if gap_count > fly.count() { fly.stretched(gap_count) } else { fly };
        let room = gap_count + 2.0 * ahead - settle;
        let step = step.map(|step| if room > step.count() { step.stretched(&clock, room) } else { step });
        let ends = [State::cruise(-beyond, v), State::cruise(length + beyond, v)];
        let steady_time = clock.seconds(steady_count);
        let steady = timed(vec![Segment::between(ends[0], ends[1], steady_time)], &[steady_count]);
        let [lead_in, lead_out] =
            [true, false].map(|is_in| lead(self, &clock, if is_in { -beyond } else { length + beyond }, is_in));
        let count = steady_count + gap_count;
        let between = (self.lines - 1) as f64 * count;
        let whole = count_of(&lead_in) + between + steady_count + count_of(&lead_out);
        clock.check(whole)?;
        let (period, is_one) = (clock.seconds(count), self.lines == 1);
        let plan = RasterPlan {
            scan: *self,
            line_time,
            steady_time,
            turn_time: clock.seconds(gap_count),
            period,
            duration: clock.seconds(whole),
            overhead: period - line_time,
            tick_cost: 0.0,
            slower: (!is_one).then_some(slower),
            clock,
            steady: steady[0],
            lead_in,
            lead_out,
            gap: stretched.segments(self, &clock, length + beyond),
            step: step.map_or_else(Vec::new, |step| step.segments(&clock)),
            ahead,
            count,
        };
        plan.check()?;
        Ok(plan)
    }
}

/// Count of all of it.
pub(super) fn count_of(track: &[Timed]) -> f64 {
    track.last().map_or(0.0, |last| last.end)
}

impl RasterPlan {
    /// The velocity on the line, in m/s: what was asked for.
    #[must_use]
    pub fn velocity(&self) -> f64 {
        self.scan.velocity
    }

    /// What part of the period is not the line itself.
    #[must_use]
    pub fn overhead_share(&self) -> f64 {
        self.overhead / self.period
    }

    /// Whether lines go to and fro.
    pub(super) fn is_snake(&self) -> bool {
        self.scan.order == Order::Snake
    }

    /// That all numbers have their digits.
    fn check(&self) -> Result<(), PlanError> {
        in_range("the duration of the raster", &[self.duration, self.line_time, self.steady_time])?;
        let what = "a time, velocity, acceleration or jerk of the raster";
        let parts = [&self.lead_in[..], &[self.steady], &self.gap];
        let fly: Vec<Segment> = parts.concat().iter().map(|timed| timed.segment).collect();
        let step: Vec<Segment> = self.step.iter().map(|timed| timed.segment).collect();
        let farthest = (self.scan.lines - 1) as f64 * self.scan.step + self.scan.start[1];
        if !farthest.is_finite() {
            return Err(PlanError::Range { what: "the position of the last line" });
        }
        segments_in_range(what, &fly)?;
        segments_in_range(what, &step)
    }
}
