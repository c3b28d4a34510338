//! The interpreter of tables, in balls of one size.

use core::cmp::Ordering;

use super::format::{Instruction, Source, Table};
use crate::ball::{Ball, Decisions};
use crate::exact;
use crate::factored::Stack;
use crate::limits::MAX_HELD;
use crate::operand::Operand;
use crate::real::Real;
use crate::relation::Relation;
use crate::terms::Terms;

/// A condition: whether it holds, where that is decided.
type Truth = Option<bool>;

/// How a run ends.
pub(super) enum End {
    /// All results are found.
    Results,
    /// The condition of the domain at this position does not hold; that of those before it may be open.
    Outside(usize),
    /// Whether the inputs lie in the domain is open.
    OpenDomain,
    /// They do, and some result is open.
    OpenResults,
}

/// A run of a table.
pub(super) struct Machine<'r, 's, const L: usize> {
    pub(super) table: &'r Table<'r>,
    pub(super) inputs: &'r [f64],
    pub(super) registers: &'r mut [Ball<'s, L>],
    pub(super) decisions: &'s Decisions,
    /// Whether no larger balls are left: then what is open is left open, and exact sums are asked.
    pub(super) last: bool,
    /// What a register would hold that the table does not have.
    pub(super) missing: Ball<'s, L>,
    pub(super) truths: Stack<Truth, MAX_HELD>,
    /// Whether the table needs more room for conditions than there is: then nothing is decided.
    pub(super) overflows: bool,
}

impl<'s, const L: usize> Machine<'_, 's, L> {
    /// Runs the table; `end` takes a result, and says whether it is good enough.
    pub(super) fn run(&mut self, mut end: impl FnMut(usize, &Ball<'s, L>) -> bool) -> End {
        let (mut at, mut required, mut returned, mut open) = (0, 0, 0, false);
        while let Some(&instruction) = self.table.instructions.get(at) {
            at += 1;
            if self.overflows {
                return End::OpenDomain;
            }
            match instruction {
                Instruction::Require => {
                    let truth = self.truths.pop().flatten();
                    // a violation is named only if the conditions before it are decided, while they can be
                    match truth {
                        Some(false) if !open || self.last => return End::Outside(required),
                        _ => open |= truth.is_none(),
                    }
                    required += 1;
                    if open && required == self.table.conditions {
                        return End::OpenDomain;
                    }
                }
                Instruction::Unless(target) => match self.truths.pop().flatten() {
                    Some(true) => {}
                    Some(false) => at = at.max(target.into()),
                    None => return End::OpenResults,
                },
                Instruction::Jump(target) => at = at.max(target.into()),
                Instruction::Return(from) => {
                    open |= !end(returned, self.read(from));
                    returned += 1;
                }
                other => self.step(other),
            }
        }
        if open { End::OpenResults } else { End::Results }
    }

    fn step(&mut self, instruction: Instruction) {
        match instruction {
            Instruction::Compare(relation, a, b) => self.put(holds(relation, self.read(a).order(self.read(b)))),
            Instruction::And => self.join(|one, other| decided(one, other, false)),
            Instruction::Or => self.join(|one, other| decided(one, other, true)),
            Instruction::Not => {
                let truth = self.truths.pop().flatten();
                self.put(truth.map(|truth| !truth));
            }
            _ => {
                if let Some((to, value)) = self.value(instruction)
                    && let Some(register) = self.registers.get_mut(usize::from(to))
                {
                    *register = value;
                }
            }
        }
    }

    /// The register of an instruction, and what it takes.
    fn value(&self, instruction: Instruction) -> Option<(u8, Ball<'s, L>)> {
        let read = |register| self.read(register);
        Some(match instruction {
            Instruction::Input(to, input) => (to, self.exact(self.inputs.get(usize::from(input))?)),
            Instruction::Number(to, number) => (to, self.exact(self.table.numbers.get(usize::from(number))?)),
            Instruction::Pi(to) => (to, read(to).pi()),
            Instruction::Copy(to, a) => (to, read(a).clone()),
            Instruction::Negate(to, a) => (to, read(a).neg()),
            Instruction::Call(to, a, function) => (to, read(a).call(function)),
            Instruction::Add(to, a, b) => (to, read(a).add(read(b))),
            Instruction::Subtract(to, a, b) => (to, read(a).sub(read(b))),
            Instruction::Multiply(to, a, b) => (to, read(a).mul(read(b))),
            Instruction::Divide(to, a, b) => (to, read(a).div(read(b))),
            Instruction::Larger(to, a, b) => (to, read(a).extreme(read(b), Ordering::Greater)),
            Instruction::Smaller(to, a, b) => (to, read(a).extreme(read(b), Ordering::Less)),
            Instruction::PositiveRoot(to, first, count) => {
                let first = usize::from(first);
                let coefficients = self.registers.get(first..first + usize::from(count))?;
                (to, read(to).positive_root(coefficients))
            }
            Instruction::Exactly(to, sum) => (to, self.exactly(to, sum)?),
            _ => return None,
        })
    }

    fn read(&self, register: u8) -> &Ball<'s, L> {
        self.registers.get(usize::from(register)).unwrap_or(&self.missing)
    }

    fn exact(&self, value: &f64) -> Ball<'s, L> {
        Ball::new(*value, self.decisions)
    }

    /// The exact sum instead of a ball whose sign is open, where no larger balls are left.
    fn exactly(&self, to: u8, sum: u16) -> Option<Ball<'s, L>> {
        if !self.last || self.read(to).has_sign() {
            return None;
        }
        let sum = self.table.sums.get(usize::from(sum))?;
        if sum.operands.iter().any(|source| self.operand(*source).is_none()) {
            return None;
        }
        let operand = |position: u8| self.operand(*sum.operands.get(usize::from(position))?);
        let value = exact::polynomial(&operand, Terms::of(sum.terms))?;
        Some(self.read(to).found(value))
    }

    fn operand(&self, source: Source) -> Option<Operand> {
        match source {
            Source::Register(register) => self.read(register).operand(),
            Source::Literal(number) => self.table.numbers.get(usize::from(number)).copied().and_then(Operand::of),
        }
    }

    fn put(&mut self, truth: Truth) {
        self.overflows |= self.truths.push(truth).is_none();
    }

    fn join(&mut self, joined: fn(Truth, Truth) -> Truth) {
        let (one, other) = (self.truths.pop().flatten(), self.truths.pop().flatten());
        self.put(joined(one, other));
    }
}

/// Of two conditions, where one that is `decisive` decides by itself.
fn decided(one: Truth, other: Truth, decisive: bool) -> Truth {
    match (one, other) {
        _ if one == Some(decisive) || other == Some(decisive) => Some(decisive),
        (Some(_), Some(_)) => Some(!decisive),
        _ => None,
    }
}

/// Whether a relation holds: what has no value only differs from all else.
fn holds(relation: Relation, order: Option<Option<Ordering>>) -> Truth {
    order.map(|order| order.map_or(relation == Relation::NotEqual, |order| relation.holds(order)))
}
