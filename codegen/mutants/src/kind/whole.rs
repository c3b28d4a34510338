//! Mistakes of a whole kernel: inputs of one unit swapped, results swapped, bounds lowered.

use closedform_syntax::{Condition, Expr, Kernel, Output, Slice};

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
    /// `None` if a slice no longer fits.
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

    fn condition(&self, condition: &Condition) -> Option<Condition> {
        let boxed = |inner: &Condition| self.condition(inner).map(Box::new);
        Some(match condition {
            Condition::Compare { op, left, right } => {
                Condition::Compare { op: *op, left: self.expression(left)?, right: self.expression(right)? }
            }
            Condition::Not(inner) => Condition::Not(boxed(inner)?),
            Condition::And(left, right) => Condition::And(boxed(left)?, boxed(right)?),
            Condition::Or(left, right) => Condition::Or(boxed(left)?, boxed(right)?),
        })
    }

    fn expression(&self, expr: &Expr) -> Option<Expr> {
        let boxed = |inner: &Expr| self.expression(inner).map(Box::new);
        Some(match expr {
            Expr::Literal { .. } | Expr::Pi(_) => expr.clone(),
            Expr::Name(name) => {
                let mut name = name.clone();
                name.slot = self.slot(name.slot);
                Expr::Name(name)
            }
            Expr::Neg(inner) => Expr::Neg(boxed(inner)?),
            Expr::Sqrt(inner) => Expr::Sqrt(boxed(inner)?),
            Expr::Abs(inner) => Expr::Abs(boxed(inner)?),
            Expr::Residual(inner) => Expr::Residual(boxed(inner)?),
            Expr::Compensated(slice) => Expr::Compensated(Slice::new(self.expression(&slice.value)?).ok()?),
            Expr::Binary { op, left, right } => Expr::Binary { op: *op, left: boxed(left)?, right: boxed(right)? },
            Expr::If { condition, then, otherwise } => Expr::If {
                condition: self.condition(condition)?.into(),
                then: boxed(then)?,
                otherwise: boxed(otherwise)?,
            },
            Expr::Extreme { largest, items } => Expr::Extreme { largest: *largest, items: self.all(items)? },
            Expr::PositiveRoot(coefficients) => Expr::PositiveRoot(self.all(coefficients)?),
        })
    }

    fn all(&self, list: &[Expr]) -> Option<Vec<Expr>> {
        list.iter().map(|expr| self.expression(expr)).collect()
    }

    fn slot(&self, slot: usize) -> usize {
        match slot {
            _ if slot == self.0 => self.1,
            _ if slot == self.1 => self.0,
            _ => slot,
        }
    }
}
