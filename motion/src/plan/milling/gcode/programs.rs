//! Sub-programs: where they are, how they begin and end.

use std::io::BufRead;
use std::rc::Rc;

use super::error::Problem;
use super::expression::Scanner;
use super::flow::{Call, Flow, Frame, Next, Outcome};
use super::library;
use super::parameters::{ARGUMENTS, Controller, Parameters};
use super::source::Line;
use super::statement::Keyword;

/// Sub-programs in each other.
const DEEPEST: usize = 100;

impl<R: BufRead> Flow<R> {
    pub(super) fn define(&mut self, label: &str) -> Outcome<()> {
        let lines = self.collect(label, &[Keyword::EndSub])?;
        self.subs.insert(label.to_owned(), lines.into());
        Ok(())
    }

    pub(super) fn call(
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
    pub(super) fn leave(&mut self, parameters: &mut Parameters) -> Outcome<()> {
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
}
