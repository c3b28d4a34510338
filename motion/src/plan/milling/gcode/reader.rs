//! Reads a G-code file line by line, and times its moves.

use std::io::{BufRead, Read};

use super::block::Block;
use super::codes;
use super::error::{GcodeError, Notice, Problem};
use super::modal::{Action, Modal};
use super::{Reading, Unknown};
use crate::error::PlanError;
use crate::plan::milling::sum::Sum;
use crate::plan::milling::{Feed, Milling, Row, Timer};

/// The most bytes of a line.
const LONGEST: usize = 1 << 20;

/// Some editors write it at the begin.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Lines between two reports of progress.
const LINES: u64 = 4096;

/// What happens while a file is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// A move was timed.
    Row(&'a Row),
    /// A line was passed over.
    Notice(&'a Notice),
    /// So far.
    Progress(Progress),
}

/// How far reading is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Read so far.
    pub bytes: u64,
    /// Read so far.
    pub lines: u64,
    /// Timed so far.
    pub moves: u64,
}

/// A file, timed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Summary {
    /// Lines of the file, to the end of the program.
    pub lines: u64,
    /// Moves, those without length too.
    pub moves: u64,
    /// Lines that were passed over.
    pub notices: u64,
    /// Of the whole program, in s.
    pub time: f64,
    /// Of the moves at feed (G1, G2, G3), in s.
    pub cutting_time: f64,
    /// Of the rapid moves (G0), in s.
    pub rapid_time: f64,
    /// Of the dwells (G4), in s.
    pub dwell_time: f64,
    /// Of the way at feed, in mm.
    pub cutting_length: f64,
    /// Of the rapid way, in mm.
    pub rapid_length: f64,
}

/// Reads all of a file.
pub(super) fn read(
    milling: &Milling,
    input: impl BufRead,
    reading: &Reading,
    on_event: impl FnMut(Event<'_>),
) -> Result<Summary, GcodeError> {
    check(reading)?;
    let (timer, modal) = (milling.timer(), Modal::new(reading));
    let (progress, totals) = (Progress::default(), Totals::default());
    Program { reading, timer, modal, progress, totals, on_event, begun: false }.run(input)
}

fn check(reading: &Reading) -> Result<(), GcodeError> {
    if let Some(value) = reading.default_feed
        && (value.is_nan() || value <= 0.0)
    {
        let (name, remedy) = ("default feed", "make it positive");
        return Err(GcodeError::Option(PlanError::Input { name, value, remedy }));
    }
    match reading.start.into_iter().find(|coordinate| !coordinate.is_finite()) {
        None => Ok(()),
        Some(value) => {
            let (name, remedy) = ("a coordinate of the start", "make it finite");
            Err(GcodeError::Option(PlanError::Input { name, value, remedy }))
        }
    }
}

#[derive(Default)]
struct Totals {
    notices: u64,
    cutting_time: Sum,
    rapid_time: Sum,
    dwell_time: Sum,
    cutting_length: Sum,
    rapid_length: Sum,
}

struct Program<'a, F> {
    reading: &'a Reading,
    timer: Timer,
    modal: Modal,
    progress: Progress,
    totals: Totals,
    on_event: F,
    /// Whether codes or words have come: a mark after them is the end.
    begun: bool,
}

impl<F: FnMut(Event<'_>)> Program<'_, F> {
    fn run(mut self, mut input: impl BufRead) -> Result<Summary, GcodeError> {
        let (mut bytes, mut block) = (Vec::new(), Block::default());
        while self.next_line(&mut input, &mut bytes)? {
            let text = String::from_utf8_lossy(&bytes);
            if !self.line(text.trim_start_matches(BYTE_ORDER_MARK).trim(), &mut block)? {
                break;
            }
            if self.progress.lines.is_multiple_of(LINES) {
                (self.on_event)(Event::Progress(self.progress));
            }
        }
        (self.on_event)(Event::Progress(self.progress));
        if self.progress.moves == 0 {
            return Err(GcodeError::NoMoves { lines: self.progress.lines });
        }
        Ok(self.summary())
    }

    fn summary(&self) -> Summary {
        Summary {
            lines: self.progress.lines,
            moves: self.progress.moves,
            notices: self.totals.notices,
            time: self.timer.time(),
            cutting_time: self.totals.cutting_time.value(),
            rapid_time: self.totals.rapid_time.value(),
            dwell_time: self.totals.dwell_time.value(),
            cutting_length: self.totals.cutting_length.value(),
            rapid_length: self.totals.rapid_length.value(),
        }
    }

    /// Whether there is one.
    fn next_line(&mut self, input: &mut impl BufRead, bytes: &mut Vec<u8>) -> Result<bool, GcodeError> {
        let line = self.progress.lines + 1;
        bytes.clear();
        let most = input.by_ref().take(LONGEST as u64 + 1).read_until(b'\n', bytes);
        let count = most.map_err(|source| GcodeError::Read { line, source })?;
        if count > LONGEST {
            return Err(Notice { line, problem: Problem::TooLong { most: LONGEST } }.into());
        }
        self.progress.bytes += count as u64;
        self.progress.lines += u64::from(count > 0);
        Ok(count > 0)
    }

    /// Whether the program goes on.
    fn line(&mut self, text: &str, block: &mut Block) -> Result<bool, GcodeError> {
        let text = match text.strip_prefix('/') {
            Some(_) if self.reading.block_delete => return Ok(true),
            Some(rest) => rest,
            None => text,
        };
        if text.is_empty() {
            return Ok(true);
        }
        block.read(text);
        if block.mark {
            return Ok(!self.begun);
        }
        self.begun |= !block.is_empty();
        match self.modal.execute(block, self.progress.lines) {
            Ok(action) => self.act(action)?,
            Err(problem) => self.problem(problem)?,
        }
        Ok(!block.miscellaneous.iter().any(|code| codes::ends(*code)))
    }

    fn act(&mut self, action: Action) -> Result<(), GcodeError> {
        let cut = match action {
            Action::None => return Ok(()),
            Action::Dwell(time) => {
                self.timer.dwell(time);
                self.totals.dwell_time.add(time);
                return Ok(());
            }
            Action::Move(cut) => cut,
        };
        let row = self.timer.add(&cut).map_err(|source| GcodeError::Plan { line: cut.line, source })?;
        self.progress.moves += 1;
        let totals = &mut self.totals;
        let (time, length) = match cut.feed {
            Feed::Rapid => (&mut totals.rapid_time, &mut totals.rapid_length),
            Feed::Speed(_) => (&mut totals.cutting_time, &mut totals.cutting_length),
        };
        time.add(row.time);
        length.add(row.length);
        (self.on_event)(Event::Row(&row));
        Ok(())
    }

    fn problem(&mut self, problem: Problem) -> Result<(), GcodeError> {
        let notice = Notice { line: self.progress.lines, problem };
        if self.reading.unknown == Unknown::Refuse || notice.problem.is_fatal() {
            return Err(notice.into());
        }
        self.totals.notices += 1;
        (self.on_event)(Event::Notice(&notice));
        Ok(())
    }
}
