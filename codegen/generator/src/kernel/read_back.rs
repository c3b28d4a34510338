//! Reading back: what a result of a kernel's Rust text is as an exact expression, on every way through its `if`s.

use closedform_project::expression::Expr;
use closedform_syntax::{BinaryOp, Expr as Source, Kernel as SourceKernel};
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::{HashMap, HashSet};
use std::ptr;

/// The name under which the iterate of a polynomial root is known in expressions.
pub const ITERATE: &str = "%iterate";

/// An `if` of the text, by its place in memory: two that read alike are two.
type Choice = *const Source;

/// Reads the text of one kernel.
pub struct Reader<'k> {
    kernel: &'k SourceKernel,
    inputs: &'k [String],
    /// The `if`s whose sides are the same function: one side stands for both.
    settled: HashSet<Choice>,
}

/// A value on one way through the `if`s that it reads.
pub struct Way {
    /// The values of the expressions asked for.
    pub values: Vec<Expr>,
    /// The polynomials of polynomial roots, in the iterate.
    pub roots: Vec<Expr>,
}

/// More ways than are worth a look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyWays {
    /// How many `if`s with different sides are read.
    pub choices: usize,
}

impl<'k> Reader<'k> {
    /// A reader to whom no `if` is settled yet; `inputs` are the Maxima names of the kernel's inputs.
    pub fn new(kernel: &'k SourceKernel, inputs: &'k [String]) -> Self {
        Self { kernel, inputs, settled: HashSet::new() }
    }

    /// Lets one side stand for both in every `if` whose sides are the `same`, inner ones first; at most `limit` ways
    /// through a pair of sides are looked at.
    pub fn settle(&mut self, limit: usize, mut same: impl FnMut(&Expr, &Expr) -> bool) {
        let steps = self.kernel.lets.iter().map(|step| &step.value);
        let mut choices = Vec::new();
        steps.chain(self.kernel.output.values()).for_each(|value| collect_choices(value, &mut choices));
        for choice in choices {
            let Source::If { then, otherwise, .. } = choice else { continue };
            let ways = self.ways(&[then, otherwise], limit);
            if ways.is_ok_and(|ways| ways.iter().all(|way| same(&way.values[0], &way.values[1]))) {
                self.settled.insert(ptr::from_ref(choice));
            }
        }
    }

    /// What stands behind an expression that is only a name.
    pub fn resolved(&self, expr: &'k Source) -> &'k Source {
        match expr {
            Source::Name(name) => self.step(name.slot).map_or(expr, |step| self.resolved(step)),
            _ => expr,
        }
    }

    /// The value of a step; `None` for an input.
    fn step(&self, slot: usize) -> Option<&'k Source> {
        let position = slot.checked_sub(self.inputs.len())?;
        self.kernel.lets.get(position).map(|step| &step.value)
    }

    /// The values of some expressions together on every way through the `if`s that they read, steps included.
    ///
    /// # Errors
    /// When there are more than `limit` ways.
    pub fn ways(&self, exprs: &[&'k Source], limit: usize) -> Result<Vec<Way>, TooManyWays> {
        let mut ways = Vec::new();
        let mut turns = Vec::new();
        loop {
            if ways.len() == limit {
                return Err(TooManyWays { choices: self.open_choices(exprs) });
            }
            let mut walk = Walk { reader: self, turns, known: HashMap::new(), roots: Vec::new() };
            let values = exprs.iter().map(|expr| walk.value(expr)).collect();
            ways.push(Way { values, roots: walk.roots });
            match next_turns(walk.turns) {
                Some(next) => turns = next,
                None => return Ok(ways),
            }
        }
    }

    /// How many `if`s that are not settled some expressions can read.
    fn open_choices(&self, exprs: &[&'k Source]) -> usize {
        let mut choices: Vec<&Source> = Vec::new();
        let (mut seen, mut open) = (HashSet::new(), exprs.to_vec());
        while let Some(expr) = open.pop() {
            match expr {
                Source::Name(name) if seen.insert(name.slot) => open.extend(self.step(name.slot)),
                Source::If { .. } => choices.push(expr),
                _ => {}
            }
            open.extend(operands(expr));
        }
        choices.into_iter().filter(|choice| !self.settled.contains(&ptr::from_ref(*choice))).count()
    }
}

/// The last turn that took the `then` side takes the other one, and all after it are open again.
fn next_turns(mut turns: Vec<(Choice, bool)>) -> Option<Vec<(Choice, bool)>> {
    while let Some((choice, holds)) = turns.pop() {
        if holds {
            turns.push((choice, false));
            return Some(turns);
        }
    }
    None
}

/// What a value is made of: a condition only chooses.
fn operands(expr: &Source) -> Vec<&Source> {
    match expr {
        Source::If { then, otherwise, .. } => vec![then, otherwise],
        other => other.children(),
    }
}

/// Every `if` in an expression, inner ones first.
fn collect_choices<'k>(expr: &'k Source, choices: &mut Vec<&'k Source>) {
    operands(expr).into_iter().for_each(|operand| collect_choices(operand, choices));
    if matches!(expr, Source::If { .. }) {
        choices.push(expr);
    }
}

/// One way through a kernel.
struct Walk<'a, 'k> {
    reader: &'a Reader<'k>,
    /// The turns taken, in the order in which they were met: whether each condition holds.
    turns: Vec<(Choice, bool)>,
    /// The steps read so far.
    known: HashMap<usize, Expr>,
    roots: Vec<Expr>,
}

impl<'k> Walk<'_, 'k> {
    fn value(&mut self, expr: &'k Source) -> Expr {
        match expr {
            Source::Literal { value, .. } => {
                Expr::Rational(BigRational::from_float(*value).unwrap_or_else(BigRational::zero))
            }
            Source::Name(name) => self.slot(name.slot),
            Source::Pi(_) => Expr::Pi,
            Source::Neg(a) => self.value(a).negated(),
            Source::Call(function, a) => Expr::call(*function, self.value(a)),
            Source::Compensated(expression) => self.value(&expression.value),
            Source::Residual(a) => self.value(a),
            Source::Binary { op, left, right } => {
                let (left, right) = (self.value(left), self.value(right));
                match op {
                    BinaryOp::Add => left.plus(right),
                    BinaryOp::Sub => left.minus(right),
                    BinaryOp::Mul => left.times(right),
                    BinaryOp::Div => left.over(right),
                }
            }
            Source::If { then, otherwise, .. } => {
                let side = if self.takes(expr) { then } else { otherwise };
                self.value(side)
            }
            Source::Extreme { largest, items } => {
                Expr::Extreme { largest: *largest, items: items.iter().map(|item| self.value(item)).collect() }
            }
            Source::PositiveRoot(coefficients) => {
                let terms = coefficients.iter().enumerate().map(|(power, coefficient)| {
                    let coefficient = self.value(coefficient);
                    coefficient.times(Expr::Power(Box::new(Expr::symbol(ITERATE)), power as i32))
                });
                let polynomial = Expr::Sum(terms.collect());
                self.roots.push(polynomial);
                Expr::symbol(ITERATE)
            }
        }
    }

    fn slot(&mut self, slot: usize) -> Expr {
        let Some(step) = self.reader.step(slot) else { return Expr::symbol(&self.reader.inputs[slot]) };
        if let Some(known) = self.known.get(&slot) {
            return known.clone();
        }
        let value = self.value(step);
        self.known.insert(slot, value.clone());
        value
    }

    /// Whether the way goes through the `then` side of an `if`: as it did where that was met before.
    fn takes(&mut self, choice: &'k Source) -> bool {
        let choice = ptr::from_ref(choice);
        if self.reader.settled.contains(&choice) {
            return true;
        }
        match self.turns.iter().find(|(known, _)| *known == choice) {
            Some((_, holds)) => *holds,
            None => {
                self.turns.push((choice, true));
                true
            }
        }
    }
}
