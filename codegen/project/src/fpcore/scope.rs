//! Names with values, and how much their formulas grow when every name is put in.

use std::cell::Cell;
use std::ops::Range;
use std::rc::Rc;

use closedform_maxima::{Expr, HEIGHT_LIMIT};

use super::mistake::CoreMistake;
use super::read::Node;
use crate::construct::SIZE_LIMIT;

/// A formula, how many nodes it has and how high it is.
#[derive(Clone)]
pub(super) struct Value {
    pub(super) expr: Expr,
    size: usize,
    height: usize,
}

impl Value {
    /// A formula made of others.
    ///
    /// # Errors
    /// When it is larger than anything that is worth making a kernel of.
    pub(super) fn made(
        span: &Range<usize>,
        parts: Vec<Value>,
        make: impl FnOnce(Vec<Expr>) -> Expr,
    ) -> Result<Self, CoreMistake> {
        let size = parts.iter().fold(0, |sum: usize, part| sum.saturating_add(part.size));
        let height = parts.iter().map(|part| part.height).max().unwrap_or(0);
        if size > SIZE_LIMIT || height > HEIGHT_LIMIT {
            return Err(too_large(span));
        }
        let mut expr = make(parts.into_iter().map(|part| part.expr).collect());
        expr.span = span.clone();
        Ok(Self { expr, size: size + ADDED, height: height + ADDED })
    }
}

fn too_large(span: &Range<usize>) -> CoreMistake {
    let remedy = "make a part of it a core of its own, and its value an input";
    CoreMistake::new("the formula is too large when all names are put in", remedy, span.clone())
}

/// One operation of FPCore is at most so many of Maxima, inside each other or beside each other.
const ADDED: usize = 4;

/// A core that later ones may call.
pub(super) struct Callable<'a> {
    pub(super) name: String,
    pub(super) parameters: Vec<String>,
    pub(super) body: &'a Node,
}

/// The names that mean something, the innermost last, and the cores that may be called.
pub(super) struct Scope<'a> {
    names: Vec<(String, Value)>,
    cores: &'a [Callable<'a>],
    /// How many calls of cores stand around the current place.
    calls: usize,
    /// How many nodes were put in so far, also where they are not used in the end.
    work: Rc<Cell<usize>>,
}

/// How many calls of cores may stand inside each other.
const MOST_CALLS: usize = 32;

/// The most nodes that are put in for one core.
const MOST_WORK: usize = 10 * SIZE_LIMIT;

impl<'a> Scope<'a> {
    pub(super) fn new(cores: &'a [Callable<'a>]) -> Self {
        Self { names: Vec::new(), cores, calls: 0, work: Rc::default() }
    }

    /// Inside a core that is called here: its arguments are all that it knows.
    ///
    /// # Errors
    /// When that goes on too long.
    pub(super) fn of_core(&self, span: &Range<usize>) -> Result<Self, CoreMistake> {
        let calls = self.calls + 1;
        if calls > MOST_CALLS {
            let what = format!("more than {MOST_CALLS} calls of cores inside each other");
            return Err(CoreMistake::new(what, "write a core out where it is called", span.clone()));
        }
        self.worked(SIZE_LIMIT / 100, span)?;
        Ok(Self { names: Vec::new(), cores: self.cores, calls, work: Rc::clone(&self.work) })
    }

    fn worked(&self, nodes: usize, span: &Range<usize>) -> Result<(), CoreMistake> {
        self.work.set(self.work.get().saturating_add(nodes));
        if self.work.get() > MOST_WORK { Err(too_large(span)) } else { Ok(()) }
    }

    pub(super) fn core(&self, name: &str) -> Option<&'a Callable<'a>> {
        self.cores.iter().find(|core| core.name == name)
    }

    pub(super) fn set(&mut self, name: String, value: Value) {
        self.names.push((name, value));
    }

    /// What a name stands for, if it stands for anything.
    pub(super) fn value(&self, name: &str, span: &Range<usize>) -> Option<Result<Value, CoreMistake>> {
        let (_, value) = self.names.iter().rev().find(|(known, _)| known == name)?;
        Some(self.worked(value.size, span).map(|()| value.clone()))
    }

    /// How many names there are, to forget later ones.
    pub(super) fn len(&self) -> usize {
        self.names.len()
    }

    pub(super) fn forget(&mut self, len: usize) {
        self.names.truncate(len);
    }
}
