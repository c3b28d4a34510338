//! The interpreter: what a kernel computes, without compiling it.

use std::cmp::Ordering;

use crate::kernel::{BinaryOp, Condition, Expr, Kernel, Let};
use crate::slice::{SliceArithmetic, fold_compensated, fold_residual};

/// The arithmetic that the interpreter runs in.
///
/// It has the operations of the trait `closedform::Real`, whose crate this one cannot name, since that one depends on
/// the macro and the macro on this one. [`real_arithmetic!`](crate::real_arithmetic) connects the two.
pub trait Arithmetic: SliceArithmetic<Value: Clone> {
    /// The number `value`.
    fn literal(&self, value: f64) -> Self::Value;
    /// The circle constant.
    fn pi(&self) -> Self::Value;
    /// `a + b`
    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// `a - b`
    fn sub(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// `a * b`
    fn mul(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// `a / b`
    fn div(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// The square root.
    fn sqrt(&self, a: &Self::Value) -> Self::Value;
    /// The magnitude.
    fn abs(&self, a: &Self::Value) -> Self::Value;
    /// The order of two numbers; `None` when one of them is NaN.
    fn compare(&self, a: &Self::Value, b: &Self::Value) -> Option<Ordering>;
    /// Neither infinite nor NaN.
    fn is_finite(&self, a: &Self::Value) -> bool;
    /// The one positive root of c0 + c1 x + .. + cn x^n.
    fn positive_root(&self, coefficients: &[Self::Value]) -> Self::Value;
}

/// Why inputs lie outside the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Violation {
    /// An input, by position, is infinite or NaN.
    NotFinite(usize),
    /// A `require!`, by position, does not hold.
    Require(usize),
}

/// The results of `kernel`, in order, whether or not the inputs lie in its domain.
///
/// # Panics
///
/// When there are not as many inputs as the kernel has.
pub fn evaluate<A: Arithmetic>(kernel: &Kernel, arithmetic: &A, inputs: &[A::Value]) -> Vec<A::Value> {
    let mut machine = Machine::new(kernel, arithmetic, inputs);
    kernel.lets.iter().for_each(|step| machine.step(step));
    kernel.output.values().map(|value| machine.value(value)).collect()
}

/// The first condition of the domain of `kernel` that the inputs violate.
///
/// # Panics
///
/// When there are not as many inputs as the kernel has.
pub fn violated<A: Arithmetic>(kernel: &Kernel, arithmetic: &A, inputs: &[A::Value]) -> Option<Violation> {
    let machine = Machine::new(kernel, arithmetic, inputs);
    if let Some(input) = inputs.iter().position(|input| !arithmetic.is_finite(input)) {
        return Some(Violation::NotFinite(input));
    }
    let all: Vec<bool> = kernel.requires.iter().map(|require| machine.holds(&require.condition)).collect();
    all.iter().position(|holds| !holds).map(Violation::Require)
}

struct Machine<'a, A: Arithmetic> {
    arithmetic: &'a A,
    /// Inputs followed by the steps taken so far.
    slots: Vec<A::Value>,
}

impl<'a, A: Arithmetic> Machine<'a, A> {
    fn new(kernel: &Kernel, arithmetic: &'a A, inputs: &[A::Value]) -> Self {
        assert_eq!(inputs.len(), kernel.inputs.len(), "wrong number of inputs for the kernel `{}`", kernel.name);
        Machine { arithmetic, slots: inputs.to_vec() }
    }

    fn step(&mut self, step: &Let) {
        let value = self.value(&step.value);
        self.slots.push(value);
    }

    fn value(&self, expr: &Expr) -> A::Value {
        match expr {
            Expr::Literal { value, .. } => self.arithmetic.literal(*value),
            Expr::Name(name) => self.slots[name.slot].clone(),
            Expr::Pi(_) => self.arithmetic.pi(),
            Expr::Neg(inner) => self.arithmetic.neg(&self.value(inner)),
            Expr::Sqrt(inner) => self.arithmetic.sqrt(&self.value(inner)),
            Expr::Abs(inner) => self.arithmetic.abs(&self.value(inner)),
            Expr::Binary { op, left, right } => self.binary(*op, &self.value(left), &self.value(right)),
            Expr::Extreme { largest, items } => self.extreme(*largest, items),
            Expr::If { condition, then, otherwise } => self.value(if self.holds(condition) { then } else { otherwise }),
            Expr::Compensated(slice) => fold_compensated(self.arithmetic, slice, &|leaf| self.value(leaf)),
            Expr::Residual(slice) => fold_residual(self.arithmetic, slice, &|leaf| self.value(leaf)),
            Expr::PositiveRoot(coefficients) => {
                let coefficients: Vec<_> = coefficients.iter().map(|coefficient| self.value(coefficient)).collect();
                self.arithmetic.positive_root(&coefficients)
            }
        }
    }

    /// The first of the largest, or smallest, ones.
    fn extreme(&self, largest: bool, items: &[Expr]) -> A::Value {
        let wanted = if largest { Ordering::Greater } else { Ordering::Less };
        let mut values = items.iter().map(|item| self.value(item));
        let first = values.next().expect("two values or more");
        values.fold(first, |best, next| if self.arithmetic.compare(&next, &best) == Some(wanted) { next } else { best })
    }

    fn binary(&self, op: BinaryOp, left: &A::Value, right: &A::Value) -> A::Value {
        match op {
            BinaryOp::Add => self.arithmetic.add(left, right),
            BinaryOp::Sub => self.arithmetic.sub(left, right),
            BinaryOp::Mul => self.arithmetic.mul(left, right),
            BinaryOp::Div => self.arithmetic.div(left, right),
        }
    }

    /// Evaluates all of it, as the compiled kernel does: an arithmetic may note what happens in any part.
    fn holds(&self, condition: &Condition) -> bool {
        match condition {
            Condition::Compare { op, left, right } => {
                op.holds(self.arithmetic.compare(&self.value(left), &self.value(right)))
            }
            Condition::And(left, right) => self.holds(left) & self.holds(right),
            Condition::Or(left, right) => self.holds(left) | self.holds(right),
            Condition::Not(inner) => !self.holds(inner),
        }
    }
}

/// Declares `$name<R>(pub R)`, the interpreter's arithmetic that forwards to `R: closedform::Real`; the number inside
/// sets the precision of literals. For crates that depend on both `closedform` and `closedform-syntax`.
#[macro_export]
macro_rules! real_arithmetic {
    ($(#[$attribute:meta])* $visibility:vis struct $name:ident;) => {
        $(#[$attribute])*
        $visibility struct $name<R>(pub R);

        impl<R: ::closedform::Real> $crate::SliceArithmetic for $name<R> {
            type Value = R;
            type Wide = R::Wide;

            fn neg(&self, a: &R) -> R {
                a.neg()
            }

            fn two_sum(&self, a: &R, b: &R) -> R::Wide {
                a.two_sum(b)
            }

            fn two_product(&self, a: &R, b: &R) -> R::Wide {
                a.two_product(b)
            }

            fn wide_neg(&self, a: &R::Wide) -> R::Wide {
                R::wide_neg(a)
            }

            fn wide_add_exact(&self, a: &R::Wide, b: &R) -> R::Wide {
                R::wide_add_exact(a, b)
            }

            fn wide_add(&self, a: &R::Wide, b: &R::Wide) -> R::Wide {
                R::wide_add(a, b)
            }

            fn wide_mul_exact(&self, a: &R::Wide, b: &R) -> R::Wide {
                R::wide_mul_exact(a, b)
            }

            fn wide_mul(&self, a: &R::Wide, b: &R::Wide) -> R::Wide {
                R::wide_mul(a, b)
            }

            fn compensated(&self, a: &R::Wide, slice: &$crate::Slice, operands: &[R]) -> R {
                let operands: ::std::vec::Vec<&R> = operands.iter().collect();
                R::compensated(a, slice.threshold, &operands, &slice.terms)
            }

            fn residual(&self, a: &R::Wide) -> R {
                R::residual(a)
            }
        }

        impl<R: ::closedform::Real> $crate::Arithmetic for $name<R> {
            fn literal(&self, value: f64) -> R {
                self.0.literal(value)
            }

            fn pi(&self) -> R {
                self.0.pi()
            }

            fn add(&self, a: &R, b: &R) -> R {
                a.add(b)
            }

            fn sub(&self, a: &R, b: &R) -> R {
                a.sub(b)
            }

            fn mul(&self, a: &R, b: &R) -> R {
                a.mul(b)
            }

            fn div(&self, a: &R, b: &R) -> R {
                a.div(b)
            }

            fn sqrt(&self, a: &R) -> R {
                a.sqrt()
            }

            fn abs(&self, a: &R) -> R {
                a.abs()
            }

            fn compare(&self, a: &R, b: &R) -> Option<::core::cmp::Ordering> {
                a.partial_cmp(b)
            }

            fn is_finite(&self, a: &R) -> bool {
                a.is_finite()
            }

            fn positive_root(&self, coefficients: &[R]) -> R {
                self.0.positive_root(coefficients)
            }
        }
    };
}
