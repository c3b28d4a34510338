//! The interpreter: what a kernel computes, without compiling it.

use std::cmp::Ordering;

use closedform_arith::{Real, Relation};

use crate::compensated::{Extended, Operand, Operation, Part};
use crate::kernel::{BinaryOp, CompensatedExpr, Condition, Expr, Kernel, Let};

/// Why inputs lie outside the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Violation {
    /// An input, by position, is infinite or NaN.
    NotFinite(usize),
    /// A `require!`, by position, does not hold.
    Require(usize),
}

/// The results of `kernel`, in order, whether or not the inputs lie in its domain. The first input sets the precision of
/// literals, as in the compiled kernel.
///
/// # Panics
///
/// When there are not as many inputs as the kernel has.
pub fn evaluate<R: Real>(kernel: &Kernel, inputs: &[R]) -> Vec<R> {
    let mut machine = Machine::new(kernel, inputs);
    kernel.lets.iter().for_each(|step| machine.step(step));
    kernel.output.values().map(|value| machine.value(value)).collect()
}

/// The first condition of the domain of `kernel` that the inputs violate.
///
/// # Panics
///
/// When there are not as many inputs as the kernel has.
pub fn violated<R: Real>(kernel: &Kernel, inputs: &[R]) -> Option<Violation> {
    let machine = Machine::new(kernel, inputs);
    if let Some(input) = inputs.iter().position(|input| !input.is_finite()) {
        return Some(Violation::NotFinite(input));
    }
    let all: Vec<bool> = kernel.requires.iter().map(|require| machine.holds(&require.condition)).collect();
    all.iter().position(|holds| !holds).map(Violation::Require)
}

struct Machine<R> {
    /// Inputs, at least one, followed by the steps taken so far.
    slots: Vec<R>,
}

impl<R: Real> Machine<R> {
    fn new(kernel: &Kernel, inputs: &[R]) -> Self {
        assert_eq!(inputs.len(), kernel.inputs.len(), "wrong number of inputs for the kernel `{}`", kernel.name);
        Machine { slots: inputs.to_vec() }
    }

    /// The number that literals take their precision from.
    fn context(&self) -> &R {
        &self.slots[0]
    }

    fn step(&mut self, step: &Let) {
        let value = self.value(&step.value);
        self.slots.push(value);
    }

    fn value(&self, expr: &Expr) -> R {
        match expr {
            Expr::Literal { value, .. } => self.context().literal(*value),
            Expr::Name(name) => self.slots[name.slot].clone(),
            Expr::Pi(_) => self.context().pi(),
            Expr::Neg(inner) => self.value(inner).neg(),
            Expr::Call(function, inner) => self.value(inner).call(*function),
            Expr::Binary { op, left, right } => binary(*op, &self.value(left), &self.value(right)),
            Expr::Extreme { largest, items } => self.extreme(*largest, items),
            Expr::If { condition, then, otherwise } => self.value(if self.holds(condition) { then } else { otherwise }),
            Expr::Compensated(expression) => self.compensated(expression),
            Expr::Residual(expression) => self.residual(expression),
            Expr::PositiveRoot(coefficients) => {
                let coefficients: Vec<R> = coefficients.iter().map(|coefficient| self.value(coefficient)).collect();
                self.context().positive_root(&coefficients)
            }
        }
    }

    /// The first of the largest, or smallest, ones.
    fn extreme(&self, largest: bool, items: &[Expr]) -> R {
        let wanted = if largest { Ordering::Greater } else { Ordering::Less };
        let mut values = items.iter().map(|item| self.value(item));
        let first = values.next().expect("two values or more");
        values.fold(first, |best, next| if next.partial_cmp(&best) == Some(wanted) { next } else { best })
    }

    fn compensated(&self, expression: &CompensatedExpr) -> R {
        match Part::of(&expression.value) {
            Part::Operand(operand) => self.operand(operand),
            Part::Extended(extended) => {
                let operands: Vec<R> = expression.operands.iter().map(|operand| self.value(operand)).collect();
                let operands: Vec<&R> = operands.iter().collect();
                R::compensated(&self.extended(extended), expression.threshold, &operands, expression.terms())
            }
        }
    }

    fn residual(&self, expression: &Expr) -> R {
        match Part::of(expression) {
            Part::Operand(operand) => self.operand(operand),
            Part::Extended(extended) => R::residual(&self.extended(extended)),
        }
    }

    fn operand(&self, operand: Operand) -> R {
        let value = self.value(operand.leaf);
        if operand.negative { value.neg() } else { value }
    }

    fn extended(&self, extended: Extended) -> R::Extended {
        let operand = |operand| self.operand(operand);
        let value = match extended.operation() {
            Operation::TwoSum(a, b) => operand(a).two_sum(&operand(b)),
            Operation::TwoProduct(a, b) => operand(a).two_product(&operand(b)),
            Operation::AddExact(a, b) => R::extended_add_exact(&self.extended(a), &operand(b)),
            Operation::Add(a, b) => R::extended_add(&self.extended(a), &self.extended(b)),
            Operation::MulExact(a, b) => R::extended_mul_exact(&self.extended(a), &operand(b)),
            Operation::Mul(a, b) => R::extended_mul(&self.extended(a), &self.extended(b)),
            Operation::ScaleOperand(a, b) => operand(a).scaled(&operand(b)),
            Operation::Scale(a, b) => R::extended_scaled(&self.extended(a), &operand(b)),
        };
        if extended.negative { R::extended_neg(&value) } else { value }
    }

    /// Evaluates all of it, as the compiled kernel does: an arithmetic may note what happens in any part.
    fn holds(&self, condition: &Condition) -> bool {
        match condition {
            Condition::Compare { op, left, right } => compares(*op, self.value(left).partial_cmp(&self.value(right))),
            Condition::And(left, right) => self.holds(left) & self.holds(right),
            Condition::Or(left, right) => self.holds(left) | self.holds(right),
            Condition::Not(inner) => !self.holds(inner),
        }
    }
}

/// Whether a relation holds of two numbers in this order; of a NaN, which has none, only that it differs.
fn compares(relation: Relation, order: Option<Ordering>) -> bool {
    order.map_or(relation == Relation::NotEqual, |order| relation.holds(order))
}

fn binary<R: Real>(op: BinaryOp, left: &R, right: &R) -> R {
    match op {
        BinaryOp::Add => left.add(right),
        BinaryOp::Sub => left.sub(right),
        BinaryOp::Mul => left.mul(right),
        BinaryOp::Div => left.div(right),
    }
}
