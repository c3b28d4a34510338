//! The order of lines: loops, conditions, jumps and sub-programs.

use std::collections::HashMap;
use std::io::BufRead;
use std::path::PathBuf;
use std::rc::Rc;

use super::dialect::Dialect;
use super::error::{GcodeError, Notice, Problem};
use super::expression::Scanner;
use super::options::Reading;
use super::parameters::{Controller, Parameters};
use super::source::{Line, Stream};
use super::statement::{Keyword, Label, Statement, line_number};
use super::text::Text;

/// Lines that are kept, and where in them the program is.
pub(super) struct Frame {
    pub(super) lines: Rc<[Line]>,
    pub(super) at: usize,
    /// The sub-program that it is, if it is one.
    pub(super) call: Option<Call>,
    pub(super) loops: Vec<Loop>,
}

/// How a sub-program was called.
pub(super) struct Call {
    /// How often it comes again.
    pub(super) again: u64,
    /// Whether it has parameters of its own.
    pub(super) has_locals: bool,
}

/// A loop that is under way.
pub(super) struct Loop {
    pub(super) label: String,
    /// The line behind its first one.
    pub(super) start: usize,
    pub(super) keyword: Keyword,
    /// Of `repeat`: how often it comes again.
    pub(super) again: u64,
}

/// All that decides which line comes next.
pub(super) struct Flow<R> {
    pub(super) stream: Stream<R>,
    pub(super) frames: Vec<Frame>,
    pub(super) subs: HashMap<String, Rc<[Line]>>,
    pub(super) dialect: Dialect,
    pub(super) folders: Vec<PathBuf>,
    /// Of the line that is being executed.
    pub(super) line: u64,
    pub(super) repeated: u64,
    pub(super) most_repeated: u64,
    /// Whether the program has said its number: another one is that of a sub-program behind it.
    pub(super) named: bool,
    pub(super) text: Text,
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

pub(super) type Outcome<T> = Result<T, GcodeError>;

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

    pub(super) fn repeat(&mut self) -> Outcome<()> {
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
    pub(super) fn seek(&mut self, label: &str, keywords: &[Keyword]) -> Outcome<Statement> {
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

    /// The problem with the line where it is.
    pub(super) fn fail(&self, problem: Problem) -> GcodeError {
        Notice { line: self.line, problem }.into()
    }
}
