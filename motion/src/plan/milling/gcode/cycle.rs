//! Canned cycles: drilling, tapping and boring, as the moves that they stand for.

use super::action::Action;
use super::block::Block;
use super::codes;
use super::error::Problem;
use super::motion::{feed, rapid, straight};
use super::offsets::Axes;
use super::options::DwellUnit;
use super::state::State;

/// How far a peck stays above the bottom of the one before, or retracts to break the chip, in mm: LinuxCNC's 0.01 inch.
const CLEARANCE: f64 = 0.254;

/// More holes of one block, or pecks of one hole, are a slip.
const MOST: f64 = 1e6;

/// What stays in force from hole to hole.
#[derive(Debug, Default)]
pub(super) struct Cycle {
    /// Z.
    bottom: Option<f64>,
    /// R.
    retract: Option<f64>,
    /// Q.
    peck: Option<f64>,
    /// P.
    dwell: f64,
    /// Where the axis was before the first hole, in the program's coordinates.
    begin: f64,
    /// Which motion was in force before, so that a new series is known.
    last: Option<u32>,
}

/// Heights of one hole, of the machine.
struct Hole {
    axis: usize,
    bottom: f64,
    retract: f64,
    /// Where it ends.
    clear: f64,
}

impl Cycle {
    /// The holes of a block.
    pub(super) fn drill(
        &mut self,
        state: &mut State,
        code: u32,
        is_new: bool,
        block: &mut Block,
        actions: &mut Vec<Action>,
    ) -> Result<(), Problem> {
        let wrong = |why| Problem::Cycle { code: codes::name('G', 10 * code), why };
        let axis = state.modes.plane;
        let letter = ['X', 'Y', 'Z'][axis];
        if is_new || self.last.is_none() {
            *self = Self { begin: state.program_position()[axis], ..Self::default() };
            self.last = Some(code);
        }
        let unit = state.modes.unit;
        self.bottom = block.remove(letter).map(|depth| depth * unit).or(self.bottom);
        self.retract = block.remove('R').map(|retract| retract * unit).or(self.retract);
        self.peck = block.remove('Q').map(|peck| peck.abs() * unit).or(self.peck);
        self.dwell = block.remove('P').unwrap_or(self.dwell);
        let Some(bottom) = self.bottom else { return Err(wrong("needs its depth: give Z")) };
        let Some(retract) = self.retract else { return Err(wrong("needs the height over the work piece: give R")) };
        let count = block.remove('L').or_else(|| block.remove('K')).unwrap_or(1.0).round();
        if !(0.0..=MOST).contains(&count) {
            return Err(wrong("has a count L that is none: correct it"));
        }
        let (retract, bottom) = match state.modes.absolute {
            true => (retract, bottom),
            false => (self.begin + retract, self.begin + retract + bottom),
        };
        if bottom > retract {
            return Err(wrong("has its bottom above R: correct Z or R"));
        }
        let clear = if state.modes.retract_to_start { retract.max(self.begin) } else { retract };
        let offset = state.offsets.sum(axis);
        let hole = Hole { axis, bottom: bottom + offset, retract: retract + offset, clear: clear + offset };
        for _ in 0..count as u64 {
            self.hole(state, code, &hole, block, actions)?;
        }
        Ok(())
    }

    fn hole(
        &self,
        state: &mut State,
        code: u32,
        hole: &Hole,
        block: &Block,
        actions: &mut Vec<Action>,
    ) -> Result<(), Problem> {
        let Hole { axis, bottom, retract, clear } = *hole;
        if state.position[axis] < retract {
            go(state, axis, retract, true, actions)?;
        }
        let mut over = super::motion::target(state, false, block)?;
        over[axis] = state.position[axis];
        go_to(state, &over, true, actions)?;
        go(state, axis, retract, true, actions)?;
        match code {
            73 | 83 => self.pecks(state, code == 83, hole, actions)?,
            87 => return Err(Problem::Code { code: "G87".to_owned() }),
            _ => go(state, axis, bottom, false, actions)?,
        }
        let dwell = match state.dwell {
            DwellUnit::Seconds => self.dwell,
            DwellUnit::Milliseconds => self.dwell / 1000.0,
        };
        if matches!(code, 74 | 82 | 84 | 86 | 88 | 89) && dwell > 0.0 {
            actions.push(Action::Dwell(dwell));
        }
        match code {
            // Taps and reamers come out at feed; the spindle stops or turns back before.
            74 | 84 | 85 | 89 => {
                actions.push(Action::Rest);
                go(state, axis, retract, false, actions)?;
            }
            88 => {
                let what = "G88 is drawn out by hand: it counts as a rapid move".to_owned();
                actions.extend([Action::Rest, Action::Tell(Problem::Stopped { what })]);
            }
            _ => actions.push(Action::Rest),
        }
        go(state, axis, clear, true, actions)
    }

    /// Down in pieces: out to R after each, or up a little to break the chip.
    fn pecks(&self, state: &mut State, is_deep: bool, hole: &Hole, actions: &mut Vec<Action>) -> Result<(), Problem> {
        let Hole { axis, bottom, retract, .. } = *hole;
        let peck = self.peck.unwrap_or(retract - bottom);
        if peck <= 0.0 || (retract - bottom) / peck > MOST {
            let code = if is_deep { "G83" } else { "G73" }.to_owned();
            return Err(Problem::Cycle { code, why: "needs the depth of a peck: give a positive Q" });
        }
        let mut depth = retract;
        loop {
            depth = (depth - peck).max(bottom);
            go(state, axis, depth, false, actions)?;
            if depth <= bottom {
                return Ok(());
            }
            if is_deep {
                go(state, axis, retract, true, actions)?;
                go(state, axis, (depth + CLEARANCE).min(retract), true, actions)?;
            } else {
                go(state, axis, (depth + CLEARANCE).min(retract), true, actions)?;
            }
        }
    }
}

/// One axis to a height of the machine.
fn go(state: &mut State, axis: usize, height: f64, is_rapid: bool, actions: &mut Vec<Action>) -> Result<(), Problem> {
    let mut to = state.position;
    to[axis] = height;
    go_to(state, &to, is_rapid, actions)
}

fn go_to(state: &mut State, to: &Axes, is_rapid: bool, actions: &mut Vec<Action>) -> Result<(), Problem> {
    let from = state.position;
    if from == *to {
        return Ok(());
    }
    let feed = if is_rapid { rapid(state) } else { feed(state, &from, to, actions)? };
    state.position = *to;
    actions.push(straight(state, &from, to, feed));
    Ok(())
}
