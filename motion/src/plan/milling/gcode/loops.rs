//! Loops: `while`, `do` and `repeat`, and how they are left.

use std::io::BufRead;
use std::rc::Rc;

use super::error::{GcodeError, Problem};
use super::expression::Scanner;
use super::flow::{Flow, Frame, Loop, Outcome};
use super::parameters::{Controller, Parameters};
use super::source::Line;
use super::statement::{Keyword, Statement};

impl<R: BufRead> Flow<R> {
    pub(super) fn begin_loop(
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
    pub(super) fn collect(&mut self, label: &str, ends: &[Keyword]) -> Outcome<Vec<Line>> {
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

    pub(super) fn end_loop(&mut self, label: &str) -> Outcome<()> {
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

    pub(super) fn break_loop(&mut self, label: &str) -> Outcome<()> {
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

    pub(super) fn continue_loop(&mut self, label: &str) -> Outcome<()> {
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
}
