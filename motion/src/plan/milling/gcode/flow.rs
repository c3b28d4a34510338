//! The order of lines: loops, conditions, jumps and sub-programs.

use std::collections::HashMap;
use std::io::BufRead;
use std::path::PathBuf;
use std::rc::Rc;

use super::dialect::Dialect;
use super::error::{GcodeError, Notice, Problem};
use super::expression::Scanner;
use super::library;
use super::options::Reading;
use super::parameters::{ARGUMENTS, Controller, Parameters};
use super::source::{Line, Stream};
use super::statement::{Keyword, Label, Statement, line_number};
use super::text::Text;

/// Sub-programs in each other.
const DEEPEST: usize = 100;

/// Lines that are kept, and where in them the program is.
struct Frame {
    lines: Rc<[Line]>,
    at: usize,
    /// The sub-program that it is, if it is one.
    call: Option<Call>,
    loops: Vec<Loop>,
}

/// How a sub-program was called.
struct Call {
    /// How often it comes again.
    again: u64,
    /// Whether it has parameters of its own.
    has_locals: bool,
}

/// A loop that is under way.
struct Loop {
    label: String,
    /// The line behind its first one.
    start: usize,
    keyword: Keyword,
    /// Of `repeat`: how often it comes again.
    again: u64,
}

/// All that decides which line comes next.
pub(super) struct Flow<R> {
    pub(super) stream: Stream<R>,
    frames: Vec<Frame>,
    subs: HashMap<String, Rc<[Line]>>,
    dialect: Dialect,
    folders: Vec<PathBuf>,
    /// Of the line that is being executed.
    pub(super) line: u64,
    repeated: u64,
    most_repeated: u64,
    /// Whether the program has said its number: another one is that of a sub-program behind it.
    named: bool,
    text: Text,
}

/// What becomes of a statement.
pub(super) enum Next {
    /// The next line.
    Line,
    /// The rest of this line, from this place, is a block.
    Block(usize),
    /// Nothing: the program is at its end.
    End,
}

type Outcome<T> = Result<T, GcodeError>;

impl<R: BufRead> Flow<R> {
    pub(super) fn new(input: R, dialect: Dialect, reading: &Reading) -> Self {
        Self {
            stream: Stream::new(input, dialect == Dialect::Fanuc),
            frames: Vec::new(),
            subs: HashMap::new(),
            dialect,
            folders: reading.folders.clone(),
            line: 0,
            repeated: 0,
            most_repeated: reading.most_repeated,
            named: false,
            text: Text::default(),
        }
    }

    /// The next line to execute; none at the end of the file.
    pub(super) fn next(&mut self, bytes: &mut Vec<u8>, parameters: &mut Parameters) -> Outcome<bool> {
        while let Some(frame) = self.frames.last_mut() {
            if let Some(line) = frame.lines.get(frame.at) {
                frame.at += 1;
                bytes.clear();
                bytes.extend_from_slice(&line.bytes);
                self.line = line.number;
                return self.repeat().map(|()| true);
            }
            if frame.call.is_some() { self.leave(parameters)? } else { _ = self.frames.pop() }
        }
        let Some(number) = self.stream.next(bytes)? else { return Ok(false) };
        self.line = number;
        Ok(true)
    }

    fn repeat(&mut self) -> Outcome<()> {
        self.repeated += 1;
        if self.repeated <= self.most_repeated {
            return Ok(());
        }
        let remedy = "this is a loop that never ends, or allow more";
        Err(self.fail(Problem::Limit { what: "lines that are repeated", most: self.most_repeated, remedy }))
    }

    /// Executes a statement of this code.
    pub(super) fn execute(
        &mut self,
        statement: &Statement,
        code: &[u8],
        parameters: &mut Parameters,
        controller: &dyn Controller,
    ) -> Outcome<Next> {
        let label = self.label(statement, code, parameters, controller)?;
        let value = |at: usize| Scanner::new(code, at, parameters, controller).brackets();
        match statement.keyword {
            Keyword::Program => return Ok(self.program()),
            Keyword::Sub => self.define(&label)?,
            Keyword::Call => self.call(&label, code, statement.rest, parameters, controller)?,
            Keyword::EndSub | Keyword::Return => {
                let value = match code.get(statement.rest) {
                    Some(b'[') => Some(value(statement.rest).map_err(|problem| self.fail(problem))?),
                    _ => None,
                };
                return self.give_back(value, parameters);
            }
            Keyword::If => {
                if value(statement.rest).map_err(|problem| self.fail(problem))? == 0.0 {
                    self.other_branch(&label, parameters, controller)?;
                }
            }
            // Here comes who has been through the branch before.
            Keyword::ElseIf | Keyword::Else => _ = self.seek(&label, &[Keyword::EndIf])?,
            Keyword::EndIf => {}
            Keyword::While | Keyword::Do | Keyword::Repeat => {
                self.begin_loop(statement, &label, code, parameters, controller)?;
            }
            Keyword::EndWhile | Keyword::EndRepeat => self.end_loop(&label)?,
            Keyword::Break => self.break_loop(&label)?,
            Keyword::Continue => self.continue_loop(&label)?,
            Keyword::Macro => return self.if_then(code, statement.rest, parameters, controller),
            Keyword::Goto => {
                let target = Scanner::new(code, statement.rest, parameters, controller).value();
                self.jump(target.map_err(|problem| self.fail(problem))?)?;
            }
        }
        Ok(Next::Line)
    }

    fn label(
        &self,
        statement: &Statement,
        code: &[u8],
        parameters: &Parameters,
        controller: &dyn Controller,
    ) -> Outcome<String> {
        match &statement.label {
            Label::Known(label) => Ok(label.clone()),
            Label::Computed(at) => {
                let value = Scanner::new(code, *at, parameters, controller).value();
                Ok(format!("{}", value.map_err(|problem| self.fail(problem))?.round()))
            }
        }
    }

    /// The number of a program: the first one is its title, the next one begins another program.
    fn program(&mut self) -> Next {
        let again = std::mem::replace(&mut self.named, true);
        if again && self.frames.is_empty() { Next::End } else { Next::Line }
    }

    // ---- Conditions -------------------------------------------------------------------------------------------------

    /// Goes to the branch that is taken, where the condition does not hold.
    fn other_branch(&mut self, label: &str, parameters: &Parameters, controller: &dyn Controller) -> Outcome<()> {
        loop {
            let found = self.seek(label, &[Keyword::ElseIf, Keyword::Else, Keyword::EndIf])?;
            if found.keyword != Keyword::ElseIf {
                return Ok(());
            }
            let code = std::mem::take(&mut self.text.code);
            let value = Scanner::new(&code, found.rest, parameters, controller).brackets();
            self.text.code = code;
            if value.map_err(|problem| self.fail(problem))? != 0.0 {
                return Ok(());
            }
        }
    }

    /// Passes lines up to one of these statements, and it.
    fn seek(&mut self, label: &str, keywords: &[Keyword]) -> Outcome<Statement> {
        let begin = self.line;
        let mut bytes = Vec::new();
        loop {
            match self.frames.last_mut() {
                Some(frame) => {
                    let Some(line) = frame.lines.get(frame.at) else { break };
                    frame.at += 1;
                    bytes.clear();
                    bytes.extend_from_slice(&line.bytes);
                    self.line = line.number;
                }
                None => {
                    let Some(number) = self.stream.next(&mut bytes)? else { break };
                    self.line = number;
                }
            }
            if let Some(found) = Statement::of_raw(&bytes, self.dialect, &mut self.text)
                && found.is(label, keywords)
            {
                return Ok(found);
            }
        }
        self.line = begin;
        Err(self.fail(Problem::Flow { what: format!("O{label} has no end"), remedy: "give it" }))
    }

    /// `IF [..] GOTO 10`, `IF [..] THEN #1=2`.
    fn if_then(
        &mut self,
        code: &[u8],
        at: usize,
        parameters: &Parameters,
        controller: &dyn Controller,
    ) -> Outcome<Next> {
        let mut scanner = Scanner::new(code, at, parameters, controller);
        let holds = scanner.brackets().map_err(|problem| self.fail(problem))? != 0.0;
        if scanner.take(b"then") {
            return Ok(if holds { Next::Block(scanner.at) } else { Next::Line });
        }
        if !scanner.take(b"goto") {
            let what = "IF has neither GOTO nor THEN".to_owned();
            return Err(self.fail(Problem::Flow { what, remedy: "give one of them" }));
        }
        let target = scanner.value().map_err(|problem| self.fail(problem))?;
        if holds {
            self.jump(target)?;
        }
        Ok(Next::Line)
    }

    // ---- Loops ------------------------------------------------------------------------------------------------------

    fn begin_loop(
        &mut self,
        statement: &Statement,
        label: &str,
        code: &[u8],
        parameters: &Parameters,
        controller: &dyn Controller,
    ) -> Outcome<()> {
        let ends_do = statement.keyword == Keyword::While && self.is_do(label);
        if self.frames.is_empty() {
            self.enter_loop(statement, label, code)?;
        }
        // `WHILE` without a condition is Fanuc's `DO1` alone.
        let value = match statement.keyword {
            Keyword::Do => 1.0,
            Keyword::While if statement.rest >= code.len() => 1.0,
            _ => Scanner::new(code, statement.rest, parameters, controller)
                .brackets()
                .map_err(|problem| self.fail(problem))?,
        };
        if ends_do {
            return self.end_do(label, value != 0.0);
        }
        let again = if statement.keyword == Keyword::Repeat { value.round().max(0.0) as u64 } else { 1 };
        if value == 0.0 || again == 0 {
            let end = if statement.keyword == Keyword::Repeat { Keyword::EndRepeat } else { Keyword::EndWhile };
            self.seek(label, &[end])?;
            return Ok(());
        }
        if let Some(frame) = self.frames.last_mut() {
            let start = frame.at;
            // One that is under way begins anew.
            if let Some(known) = frame.loops.iter().position(|known| known.label == label) {
                frame.loops.truncate(known);
            }
            frame.loops.push(Loop { label: label.to_owned(), start, keyword: statement.keyword, again });
        }
        Ok(())
    }

    /// A loop of the stream: its lines are kept, and it is executed from them.
    fn enter_loop(&mut self, statement: &Statement, label: &str, code: &[u8]) -> Outcome<()> {
        let ends: &[Keyword] = match statement.keyword {
            Keyword::Do => &[Keyword::While],
            Keyword::Repeat => &[Keyword::EndRepeat],
            _ => &[Keyword::EndWhile],
        };
        let first = Line { number: self.line, bytes: Rc::from(code) };
        let mut lines = vec![self.stream.keep(first)?];
        lines.extend(self.collect(label, ends)?);
        self.frames.push(Frame { lines: lines.into(), at: 1, call: None, loops: Vec::new() });
        Ok(())
    }

    /// The lines up to one of these statements, and it.
    fn collect(&mut self, label: &str, ends: &[Keyword]) -> Outcome<Vec<Line>> {
        let mut lines = Vec::new();
        loop {
            let next = match self.frames.last_mut() {
                Some(frame) => {
                    let line = frame.lines.get(frame.at).cloned();
                    frame.at += 1;
                    line
                }
                None => self.stream.next_kept()?,
            };
            let Some(line) = next else { break };
            let found = Statement::of_raw(&line.bytes, self.dialect, &mut self.text);
            lines.push(line);
            if found.is_some_and(|found| found.is(label, ends)) {
                return Ok(lines);
            }
        }
        Err(self.fail(Problem::Flow { what: format!("O{label} has no end"), remedy: "give it" }))
    }

    fn find_loop(&self, label: &str) -> Option<usize> {
        self.frames.last()?.loops.iter().rposition(|known| known.label == label)
    }

    fn is_do(&self, label: &str) -> bool {
        let Some(frame) = self.frames.last() else { return false };
        self.find_loop(label).is_some_and(|index| frame.loops[index].keyword == Keyword::Do)
    }

    fn end_do(&mut self, label: &str, again: bool) -> Outcome<()> {
        let Some(index) = self.find_loop(label) else { return Err(self.no_loop(label)) };
        if let Some(frame) = self.frames.last_mut() {
            if again {
                frame.at = frame.loops[index].start;
                frame.loops.truncate(index + 1);
            } else {
                frame.loops.truncate(index);
            }
        }
        Ok(())
    }

    fn end_loop(&mut self, label: &str) -> Outcome<()> {
        let Some(index) = self.find_loop(label) else { return Err(self.no_loop(label)) };
        let Some(frame) = self.frames.last_mut() else { return Ok(()) };
        let known = &mut frame.loops[index];
        if known.keyword != Keyword::Repeat {
            // Its condition is asked again.
            frame.at = known.start - 1;
            frame.loops.truncate(index);
            return Ok(());
        }
        known.again -= 1;
        if known.again > 0 {
            frame.at = known.start;
            frame.loops.truncate(index + 1);
        } else {
            frame.loops.truncate(index);
        }
        Ok(())
    }

    fn break_loop(&mut self, label: &str) -> Outcome<()> {
        let Some(index) = self.find_loop(label) else { return Err(self.no_loop(label)) };
        let end = match self.frames.last().map(|frame| frame.loops[index].keyword) {
            Some(Keyword::Do) => Keyword::While,
            Some(Keyword::Repeat) => Keyword::EndRepeat,
            _ => Keyword::EndWhile,
        };
        self.seek(label, &[end])?;
        if let Some(frame) = self.frames.last_mut() {
            frame.loops.truncate(index);
        }
        Ok(())
    }

    fn continue_loop(&mut self, label: &str) -> Outcome<()> {
        let Some(index) = self.find_loop(label) else { return Err(self.no_loop(label)) };
        match self.frames.last().map(|frame| frame.loops[index].keyword) {
            Some(Keyword::Do) => {
                self.seek(label, &[Keyword::While])?;
                // Comes once more, and asks its condition.
                if let Some(frame) = self.frames.last_mut() {
                    frame.at -= 1;
                }
                Ok(())
            }
            _ => self.end_loop(label),
        }
    }

    fn no_loop(&self, label: &str) -> GcodeError {
        self.fail(Problem::Flow {
            what: format!("O{label} is no loop that is under way"),
            remedy: "correct its number",
        })
    }

    // ---- Jumps ------------------------------------------------------------------------------------------------------

    /// Goes to the line of this number: in the lines that are kept, in those that were passed, or in those that come.
    fn jump(&mut self, target: f64) -> Outcome<()> {
        let found = |line: &Line| line_number(&line.bytes).is_some_and(|number| number as f64 == target);
        while let Some(frame) = self.frames.last_mut() {
            if let Some(at) = frame.lines.iter().position(found) {
                frame.at = at;
                frame.loops.clear();
                return Ok(());
            }
            if frame.call.is_some() {
                return Err(self.no_line(target));
            }
            self.frames.pop();
        }
        let passed = self.stream.passed();
        if let Some(at) = passed.iter().rposition(found) {
            let lines: Rc<[Line]> = passed.iter().skip(at).cloned().collect();
            self.frames.push(Frame { lines, at: 0, call: None, loops: Vec::new() });
            return Ok(());
        }
        let mut bytes = Vec::new();
        while let Some(number) = self.stream.next(&mut bytes)? {
            let line = Line { number, bytes: Rc::from(bytes.as_slice()) };
            if found(&line) {
                self.stream.again(line);
                return Ok(());
            }
        }
        Err(self.no_line(target))
    }

    fn no_line(&self, target: f64) -> GcodeError {
        self.fail(Problem::Flow { what: format!("no line N{target} to go to"), remedy: "correct GOTO" })
    }

    // ---- Sub-programs -----------------------------------------------------------------------------------------------

    fn define(&mut self, label: &str) -> Outcome<()> {
        let lines = self.collect(label, &[Keyword::EndSub])?;
        self.subs.insert(label.to_owned(), lines.into());
        Ok(())
    }

    fn call(
        &mut self,
        label: &str,
        code: &[u8],
        at: usize,
        parameters: &mut Parameters,
        controller: &dyn Controller,
    ) -> Outcome<()> {
        let mut arguments = [0.0; ARGUMENTS];
        let mut scanner = Scanner::new(code, at, parameters, controller);
        for argument in arguments.iter_mut().take_while(|_| at < code.len()) {
            if scanner.peek() != Some(b'[') {
                break;
            }
            *argument = scanner.brackets().map_err(|problem| self.fail(problem))?;
        }
        self.enter(label, 1, Some(arguments), parameters)
    }

    /// Begins a sub-program, so many times; with parameters of its own where arguments are given.
    pub(super) fn enter(
        &mut self,
        label: &str,
        times: u64,
        arguments: Option<[f64; ARGUMENTS]>,
        parameters: &mut Parameters,
    ) -> Outcome<()> {
        let lines = self.find(label)?;
        if self.frames.iter().filter(|frame| frame.call.is_some()).count() >= DEEPEST {
            let remedy = "a sub-program calls itself without end";
            let what = "sub-programs in each other";
            return Err(self.fail(Problem::Limit { what, most: DEEPEST as u64, remedy }));
        }
        self.repeat()?;
        if times == 0 {
            return Ok(());
        }
        let has_locals = arguments.is_some();
        if let Some(arguments) = arguments {
            parameters.enter(arguments);
        }
        let call = Call { again: times - 1, has_locals };
        self.frames.push(Frame { lines, at: 0, call: Some(call), loops: Vec::new() });
        Ok(())
    }

    /// Whether there is such a sub-program.
    pub(super) fn knows(&mut self, label: &str) -> Outcome<bool> {
        Ok(self.search(label)?.is_some())
    }

    fn find(&mut self, label: &str) -> Outcome<Rc<[Line]>> {
        self.search(label)?.ok_or_else(|| {
            let what = format!("there is no sub-program O{label}");
            self.fail(Problem::Flow { what, remedy: "put it into the file, or beside it" })
        })
    }

    /// The lines of a sub-program: one that has come, one that comes later in the file, or one in a file of its own.
    fn search(&mut self, label: &str) -> Outcome<Option<Rc<[Line]>>> {
        if let Some(lines) = self.subs.get(label) {
            return Ok(Some(Rc::clone(lines)));
        }
        let (dialect, text) = (self.dialect, &mut self.text);
        let rest = self.stream.rest()?;
        let lines = library::cut(rest.iter(), label, dialect, text);
        let lines = match lines {
            Some(lines) => lines,
            None => match library::load(&self.folders, label, dialect, text) {
                Some(lines) => {
                    for line in &lines {
                        self.stream.keep(line.clone())?;
                    }
                    lines
                }
                None => return Ok(None),
            },
        };
        let lines: Rc<[Line]> = lines.into();
        self.subs.insert(label.to_owned(), Rc::clone(&lines));
        Ok(Some(lines))
    }

    /// A sub-program ends, with a value.
    pub(super) fn give_back(&mut self, value: Option<f64>, parameters: &mut Parameters) -> Outcome<Next> {
        while self.frames.last().is_some_and(|frame| frame.call.is_none()) {
            self.frames.pop();
        }
        if self.frames.is_empty() {
            return Ok(Next::End);
        }
        self.leave(parameters)?;
        let set = [("_value", value.unwrap_or(0.0)), ("_value_returned", f64::from(u8::from(value.is_some())))];
        for (name, value) in set {
            parameters.set_name(name, value).map_err(|problem| self.fail(problem))?;
        }
        Ok(Next::Line)
    }

    /// The sub-program on top is at its end: it comes again, or goes.
    fn leave(&mut self, parameters: &mut Parameters) -> Outcome<()> {
        self.repeat()?;
        let Some(frame) = self.frames.last_mut() else { return Ok(()) };
        if let Some(call) = &mut frame.call {
            if call.again > 0 {
                call.again -= 1;
                frame.at = 0;
                frame.loops.clear();
                return Ok(());
            }
            if call.has_locals {
                parameters.leave();
            }
        }
        self.frames.pop();
        Ok(())
    }

    /// The problem with the line where it is.
    pub(super) fn fail(&self, problem: Problem) -> GcodeError {
        Notice { line: self.line, problem }.into()
    }
}
