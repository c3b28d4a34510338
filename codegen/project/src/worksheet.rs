//! A worksheet read as Maxima would read it, as far as its formulas need it: each name with the formula that it stands for.
//!
//! A function is worth what Maxima gives for it when the whole file has been read; a name what it was given last. What only
//! Maxima can know is refused with its place, and so is everything that depends on it.

mod arrays;
mod calls;
mod closed;
mod conditions;
mod defined;
mod differentiate;
mod effects;
mod evaluate;
mod formula;
mod items;
mod lists;
mod loops;
mod numbers;
mod reading;
mod state;
mod statements;
mod tree;
mod wanted;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use closedform_maxima::{Expr, ExprKind, Statement, mentions, parse_what_can_be};

pub(crate) use closed::closed;
use defined::{Kind, definitions};
use evaluate::Evaluator;
pub(crate) use formula::Formula;
use formula::Outcome;
pub(crate) use reading::Reading;
pub(crate) use state::Refusal;
use state::{Binding, State, Stop};
pub(crate) use statements::spelt;
pub(crate) use tree::any;
pub(crate) use wanted::{Wanted, is_about_numbers, wanted};
pub(crate) use words::{COMPUTE, ends_maxima, is_loading, is_package};

/// The room that evaluation may take on the stack.
const STACK: usize = 256 << 20;

/// Reads a worksheet; `files` has the texts of others by the names under which it may load them.
pub(crate) fn read(text: &str, files: BTreeMap<String, String>) -> Reading {
    let run = || Run::new(text, files).all();
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run);
        thread.ok().and_then(|thread| thread.join().ok()).unwrap_or_default()
    })
}

/// The names of files that a text may load.
pub(crate) fn loaded(text: &str) -> Vec<String> {
    let loading = mentions(text).into_iter().filter(|mention| words::is_loading(&mention.name));
    loading.filter_map(|mention| mention.argument).collect()
}

struct Run {
    statements: Vec<Statement>,
    evaluator: Evaluator,
    /// Where each name is defined, in the order of the text.
    defined: Vec<(String, Kind, Range<usize>)>,
    /// Definitions whose formulas are made.
    made: BTreeSet<usize>,
    reading: Reading,
}

impl Run {
    fn new(text: &str, files: BTreeMap<String, String>) -> Self {
        let (statements, errors) = parse_what_can_be(text);
        let taken = arrays::names_in(text, &statements);
        let evaluator = Evaluator::new(State::default(), files, arrays::Names::beside(taken));
        let reading = Reading { errors, ..Reading::default() };
        Self { statements, evaluator, defined: Vec::new(), made: BTreeSet::new(), reading }
    }

    fn all(mut self) -> Reading {
        for Statement { expression, .. } in std::mem::take(&mut self.statements) {
            if ends_maxima(&expression) {
                self.reading.passed.push(("`quit`, and what follows it".to_owned(), expression.span));
                break;
            }
            self.statement(&expression);
        }
        self.harvest(&[]);
        self.reading.inlined = self.evaluator.used;
        self.reading.passed.append(&mut self.evaluator.absent);
        self.reading.refuse_clashes();
        self.reading
    }

    fn statement(&mut self, statement: &Expr) {
        self.evaluator.rest();
        let statement = match self.evaluator.spliced(statement) {
            Ok(statement) => statement,
            Err(Stop::Refused(because)) => {
                effects::Effects::of(statement, &self.evaluator.state).apply(&mut self.evaluator.state, &because);
                self.note_definitions(statement);
                return;
            }
            Err(Stop::Return(value)) => value,
        };
        if let Some(lost) = lost(&statement, &self.evaluator.files) {
            self.harvest(&lost);
        }
        self.note_definitions(&statement);
        self.evaluator.rest();
        let left = self.evaluator.left;
        let value = self.evaluator.value(&statement);
        let is_obeyed = matches!(statement.kind, ExprKind::Loop { .. }) && self.evaluator.left == left;
        if let Some(what) = passed_over(&statement).filter(|_| !is_obeyed) {
            self.reading.passed.push((what, statement.span.clone()));
        }
        self.evaluator.state.last = match value {
            Ok(value) | Err(Stop::Return(value)) => Some(Binding::Value(value.into())),
            Err(Stop::Refused(because)) => {
                if passed_over(&statement).is_none() && definitions(&statement).is_empty() {
                    self.reading.passed.push((because.what.clone(), statement.span.clone()));
                }
                Some(Binding::Unknown(because.into()))
            }
        };
    }

    fn note_definitions(&mut self, statement: &Expr) {
        for (name, kind) in definitions(statement) {
            let same = |(at, (other, other_kind, _)): (usize, &(String, Kind, Range<usize>))| {
                (*other == name && *other_kind == kind).then_some(at)
            };
            if let Some(before) = self.defined.iter().enumerate().filter_map(same).next_back() {
                let span = self.defined[before].2.clone();
                self.reading.replaced.push((name.clone(), span));
                self.reading.formulas.retain(|formula| formula.name != name);
                self.reading.refused.retain(|(other, _)| *other != name);
                self.made.insert(before);
            }
            self.defined.push((name, kind, statement.span.clone()));
        }
    }

    /// The formulas of names that have none yet, as things stand; of all of them if none is named.
    fn harvest(&mut self, lost: &[String]) {
        let defined = self.defined.clone();
        for (at, (name, kind, span)) in defined.into_iter().enumerate() {
            if !lost.is_empty() && !lost.contains(&name) {
                continue;
            }
            if !self.made.insert(at) {
                continue;
            }
            self.evaluator.rest();
            let outcome = match kind {
                Kind::Function => formula::of_function(&name, &mut self.evaluator),
                Kind::Variable => formula::of_variable(&name, &span, &mut self.evaluator),
            };
            match outcome {
                Outcome::Formula(formula) => self.reading.formulas.push(formula),
                Outcome::Constant => self.reading.constants.push(name),
                Outcome::Refused(because) => self.reading.refused.push((name, because)),
            }
        }
    }
}

/// The names that lose what they stand for in a statement, whose formulas must be made before; an empty list for all.
fn lost(statement: &Expr, files: &BTreeMap<String, String>) -> Option<Vec<String>> {
    let kills =
        |part: &Expr| part.as_call().is_some_and(|(name, _)| ["kill", "remvalue", "remfunction"].contains(&name));
    if let Some((_, names)) = statement.as_call().filter(|_| kills(statement)) {
        let names: Option<Vec<&str>> = names.iter().map(Expr::as_symbol).collect();
        let each = names.filter(|names| !names.iter().any(|name| ["all", "values", "functions"].contains(name)));
        return Some(each.unwrap_or_default().into_iter().map(str::to_owned).collect());
    }
    let is_at_hand = |file: &Expr| match &file.kind {
        ExprKind::String(name) | ExprKind::Symbol(name) => files.contains_key(name),
        _ => false,
    };
    let loads = |part: &Expr| {
        let call = part.as_call();
        call.is_some_and(|(name, arguments)| {
            words::is_sweeping(name) || words::is_loading(name) && arguments.iter().any(is_at_hand)
        })
    };
    tree::any(statement, &|part| kills(part) || loads(part)).then(Vec::new)
}

/// What a statement is that no formula comes of, if it is worth a word.
fn passed_over(statement: &Expr) -> Option<String> {
    match &statement.kind {
        ExprKind::Loop { .. } => Some("a loop".to_owned()),
        ExprKind::If { .. } => Some("a condition".to_owned()),
        ExprKind::Call { .. } => {
            let (name, _) = statement.as_call()?;
            let quiet = name == "define" || words::is_obeyed(name) || words::is_loading(name) || name == ":lisp";
            (!quiet).then(|| format!("a call of `{name}`"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests;
