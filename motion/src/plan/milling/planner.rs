//! Looks ahead: the speeds at the junctions of the moves that are known, and no more of them than a controller knows.
//!
//! Each junction has a largest speed, by its corner and both feeds. Backward from rest at the end of the last move that is
//! known, each gets the speed from which the way is enough to brake; forward, from where the machine is, the speed that can
//! be reached. A move is driven when as many as the rules say are known behind it; its end is then fixed.

use std::collections::VecDeque;

use super::corner;
use super::cruise::{self, Squares};
use super::cut::Cut;
use super::machine::Machine;
use super::ramp::Ramp;
use super::rules::Rules;

/// A cut that is planned.
#[derive(Debug, Clone, Copy)]
struct Block {
    cut: Cut,
    /// By its corner and both feeds.
    most: f64,
    /// By all moves behind it too.
    entry: f64,
    /// For the cruise ratio.
    squares: Squares,
}

/// A cut that was driven.
#[derive(Debug, Clone, Copy)]
pub(super) struct Driven {
    pub(super) cut: Cut,
    pub(super) entry: f64,
    pub(super) exit: f64,
    pub(super) peak: f64,
    pub(super) time: f64,
}

/// Moves that are known and not yet driven.
#[derive(Debug, Clone)]
pub(super) struct Planner {
    rules: Rules,
    blocks: VecDeque<Block>,
    /// Of the first block.
    speed: f64,
    last: Option<(Cut, Squares)>,
    /// The square of the peak of the last one that was driven, for those that brake behind it.
    peak: f64,
}

impl Planner {
    pub(super) fn new(rules: Rules) -> Self {
        Self { rules, blocks: VecDeque::new(), speed: 0.0, last: None, peak: 0.0 }
    }

    pub(super) fn rules(&self) -> &Rules {
        &self.rules
    }

    pub(super) fn rules_mut(&mut self) -> &mut Rules {
        &mut self.rules
    }

    /// Adds a cut; the one that is driven because of it, if there is one.
    pub(super) fn add(&mut self, cut: Cut, machine: &Machine) -> Option<Driven> {
        let most = match &self.last {
            Some((before, _)) => corner::speed(&self.rules, machine, before, &cut),
            None => {
                self.speed = corner::from_rest(&self.rules, &cut);
                self.speed
            }
        };
        let before = self.last.as_ref().map(|(_, squares)| squares);
        let squares = Squares::of(&cut, self.rules.cruise_ratio, most, before);
        self.last = Some((cut, squares));
        self.blocks.push_back(Block { cut, most, entry: 0.0, squares });
        self.look_back();
        if self.blocks.len() > self.rules.ahead { self.drive() } else { None }
    }

    /// Drives the first cut. Without a cut behind it, it ends at rest.
    pub(super) fn drive(&mut self) -> Option<Driven> {
        let top = self.top();
        let Block { cut, .. } = self.blocks.pop_front()?;
        let (entry, ramp) = (self.speed, self.ramp(&cut));
        let behind = self.blocks.front().map_or(0.0, |next| next.entry);
        let exit = behind.min(ramp.reachable(entry, cut.length)).min(cut.speed).min(top);
        let top = top.max(entry).min(cut.speed);
        let (time, peak) = ramp.time(entry.min(cut.speed), exit, top, cut.length);
        self.speed = exit;
        if self.blocks.is_empty() {
            self.last = None;
        }
        Some(Driven { cut, entry, exit, peak, time })
    }

    /// How fast the first cut may be by the cruise ratio.
    fn top(&mut self) -> f64 {
        if self.rules.cruise_ratio == 0.0 {
            return f64::INFINITY;
        }
        let [cruise, peak] = cruise::of_first(self.blocks.iter().rev().map(|block| &block.squares), self.peak);
        self.peak = peak;
        cruise.sqrt()
    }

    /// The speed with which each block may begin, from the last one on, up to where nothing changes any more.
    fn look_back(&mut self) {
        let mut exit = 0.0;
        for index in (0..self.blocks.len()).rev() {
            let block = self.blocks[index];
            let entry = block.most.min(self.ramp(&block.cut).reachable(exit, block.cut.length));
            let is_last = index + 1 == self.blocks.len();
            if entry == block.entry && !is_last {
                return;
            }
            self.blocks[index].entry = entry;
            exit = entry;
        }
    }

    fn ramp(&self, cut: &Cut) -> Ramp {
        Ramp { acceleration: cut.acceleration, jerk: self.rules.jerk }
    }
}
