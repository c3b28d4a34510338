//! The state of a controller: what stays in force from line to line, and what a block does.

use super::arc;
use super::block::{Block, Tenths};
use super::codes::{self, General, Motion};
use super::error::Problem;
use super::{DwellUnit, Reading};
use crate::plan::milling::{Feed, Move, Path};

/// Millimetres in an inch.
const INCH: f64 = 25.4;

/// What a block does.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Action {
    /// Nothing that takes time.
    None,
    /// A move.
    Move(Move),
    /// A stop, in s.
    Dwell(f64),
}

/// Which motion is in force.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Force {
    Nothing,
    Motion(Motion),
    Other(Tenths),
}

/// What is in force.
#[derive(Debug)]
pub(super) struct Modal {
    position: [f64; 3],
    motion: Force,
    /// The axis across the plane of arcs.
    plane: usize,
    /// Millimetres in a unit.
    unit: f64,
    absolute: bool,
    absolute_centre: bool,
    /// In mm/s.
    feed: Option<f64>,
    dwell: DwellUnit,
}

/// What the G codes of one block ask for, apart from what stays in force.
#[derive(Default)]
struct Asked {
    motion: Option<Motion>,
    dwell: bool,
    set_position: bool,
    problem: Option<Problem>,
}

impl Modal {
    pub(super) fn new(reading: &Reading) -> Self {
        Self {
            position: reading.start,
            motion: Force::Nothing,
            plane: 2,
            unit: 1.0,
            absolute: true,
            absolute_centre: false,
            feed: reading.default_feed,
            dwell: reading.dwell,
        }
    }

    /// What the block of this line does. With a problem, what is in force has changed, but nothing moves.
    pub(super) fn execute(&mut self, block: &Block, line: u64) -> Result<Action, Problem> {
        if let Some(problem) = &block.problem {
            return Err(problem.clone());
        }
        let asked = self.set_modes(block);
        self.set_feed(block)?;
        if let Some(problem) = asked.problem {
            return Err(problem);
        }
        if let Some(code) = block.miscellaneous.iter().find(|code| !codes::is_quiet(**code)) {
            return Err(Problem::Code { code: codes::name('M', *code) });
        }
        if asked.dwell {
            return self.dwell(block).map(Action::Dwell);
        }
        if let Some(letter) = block.any("ABCUVW") {
            return Err(Problem::Axis { letter });
        }
        if asked.set_position {
            self.position = self.target(block, true);
            return Ok(Action::None);
        }
        match block.any("XYZ") {
            None if self.is_whole_circle(block, asked.motion) => self.go(block, line),
            None => Ok(Action::None),
            Some(_) => self.go(block, line),
        }
    }

    /// A circle may come back to where it starts without naming the point.
    fn is_whole_circle(&self, block: &Block, asked: Option<Motion>) -> bool {
        matches!(asked, Some(Motion::Clockwise | Motion::CounterClockwise)) && block.any("IJK").is_some()
    }

    fn set_modes(&mut self, block: &Block) -> Asked {
        let mut asked = Asked::default();
        for code in &block.general {
            let name = || codes::name('G', *code);
            match General::of(*code) {
                General::Motion(motion) => {
                    if asked.motion.replace(motion).is_some_and(|before| before != motion) {
                        asked.problem.get_or_insert(Problem::Twice { what: "a motion code (G0 to G3)".to_owned() });
                    }
                    self.motion = Force::Motion(motion);
                }
                General::Dwell => asked.dwell = true,
                General::Plane(axis) => self.plane = axis,
                General::Inches(inches) => self.unit = if inches { INCH } else { 1.0 },
                General::Absolute(absolute) => self.absolute = absolute,
                General::AbsoluteCentre(absolute) => self.absolute_centre = absolute,
                General::SetPosition => asked.set_position = true,
                General::Quiet => {}
                General::FeedMode => asked.problem = Some(Problem::FeedMode { code: name() }),
                General::OtherMotion => {
                    self.motion = Force::Other(*code);
                    asked.problem.get_or_insert(Problem::Code { code: name() });
                }
                General::Cancel => self.motion = Force::Nothing,
                General::Unknown => {
                    asked.problem.get_or_insert(Problem::Code { code: name() });
                }
            }
        }
        asked
    }

    fn set_feed(&mut self, block: &Block) -> Result<(), Problem> {
        match block.word('F') {
            None => Ok(()),
            Some(value) if value > 0.0 => {
                self.feed = Some(value * self.unit / 60.0);
                Ok(())
            }
            Some(value) => Err(Problem::Feed { value }),
        }
    }

    fn dwell(&self, block: &Block) -> Result<f64, Problem> {
        let by_p = match self.dwell {
            DwellUnit::Seconds => 1.0,
            DwellUnit::Milliseconds => 1e-3,
        };
        let time = match (block.word('P'), block.word('S').or(block.word('X'))) {
            (Some(time), _) => time * by_p,
            (None, Some(time)) => time,
            (None, None) => return Err(Problem::Dwell),
        };
        if time >= 0.0 { Ok(time) } else { Err(Problem::Dwell) }
    }

    /// Where the block's coordinates point to.
    fn target(&self, block: &Block, absolute: bool) -> [f64; 3] {
        let coordinate = |axis: usize, letter: char| match block.word(letter) {
            None => self.position[axis],
            Some(value) if absolute => value * self.unit,
            Some(value) => self.position[axis] + value * self.unit,
        };
        [coordinate(0, 'X'), coordinate(1, 'Y'), coordinate(2, 'Z')]
    }

    fn go(&mut self, block: &Block, line: u64) -> Result<Action, Problem> {
        let motion = match self.motion {
            Force::Nothing => return Err(Problem::NoMotion),
            Force::Other(code) => return Err(Problem::Code { code: codes::name('G', code) }),
            Force::Motion(motion) => motion,
        };
        let (from, to) = (self.position, self.target(block, self.absolute));
        // The tool is there afterwards, even if this move is passed over.
        self.position = to;
        let feed = match motion {
            Motion::Rapid => Feed::Rapid,
            _ => Feed::Speed(self.feed.ok_or(Problem::NoFeed)?),
        };
        let path = match motion {
            Motion::Rapid | Motion::Linear => Path::Straight,
            Motion::Clockwise | Motion::CounterClockwise => {
                let frame = arc::Frame { plane: self.plane, unit: self.unit, absolute_centre: self.absolute_centre };
                Path::Arc(arc::arc(block, &frame, from, to, motion == Motion::Clockwise)?)
            }
        };
        Ok(Action::Move(Move { line, from, to, path, feed }))
    }
}
