//! What a kernel costs, counted without running it.

use crate::kernel::{BinaryOp, Condition, Expr, Kernel};

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
                self.condition(condition);
                self.expression(then);
                self.expression(otherwise);
            }
            Expr::Compensated(slice) => self.compensated += slice_operations(&slice.value),
            Expr::Residual(slice) => self.compensated += slice_operations(slice),
            Expr::PositiveRoot(coefficients) => {
                self.root += 1;
                coefficients.iter().for_each(|coefficient| self.expression(coefficient));
            }
        }
    }

    fn operator(&mut self, op: BinaryOp) -> &mut u32 {
        match op {
            BinaryOp::Add | BinaryOp::Sub => &mut self.add,
            BinaryOp::Mul => &mut self.mul,
            BinaryOp::Div => &mut self.div,
        }
    }

    fn condition(&mut self, condition: &Condition) {
        match condition {
            Condition::Compare { left, right, .. } => {
                self.expression(left);
                self.expression(right);
            }
            Condition::And(left, right) | Condition::Or(left, right) => {
                self.condition(left);
                self.condition(right);
            }
            Condition::Not(inner) => self.condition(inner),
        }
    }
}

/// The double-double operations of a slice.
fn slice_operations(slice: &Expr) -> u32 {
    match slice {
        Expr::Binary { left, right, .. } => 1 + slice_operations(left) + slice_operations(right),
        Expr::Neg(inner) => slice_operations(inner),
        _ => 0,
    }
}
