//! The lines of a program: a stream, of which only what may be needed again is kept.

use std::collections::VecDeque;
use std::io::{BufRead, Read};
use std::rc::Rc;

use super::error::{GcodeError, Notice, Problem};

/// The most bytes of a line.
const LONGEST: usize = 1 << 20;

/// The most bytes of lines that are kept: sub-programs, loops, and what is read ahead to find them.
const MOST_KEPT: usize = 64 << 20;

/// The most bytes of lines that are kept to jump back to, where the dialect jumps.
const MOST_PASSED: usize = 4 << 20;

/// A line that is kept.
#[derive(Debug, Clone)]
pub(super) struct Line {
    /// Counted from 1.
    pub(super) number: u64,
    pub(super) bytes: Rc<[u8]>,
}

/// How much of a file has been read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Position {
    pub(super) bytes: u64,
    pub(super) lines: u64,
}

/// A file, read line by line.
pub(super) struct Stream<R> {
    input: R,
    pub(super) position: Position,
    /// Read, but not yet come to.
    ahead: VecDeque<Line>,
    passed: VecDeque<Line>,
    passed_bytes: usize,
    /// Whether lines are kept to jump back to.
    jumps: bool,
    /// Bytes of lines that are kept.
    kept: usize,
}

impl<R: BufRead> Stream<R> {
    pub(super) fn new(input: R, jumps: bool) -> Self {
        let (position, ahead, passed) = (Position::default(), VecDeque::new(), VecDeque::new());
        Self { input, position, ahead, passed, passed_bytes: 0, jumps, kept: 0 }
    }

    /// The next line, and its number; none at the end.
    pub(super) fn next(&mut self, bytes: &mut Vec<u8>) -> Result<Option<u64>, GcodeError> {
        let number = match self.ahead.pop_front() {
            Some(line) => {
                bytes.clear();
                bytes.extend_from_slice(&line.bytes);
                Some(line.number)
            }
            None => self.read(bytes)?,
        };
        if let (Some(number), true) = (number, self.jumps) {
            self.pass(Line { number, bytes: Rc::from(bytes.as_slice()) });
        }
        Ok(number)
    }

    /// The next line, to be kept.
    pub(super) fn next_kept(&mut self) -> Result<Option<Line>, GcodeError> {
        let mut bytes = Vec::new();
        let Some(number) = self.next(&mut bytes)? else { return Ok(None) };
        self.keep(Line { number, bytes: Rc::from(bytes) }).map(Some)
    }

    /// All that is left of the file, read ahead.
    pub(super) fn rest(&mut self) -> Result<&VecDeque<Line>, GcodeError> {
        let mut bytes = Vec::new();
        while let Some(number) = self.read(&mut bytes)? {
            let line = self.keep(Line { number, bytes: Rc::from(bytes.as_slice()) })?;
            self.ahead.push_back(line);
        }
        Ok(&self.ahead)
    }

    /// A line that has been read comes once more.
    pub(super) fn again(&mut self, line: Line) {
        self.ahead.push_front(line);
    }

    /// Lines that were passed, the first first.
    pub(super) fn passed(&self) -> &VecDeque<Line> {
        &self.passed
    }

    /// Counts a line that is kept.
    pub(super) fn keep(&mut self, line: Line) -> Result<Line, GcodeError> {
        self.kept += line.bytes.len() + size_of::<Line>();
        if self.kept <= MOST_KEPT {
            return Ok(line);
        }
        let remedy = "split the file: sub-programs and loops must fit into memory";
        let problem = Problem::Limit { what: "bytes of sub-programs and loops", most: MOST_KEPT as u64, remedy };
        Err(Notice { line: line.number, problem }.into())
    }

    fn pass(&mut self, line: Line) {
        self.passed_bytes += line.bytes.len() + size_of::<Line>();
        self.passed.push_back(line);
        while self.passed_bytes > MOST_PASSED {
            let Some(oldest) = self.passed.pop_front() else { return };
            self.passed_bytes -= oldest.bytes.len() + size_of::<Line>();
        }
    }

    /// The next line of the file itself.
    fn read(&mut self, bytes: &mut Vec<u8>) -> Result<Option<u64>, GcodeError> {
        let line = self.position.lines + 1;
        bytes.clear();
        let most = self.input.by_ref().take(LONGEST as u64 + 1).read_until(b'\n', bytes);
        let count = most.map_err(|source| GcodeError::Read { line, source })?;
        if count == 0 {
            return Ok(None);
        }
        if count > LONGEST {
            return Err(Notice { line, problem: Problem::TooLong { most: LONGEST } }.into());
        }
        self.position = Position { bytes: self.position.bytes + count as u64, lines: line };
        Ok(Some(line))
    }
}
