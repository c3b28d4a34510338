//! Mistakes of a whole kernel: inputs of one unit swapped, results swapped, bounds lowered.

use closedform_syntax::{Expr, Kernel, Output};

use super::{Mutant, with};
use crate::mistake::{Mistake, Nth};
use crate::place::{Change, Part};

/// The mutants that no single statement makes.
pub fn mutants(kernel: &Kernel) -> Vec<Mutant> {
    let mut found = inputs(kernel);
    found.extend(results(kernel));
    found.extend(bounds(kernel));
    found
}

fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |one| (one + 1..count).map(move |other| (one, other)))
}

/// A mutant by its step and the kind of its mistake, of which there is one.
fn mutant(kernel: &Kernel, (step, kind): (&str, &str), [was, is]: [String; 2], mutated: Kernel) -> Mutant {
    let mistake = Mistake { step: step.to_owned(), kind: Nth::new(kind, 1) };
    Mutant { change: Change::new(kernel.name.span().start().line, mistake, was, is), kernel: mutated }
}

/// Two inputs of one unit, each in the place of the other.
fn inputs(kernel: &Kernel) -> Vec<Mutant> {
    let alike =
        pairs(kernel.inputs.len()).filter(|(one, other)| kernel.inputs[*one].unit == kernel.inputs[*other].unit);
    let swapped = alike.filter_map(|(one, other)| {
        let [first, second] = [one, other].map(|at| kernel.inputs[at].name.to_string());
        let mutated = Swap(one, other).kernel(kernel)?;
        let texts = [format!("fn({first}, {second})"), format!("fn({second}, {first})")];
        Some(mutant(kernel, ("inputs", &format!("{first} and {second} swapped")), texts, mutated))
    });
    swapped.collect()
}

/// Two fields, each with the value of the other.
fn results(kernel: &Kernel) -> Vec<Mutant> {
    let Output::Struct { fields, .. } = &kernel.output else { return Vec::new() };
    let swapped = pairs(fields.len()).map(|(one, other)| {
        let mutated = with(kernel, |kernel| {
            if let Output::Struct { fields, .. } = &mut kernel.output {
                let kept = fields[one].1.clone();
                fields[one].1 = std::mem::replace(&mut fields[other].1, kept);
            }
        });
        let texts = |kernel: &Kernel| [one, other].map(|at| Part::Result(at).text(kernel)).join(" ");
        let kind = format!("{} and {} swapped", fields[one].0, fields[other].0);
        mutant(kernel, ("results", &kind), [texts(kernel), texts(&mutated)], mutated)
    });
    swapped.collect()
}

/// A bound that promises twice as much.
fn bounds(kernel: &Kernel) -> Vec<Mutant> {
    let results = kernel.meta.results.iter().enumerate();
    let lowered = results.filter_map(|(at, result)| {
        let bound = result.bound?;
        let mutated = with(kernel, |kernel| kernel.meta.results[at].bound = Some(bound / 2.0));
        let text = |bound: f64| format!("bound({} = {bound})", result.name);
        let kind = format!("bound of {} halved", result.name);
        Some(mutant(kernel, ("bounds", &kind), [text(bound), text(bound / 2.0)], mutated))
    });
    lowered.collect()
}

/// Two slots, each in the place of the other, in the steps and results of a kernel.
struct Swap(usize, usize);

impl Swap {
    /// `None` if a compensated expression no longer fits.
    fn kernel(&self, kernel: &Kernel) -> Option<Kernel> {
        let mut kernel = kernel.clone();
        for step in &mut kernel.lets {
            step.value = self.expression(&step.value)?;
        }
        match &mut kernel.output {
            Output::Value(value) => *value = self.expression(value)?,
            Output::Struct { fields, .. } => {
                for (_, value) in fields {
                    *value = self.expression(value)?;
                }
            }
        }
        Some(kernel)
    }

    fn expression(&self, expr: &Expr) -> Option<Expr> {
        if let Expr::Name(name) = expr {
            let mut name = name.clone();
            name.slot = self.slot(name.slot);
            return Some(Expr::Name(name));
        }
        let children = expr.children().into_iter().map(|child| self.expression(child)).collect::<Option<_>>()?;
        expr.with_children(children)
    }

    fn slot(&self, slot: usize) -> usize {
        match slot {
            _ if slot == self.0 => self.1,
            _ if slot == self.1 => self.0,
            _ => slot,
        }
    }
}
