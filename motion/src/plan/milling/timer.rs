//! Times moves one after another.

use std::collections::VecDeque;

use super::arc::Arc;
use super::cut::Cut;
use super::machine::Machine;
use super::planner::{Driven, Planner};
use super::row::{Move, Path, Row};
use super::rules::{Arcs, Corner, Rules};
use super::steps::Steps;
use super::sum::Sum;
use super::{Milling, Model, exact_stop};
use crate::error::PlanError;

/// A clock that moves are added to.
///
/// With look-ahead a move has its time once enough others are known behind it, or once the machine rests: rows come later
/// than their moves, in the same order.
#[derive(Debug, Clone)]
pub struct Timer {
    machine: Machine,
    model: Model,
    steps: Steps,
    planner: Planner,
    /// Moves whose rows are to come.
    moves: VecDeque<Waiting>,
    rows: VecDeque<Row>,
    total: Sum,
    number: u64,
}

/// A move whose row is to come.
#[derive(Debug, Clone)]
struct Waiting {
    /// With what has been driven of it.
    row: Row,
    /// Cuts that are planned and not driven.
    cuts: u32,
    /// Whether all its cuts are planned.
    is_whole: bool,
}

impl Timer {
    pub(super) fn new(milling: Milling) -> Self {
        let rules = match milling.model {
            Model::LookAhead(rules) => rules,
            Model::ExactStop | Model::Steps { .. } => Rules::default(),
        };
        Self {
            machine: milling.machine,
            model: milling.model,
            steps: Steps::new(),
            planner: Planner::new(rules),
            moves: VecDeque::new(),
            rows: VecDeque::new(),
            total: Sum::default(),
            number: 0,
        }
    }

    /// The limits, as they are now.
    #[must_use]
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// Adds a move.
    ///
    /// # Errors
    ///
    /// A feed that is not positive; more than a million steps to speed up in; numbers that leave the range of 64-bit
    /// numbers.
    pub fn add(&mut self, cut: &Move) -> Result<(), PlanError> {
        self.number += 1;
        let row = Row {
            number: self.number,
            cut: *cut,
            length: 0.0,
            feed: 0.0,
            entry: 0.0,
            exit: 0.0,
            peak: 0.0,
            time: 0.0,
            total: 0.0,
        };
        match self.model {
            Model::LookAhead(_) => self.look_ahead(row)?,
            Model::ExactStop => self.alone(row, |_, cut| Ok(exact_stop::time(cut)))?,
            Model::Steps { length } => self.alone(row, |steps, cut| steps.time(cut, length))?,
        }
        if cut.stops { self.rest() } else { Ok(()) }
    }

    /// The next move that has its time.
    pub fn next_row(&mut self) -> Option<Row> {
        self.rows.pop_front()
    }

    /// The moves so far end at rest.
    ///
    /// # Errors
    ///
    /// Numbers that leave the range of 64-bit numbers.
    pub fn rest(&mut self) -> Result<(), PlanError> {
        while let Some(driven) = self.planner.drive() {
            self.drive(&driven)?;
        }
        self.emit();
        Ok(())
    }

    /// Adds a time in which nothing moves; the moves before end at rest.
    ///
    /// # Errors
    ///
    /// As [`Timer::rest`].
    pub fn dwell(&mut self, time: f64) -> Result<(), PlanError> {
        self.rest()?;
        self.total.add(time);
        Ok(())
    }

    /// Of all that have their time, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.total.value()
    }

    /// One move from rest to rest.
    fn alone(
        &mut self,
        mut row: Row,
        time: impl Fn(&mut Steps, &Cut) -> Result<(f64, f64), PlanError>,
    ) -> Result<(), PlanError> {
        if let Some(cut) = Cut::of(&row.cut, &self.machine)? {
            (row.time, row.peak) = time(&mut self.steps, &cut)?;
            (row.length, row.feed) = (cut.length, cut.speed);
            finite(row.time, row.peak)?;
        }
        self.moves.push_back(Waiting { row, cuts: 0, is_whole: true });
        self.emit();
        Ok(())
    }

    fn look_ahead(&mut self, row: Row) -> Result<(), PlanError> {
        let (cut, arcs) = (row.cut, self.planner.rules().arcs);
        self.moves.push_back(Waiting { row, cuts: 0, is_whole: false });
        match (cut.path, arcs) {
            (Path::Arc(arc), Arcs::Tolerance(tolerance)) => self.chords(&cut, &arc, arc.chords_within(tolerance))?,
            (Path::Arc(arc), Arcs::Length(length)) => self.chords(&cut, &arc, arc.chords_of(length))?,
            _ => self.plan(Cut::of(&cut, &self.machine)?)?,
        }
        if let Some(waiting) = self.moves.back_mut() {
            waiting.is_whole = true;
        }
        self.emit();
        Ok(())
    }

    /// An arc as so many chords.
    fn chords(&mut self, cut: &Move, arc: &Arc, count: u32) -> Result<(), PlanError> {
        let mut from = cut.from;
        let (others, feed) = (cut.others.map(|way| way / f64::from(count)), cut.feed.shared(count));
        for index in 1..=count {
            let share = f64::from(index) / f64::from(count);
            let to = if index == count { cut.to } else { arc.at(cut.from, cut.to, share) };
            self.plan(Cut::of(&Move { from, to, others, path: Path::Straight, feed, ..*cut }, &self.machine)?)?;
            from = to;
        }
        Ok(())
    }

    /// A cut of the last move goes to the planner; one without length is none.
    fn plan(&mut self, cut: Option<Cut>) -> Result<(), PlanError> {
        let (Some(cut), Some(waiting)) = (cut, self.moves.back_mut()) else { return Ok(()) };
        waiting.cuts += 1;
        let driven = self.planner.add(cut, &self.machine);
        driven.map_or(Ok(()), |driven| self.drive(&driven))
    }

    /// Adds what was driven to its move.
    fn drive(&mut self, driven: &Driven) -> Result<(), PlanError> {
        finite(driven.time, driven.peak)?;
        self.emit();
        let Some(Waiting { row, cuts, .. }) = self.moves.front_mut() else { return Ok(()) };
        *cuts = cuts.saturating_sub(1);
        if row.length == 0.0 {
            (row.entry, row.feed) = (driven.entry, driven.cut.speed);
        }
        row.length += driven.cut.length;
        row.time += driven.time;
        row.peak = row.peak.max(driven.peak);
        row.exit = driven.exit;
        Ok(())
    }

    /// The rows of all moves that are driven.
    fn emit(&mut self) {
        while self.moves.front().is_some_and(|waiting| waiting.is_whole && waiting.cuts == 0) {
            let Some(Waiting { mut row, .. }) = self.moves.pop_front() else { return };
            self.total.add(row.time);
            row.total = self.total.value();
            self.rows.push_back(row);
        }
    }

    /// Limits that a printer's program sets: `M201`, `M203`, `M204`, `M205`, and words from A to Z.
    pub(super) fn limit(&mut self, code: u32, words: &[Option<f64>; 26]) {
        let word = |letter: char| words[usize::from(letter as u8 - b'A')].filter(|value| *value > 0.0);
        let set = |limit: &mut f64, letter: char| *limit = word(letter).unwrap_or(*limit);
        let machine = &mut self.machine;
        match code {
            201 | 203 => {
                let (axes, others) = match code {
                    201 => (&mut machine.acceleration, &mut machine.other_acceleration),
                    _ => (&mut machine.speed, &mut machine.other_speed),
                };
                for (limit, letter) in axes.iter_mut().zip(['X', 'Y', 'Z']) {
                    set(limit, letter);
                }
                set(&mut others[6], 'E');
            }
            204 => {
                let [print, travel, retract] = &mut machine.path_acceleration;
                set(print, 'S');
                set(travel, 'S');
                set(print, 'P');
                set(travel, 'T');
                set(retract, 'R');
            }
            205 => self.set_corner(&word),
            _ => {}
        }
    }

    /// Junction deviation (J), or the jumps of classic jerk.
    fn set_corner(&mut self, word: &dyn Fn(char) -> Option<f64>) {
        let corner = &mut self.planner.rules_mut().corner;
        if let Some(deviation) = word('J') {
            *corner = Corner::Deviation(deviation);
        }
        if let Corner::Jump(jumps) = corner {
            for (jump, letter) in jumps.iter_mut().zip(['X', 'Y', 'Z']) {
                *jump = word(letter).unwrap_or(*jump);
            }
        }
    }

    /// Klipper's `SET_VELOCITY_LIMIT`: what stands behind it, as `accel=1000 square_corner_velocity=5`.
    pub(super) fn set_limits(&mut self, words: &str) {
        for (name, value) in words.split_ascii_whitespace().filter_map(|word| word.split_once('=')) {
            let Some(value) = value.parse::<f64>().ok().filter(|value| *value >= 0.0 && value.is_finite()) else {
                continue;
            };
            if name == "minimum_cruise_ratio" && value < 1.0 && self.planner.rules().jerk == f64::INFINITY {
                self.planner.rules_mut().cruise_ratio = value;
            }
            if value == 0.0 {
                continue;
            }
            match name {
                "velocity" => self.machine.feed = value,
                "accel" => self.machine.path_acceleration = [value; 3],
                "square_corner_velocity" => self.planner.rules_mut().corner = Corner::Square(value),
                _ => {}
            }
        }
    }
}

fn finite(time: f64, peak: f64) -> Result<(), PlanError> {
    match time.is_finite() && peak.is_finite() {
        true => Ok(()),
        false => Err(PlanError::Range { what: "the time of a cut" }),
    }
}
