//! What a kernel costs, counted without running it.

use std::collections::BTreeSet;

use crate::kernel::{BinaryOp, Expr, Kernel};

/// How many operations one evaluation takes; signs, magnitudes, comparisons and choices are free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub add: u32,
    /// Multiplications.
    pub mul: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots.
    pub sqrt: u32,
    /// Additions and multiplications in double-double, inside `compensated!` and `residual!`.
    pub compensated: u32,
    /// Slices, each rounded once at its end.
    pub slices: u32,
    /// Roots of polynomials, found by iteration.
    pub root: u32,
}

/// Counts the operations of steps and results; both branches of an `if` count, `require!` does not.
pub fn operations(kernel: &Kernel) -> Operations {
    let mut count = Operations::default();
    let steps = kernel.lets.iter().map(|step| &step.value);
    steps.chain(kernel.output.values()).for_each(|value| count.expression(value));
    count
}

/// Counts the operations of one result, by position, and of the steps that it needs.
pub fn operations_of(kernel: &Kernel, result: usize) -> Operations {
    let mut count = Operations::default();
    let mut needed = BTreeSet::new();
    let mut take = |value: &Expr, needed: &mut BTreeSet<usize>| {
        count.expression(value);
        value.visit(&mut |inner| {
            if let Expr::Name(name) = inner {
                needed.insert(name.slot);
            }
        });
    };
    kernel.output.values().nth(result).into_iter().for_each(|value| take(value, &mut needed));
    for (position, step) in kernel.lets.iter().enumerate().rev() {
        if needed.contains(&(kernel.inputs.len() + position)) {
            take(&step.value, &mut needed);
        }
    }
    count
}

impl Operations {
    fn expression(&mut self, expr: &Expr) {
        match expr {
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) => {}
            Expr::Neg(inner) | Expr::Abs(inner) => self.expression(inner),
            Expr::Sqrt(inner) => {
                self.sqrt += 1;
                self.expression(inner);
            }
            Expr::Binary { op, left, right } => {
                *self.operator(*op) += 1;
                self.expression(left);
                self.expression(right);
            }
            Expr::Extreme { items, .. } => items.iter().for_each(|item| self.expression(item)),
            Expr::If { condition, then, otherwise } => {
                condition.sides().into_iter().for_each(|side| self.expression(side));
                self.expression(then);
                self.expression(otherwise);
            }
            Expr::Compensated(slice) => self.slice(&slice.value),
            Expr::Residual(slice) => self.slice(slice),
            Expr::PositiveRoot(coefficients) => {
                self.root += 1;
                coefficients.iter().for_each(|coefficient| self.expression(coefficient));
            }
        }
    }

    fn slice(&mut self, value: &Expr) {
        self.slices += 1;
        self.compensated += slice_operations(value);
    }

    fn operator(&mut self, op: BinaryOp) -> &mut u32 {
        match op {
            BinaryOp::Add | BinaryOp::Sub => &mut self.add,
            BinaryOp::Mul => &mut self.mul,
            BinaryOp::Div => &mut self.div,
        }
    }
}

/// The double-double operations of a slice.
fn slice_operations(slice: &Expr) -> u32 {
    let mut count = 0;
    slice.visit(&mut |part| count += u32::from(matches!(part, Expr::Binary { .. })));
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_takes_its_own_steps_only() {
        let source = "pub struct S { pub p: f64, pub q: f64 }
            #[kernel]
            pub fn f(x: f64, y: f64) -> S {
                let shared = compensated!(x * y - 1.0);
                let own = sqrt(x) / shared;
                let other = x + y + 1.0;
                S { p: own * own, q: if other > 0.0 { shared } else { -shared } }
            }";
        let kernel = crate::parse_file(source).unwrap().remove(0);
        let slice = Operations { compensated: 2, slices: 1, ..Operations::default() };
        assert_eq!(operations_of(&kernel, 0), Operations { mul: 1, div: 1, sqrt: 1, ..slice });
        assert_eq!(operations_of(&kernel, 1), Operations { add: 2, ..slice });
        assert_eq!(operations(&kernel), Operations { add: 2, mul: 1, div: 1, sqrt: 1, ..slice });
    }
}
