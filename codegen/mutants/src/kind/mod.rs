//! The kinds of mutation, a file each, and all mutants of a kernel.

mod branch;
mod coefficient;
mod compensated;
mod condition;
mod function;
mod name;
mod operator;
mod walk;
mod whole;

use std::collections::HashSet;

use closedform_syntax::{Expr, Kernel, Output};

use super::mistake::{Mistake, Nth, Wrong};
use super::place::{Change, Part};
use name::Names;
use walk::{Place, Walk};

/// A kernel with one mistake.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// What was changed.
    pub change: Change,
    /// The kernel with it.
    pub kernel: Kernel,
}

/// Every mutant of a kernel, each once, in the order of its source.
pub fn mutants(kernel: &Kernel) -> Vec<Mutant> {
    let kernel = bare(kernel);
    let names = Names::of(&kernel);
    let walk = Walk { expression: &|expr, place| expressions(expr, place, &names) };
    let mut mutants: Vec<Mutant> =
        Part::all(&kernel).into_iter().flat_map(|part| of_part(&kernel, part, &walk)).collect();
    mutants.extend(whole::mutants(&kernel));
    let mut seen = HashSet::new();
    mutants.retain(|Mutant { change, .. }| {
        change.was != change.is && seen.insert((change.line, change.was.clone(), change.is.clone()))
    });
    mutants
}

/// The kernel without what no mutation changes and every copy would carry.
fn bare(kernel: &Kernel) -> Kernel {
    let mut bare = kernel.clone();
    bare.attributes.clear();
    (bare.meta.maxima, bare.meta.latex, bare.meta.source) = (None, None, None);
    (bare.meta.summary, bare.meta.rules) = (String::new(), Vec::new());
    bare
}

/// What may stand for an expression, by every kind of mutation.
fn expressions(expr: &Expr, place: Place, names: &Names) -> Vec<Wrong<Expr>> {
    let mut found = operator::mutations(expr, place);
    found.extend(coefficient::mutations(expr));
    found.extend(function::mutations(expr, place));
    found.extend(names.mutations(expr));
    found.extend(branch::mutations(expr));
    found.extend(compensated::mutations(expr, place));
    found
}

fn of_part(kernel: &Kernel, part: Part, walk: &Walk) -> Vec<Mutant> {
    let kernels: Vec<Wrong<Kernel>> = match part {
        Part::Require(at) => {
            let conditions = condition::required(&kernel.requires[at].condition, walk).into_iter();
            let set = |condition| with(kernel, |kernel| kernel.requires[at].condition = condition);
            conditions.map(|wrong| wrong.map(set)).collect()
        }
        Part::Let(at) => {
            let values = statement(&kernel.lets[at].value, walk).into_iter();
            let set = |value| with(kernel, |kernel| kernel.lets[at].value = value);
            values.map(|wrong| wrong.map(set)).collect()
        }
        Part::Result(at) => {
            let value = kernel.output.values().nth(at);
            let values = value.into_iter().flat_map(|value| statement(value, walk));
            let set = |value| with(kernel, |kernel| set_result(kernel, at, value));
            values.map(|wrong| wrong.map(set)).collect()
        }
    };
    let (line, step, was) = (part.line(kernel), part.step(kernel), part.text(kernel));
    let kinds = Nth::count(&kernels);
    let mutant = |(Wrong { value: kernel, .. }, kind)| {
        let mistake = Mistake { step: step.clone(), kind };
        Mutant { change: Change::new(line, mistake, was.clone(), part.text(&kernel)), kernel }
    };
    kernels.into_iter().zip(kinds).map(mutant).collect()
}

/// What may stand for the value of a statement: another sign and a root besides what its parts allow.
fn statement(value: &Expr, walk: &Walk) -> Vec<Wrong<Expr>> {
    let mut values = walk.expression(value, Place::Plain);
    values.push(Wrong::new("value negated", operator::negated(value)));
    values.push(Wrong::new("value as its root", function::root(value)));
    values
}

fn with(kernel: &Kernel, change: impl FnOnce(&mut Kernel)) -> Kernel {
    let mut kernel = kernel.clone();
    change(&mut kernel);
    kernel
}

fn set_result(kernel: &mut Kernel, at: usize, value: Expr) {
    match &mut kernel.output {
        Output::Value(result) => *result = value,
        Output::Struct { fields, .. } => fields[at].1 = value,
    }
}
