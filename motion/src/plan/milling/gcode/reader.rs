//! Reads a G-code file line by line, and times its moves.

use std::collections::HashSet;
use std::io::BufRead;

use super::action::Action;
use super::block::Block;
use super::dialect::Dialect;
use super::envelope;
use super::error::{GcodeError, Notice, Problem};
use super::flow::{Flow, Next};
use super::modal::{End, Modal};
use super::options::{Reading, Unknown};
use super::parameters::{self, Parameters};
use super::statement::{Statement, number};
use super::text::{Kind, Text};
use super::totals::{Summary, Totals};
use crate::error::PlanError;
use crate::plan::milling::{Milling, Row, Timer};

/// Some editors write it at the begin.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Lines between two reports of progress.
const LINES: u64 = 4096;

/// From so many bytes at the begin of a file its dialect is guessed.
const HEAD: usize = 1 << 16;

/// What is told is told once, up to so many different things.
const MOST_TOLD: usize = 1000;

/// What happens while a file is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// Which controller the file is read for, said before all else.
    Dialect(Dialect),
    /// A move was timed.
    Row(&'a Row),
    /// The machine rests for so long, in s.
    Dwell(f64),
    /// A line was passed over, or takes a time that nobody knows.
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

/// Reads all of a file.
pub(super) fn read(
    milling: &Milling,
    mut input: impl BufRead,
    reading: &Reading,
    on_event: impl FnMut(Event<'_>),
) -> Result<Summary, GcodeError> {
    check(reading)?;
    let (dialect, first_mark) = {
        let head = input.fill_buf().map_err(|source| GcodeError::Read { line: 1, source })?;
        let head = String::from_utf8_lossy(&head[..head.len().min(HEAD)]);
        (reading.dialect.unwrap_or_else(|| Dialect::guess(&head)), first_mark(&head))
    };
    let program = Program {
        reading,
        dialect,
        flow: Flow::new(input, dialect, reading),
        timer: milling.timer(),
        modal: Modal::new(reading, dialect),
        parameters: Parameters::new(&reading.parameters),
        block: Block::default(),
        actions: Vec::new(),
        totals: Totals::default(),
        told: HashSet::new(),
        on_event,
        begun: false,
        first_mark,
    };
    program.run()
}

/// The line of the first `%`; 0 where there is none.
fn first_mark(head: &str) -> u64 {
    (1..).zip(head.lines()).find(|(_, line)| line.trim_start().starts_with('%')).map_or(0, |(number, _)| number)
}

fn check(reading: &Reading) -> Result<(), GcodeError> {
    let wrong = |name, value, remedy| Err(GcodeError::Option(PlanError::Input { name, value, remedy }));
    if let Some(value) = reading.default_feed
        && (value.is_nan() || value <= 0.0)
    {
        return wrong("default feed", value, "make it positive");
    }
    let points = [("a coordinate of the start", Some(reading.start)), ("a coordinate of home", reading.home)];
    for (name, point) in points {
        if let Some(value) = point.into_iter().flatten().find(|coordinate| !coordinate.is_finite()) {
            return wrong(name, value, "make it finite");
        }
    }
    match reading.parameters.iter().find(|(_, value)| !value.is_finite()) {
        Some((_, value)) => wrong("a parameter", *value, "make it finite"),
        None => Ok(()),
    }
}

struct Program<'a, R, F> {
    reading: &'a Reading,
    dialect: Dialect,
    flow: Flow<R>,
    timer: Timer,
    modal: Modal,
    parameters: Parameters,
    block: Block,
    actions: Vec<Action>,
    totals: Totals,
    told: HashSet<String>,
    on_event: F,
    /// Whether codes or words have come: a mark after them is the end.
    begun: bool,
    /// The line of the first `%`: what cannot be read before it is no program.
    first_mark: u64,
}

impl<R: BufRead, F: FnMut(Event<'_>)> Program<'_, R, F> {
    fn run(mut self) -> Result<Summary, GcodeError> {
        (self.on_event)(Event::Dialect(self.dialect));
        let (mut bytes, mut text, mut lines) = (Vec::new(), Text::default(), 0_u64);
        let mut is_wrapped = false;
        while self.flow.next(&mut bytes, &mut self.parameters)? {
            let line = match self.flow.line {
                1 => bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&bytes),
                _ => &bytes,
            };
            is_wrapped |= self.flow.line == 1 && envelope::is_header(line);
            let line = match (is_wrapped, envelope::is_header(line)) {
                (true, true) => &[],
                (true, false) => envelope::sent(line),
                (false, _) => line,
            };
            self.modal.state.line = self.flow.line;
            let kind = text.read(line, self.dialect);
            let goes_on = match kind {
                _ if text.is_optional && self.reading.block_delete => true,
                Ok(kind) => self.line(kind, &text)?,
                Err(problem) => self.problem(problem)?,
            };
            lines += 1;
            if lines.is_multiple_of(LINES) {
                self.progress();
            }
            if !goes_on {
                break;
            }
        }
        self.finish()
    }

    fn progress(&mut self) {
        let position = self.flow.stream.position;
        let moves = self.totals.moves;
        (self.on_event)(Event::Progress(Progress { bytes: position.bytes, lines: position.lines, moves }));
    }

    fn finish(mut self) -> Result<Summary, GcodeError> {
        self.rest()?;
        self.progress();
        let lines = self.flow.stream.position.lines;
        if !self.begun {
            return Err(GcodeError::NoCode { lines });
        }
        let (time, machine) = (self.timer.time(), *self.timer.machine());
        let mut summary = self.totals.summary(time, lines, self.dialect);
        summary.tool_change_time = summary.tool_changes as f64 * machine.tool_change;
        summary.spindle_time = summary.spindle_starts as f64 * machine.spindle_start;
        Ok(summary)
    }

    /// Whether the program goes on.
    fn line(&mut self, kind: Kind, text: &Text) -> Result<bool, GcodeError> {
        match kind {
            Kind::Mark => Ok(!self.begun || self.flow.line <= self.first_mark),
            Kind::Command => self.command(&text.code),
            Kind::Code if text.code.is_empty() => {
                self.begun |= !text.comment.is_empty();
                self.feature(&text.comment);
                Ok(true)
            }
            Kind::Code => self.code(&text.code),
        }
    }

    /// A comment that stands alone names what comes; of printers one that says so.
    fn feature(&mut self, comment: &[u8]) {
        const OF_CONTROLLERS: [&[u8]; 6] = [b"msg", b"debug", b"print", b"log", b"probe", b"abort"];
        let name = match self.dialect.prints() {
            true => {
                [b"TYPE:".as_slice(), b"FEATURE:", b"FEATURE: "].iter().find_map(|mark| comment.strip_prefix(*mark))
            }
            false => Some(comment),
        };
        let Some(name) = name.map(<[u8]>::trim_ascii).filter(|name| !name.is_empty()) else { return };
        let lower = name[..name.len().min(8)].to_ascii_lowercase();
        if OF_CONTROLLERS.iter().any(|word| lower.starts_with(word)) {
            return;
        }
        self.modal.state.feature = self.totals.feature(name);
    }

    fn code(&mut self, code: &[u8]) -> Result<bool, GcodeError> {
        let statement = match Statement::of(code, self.dialect) {
            Ok(statement) => statement,
            Err(problem) => return self.problem(problem),
        };
        let Some(statement) = statement else { return self.block(code) };
        self.begun = true;
        match self.flow.execute(&statement, code, &mut self.parameters, &self.modal.state)? {
            Next::Line => Ok(true),
            Next::Block(at) => self.block(&code[at..]),
            Next::End => Ok(false),
        }
    }

    fn block(&mut self, code: &[u8]) -> Result<bool, GcodeError> {
        if let Err(problem) = self.block.read(code, self.dialect, &mut self.parameters, &self.modal.state) {
            return self.problem(problem);
        }
        self.begun |= !self.block.is_empty();
        self.actions.clear();
        self.actions.extend(self.block.left_out.drain(..).map(Action::Tell));
        let end = self.modal.execute(&mut self.block, &mut self.actions);
        self.act()?;
        match end {
            Ok(End::Next) => Ok(true),
            Ok(End::Program) => Ok(false),
            Ok(End::Return) => {
                let next = self.flow.give_back(None, &mut self.parameters)?;
                Ok(!matches!(next, Next::End))
            }
            Ok(End::Call { arguments }) => self.call(arguments).map(|()| true),
            Err(problem) => self.problem(problem),
        }
    }

    /// M98 and G65: the number of the sub-program is P, and it comes L times; eight digits are both.
    fn call(&mut self, with_arguments: bool) -> Result<(), GcodeError> {
        let Some(number_of) = self.block.word('P').filter(|number| *number >= 0.0) else {
            let problem = Problem::Cycle { code: "the sub-program".to_owned(), why: "has no number: give P" };
            return self.problem(problem).map(|_| ());
        };
        let whole = number_of.round() as u64;
        let (times, whole) = match (self.block.word('L'), whole) {
            (Some(times), _) => (times.round().max(0.0) as u64, whole),
            (None, 10_000..) if self.dialect == Dialect::Fanuc => (whole / 10_000, whole % 10_000),
            (None, _) => (1, whole),
        };
        let arguments = with_arguments.then(|| parameters::arguments(self.block.words()));
        let label = number(whole.to_string().as_bytes());
        // Controllers keep sub-programs of M98 in a memory of their own.
        if !self.flow.knows(&label)? {
            self.tell(Problem::NoProgram { label });
            return Ok(());
        }
        self.flow.enter(&label, times, arguments, &mut self.parameters)
    }

    /// What printers call a macro, or a setting of grbl.
    fn command(&mut self, command: &[u8]) -> Result<bool, GcodeError> {
        self.begun = true;
        if let Some(words) = command.strip_prefix(b"set_velocity_limit") {
            self.timer.set_limits(&String::from_utf8_lossy(words));
            return Ok(true);
        }
        let name = String::from_utf8_lossy(command);
        let name: String = name.split(['=', ' ']).next().unwrap_or_default().chars().take(40).collect();
        let is_quiet = name.starts_with('$') && !name.starts_with("$h") && !name.starts_with("$j");
        if !is_quiet {
            let name = name.to_ascii_uppercase();
            self.rest()?;
            self.tell(Problem::Stopped { what: format!("{name} takes a time that nobody knows: it counts 0 s") });
        }
        Ok(true)
    }

    fn act(&mut self) -> Result<(), GcodeError> {
        let mut actions = std::mem::take(&mut self.actions);
        let outcome = actions.drain(..).try_for_each(|action| self.one(action));
        self.actions = actions;
        outcome
    }

    fn one(&mut self, action: Action) -> Result<(), GcodeError> {
        match action {
            Action::Move(cut) => {
                let line = cut.line;
                self.timer.add(&cut).map_err(|source| GcodeError::Plan { line, source })?;
                self.rows();
            }
            Action::Dwell(time) => {
                self.totals.dwell_time.add(time);
                self.pause(time)?;
            }
            Action::Rest => self.rest()?,
            Action::ToolChange => {
                self.totals.tool_changes += 1;
                self.pause(self.timer.machine().tool_change)?;
            }
            Action::SpindleStart => {
                self.totals.spindle_starts += 1;
                self.pause(self.timer.machine().spindle_start)?;
            }
            Action::Probed(has_touched) => self.probed(has_touched)?,
            Action::Limit { code, words } => {
                self.rest()?;
                self.timer.limit(code, &words);
            }
            Action::Tell(problem) => self.tell(problem),
        }
        Ok(())
    }

    /// Parameters of a probe: where it is, and whether it has touched.
    fn probed(&mut self, has_touched: bool) -> Result<(), GcodeError> {
        let here = self.modal.state.program_position();
        let units = (0..9).map(|axis| here[axis] / self.modal.state.unit_of(axis));
        let values = units.chain([f64::from(u8::from(has_touched))]);
        for (number, value) in (5061..).zip(values.collect::<Vec<f64>>()) {
            self.parameters.set(number, value).map_err(|problem| self.flow.fail(problem))?;
        }
        Ok(())
    }

    /// A time in which nothing moves.
    fn pause(&mut self, time: f64) -> Result<(), GcodeError> {
        self.rest()?;
        let line = self.flow.line;
        self.timer.dwell(time).map_err(|source| GcodeError::Plan { line, source })?;
        if time > 0.0 {
            (self.on_event)(Event::Dwell(time));
        }
        Ok(())
    }

    /// The moves before end at rest.
    fn rest(&mut self) -> Result<(), GcodeError> {
        let line = self.flow.line;
        self.timer.rest().map_err(|source| GcodeError::Plan { line, source })?;
        self.rows();
        Ok(())
    }

    fn rows(&mut self) {
        while let Some(row) = self.timer.next_row() {
            self.totals.add(&row);
            (self.on_event)(Event::Row(&row));
        }
    }

    /// Whether the program goes on.
    fn problem(&mut self, problem: Problem) -> Result<bool, GcodeError> {
        // What stands before the first mark is for people.
        if !self.begun && self.flow.line < self.first_mark {
            return Ok(true);
        }
        let notice = Notice { line: self.flow.line, problem };
        if self.reading.unknown == Unknown::Refuse || notice.problem.is_fatal() {
            return Err(notice.into());
        }
        self.totals.notices += 1;
        (self.on_event)(Event::Notice(&notice));
        Ok(true)
    }

    /// Says once what was passed over, and counts it.
    fn tell(&mut self, problem: Problem) {
        self.totals.notices += 1;
        if self.told.len() < MOST_TOLD && self.told.insert(problem.to_string()) {
            (self.on_event)(Event::Notice(&Notice { line: self.flow.line, problem }));
        }
    }
}
