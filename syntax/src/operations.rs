//! What a kernel costs, counted without running it.

use std::collections::BTreeSet;

use closedform_arith::Operations;

use crate::kernel::{BinaryOp, Expr, Kernel};

/// Counts the operations of steps and results; both branches of an `if` count, `require!` does not.
pub fn operations(kernel: &Kernel) -> Operations {
    let mut count = Counter::default();
    let steps = kernel.lets.iter().map(|step| &step.value);
    steps.chain(kernel.output.values()).for_each(|value| count.expression(value));
    count.0
}

/// Counts the operations of one result, by position, and of the steps that it needs.
pub fn operations_of(kernel: &Kernel, result: usize) -> Operations {
    let mut count = Counter::default();
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
    count.0
}

/// Counts operations.
#[derive(Default)]
struct Counter(Operations);

impl Counter {
    fn expression(&mut self, expr: &Expr) {
        match expr {
            Expr::Compensated(expression) => return self.compensated_expression(&expression.value),
            Expr::Residual(expression) => return self.compensated_expression(expression),
            Expr::Binary { op, .. } => *self.operator(*op) += 1,
            Expr::Call(function, _) => self.0.count(*function),
            Expr::PositiveRoot(_) => self.0.root += 1,
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) | Expr::Neg(_) => {}
            Expr::Extreme { .. } | Expr::If { .. } => {}
        }
        expr.children().into_iter().for_each(|child| self.expression(child));
    }

    fn compensated_expression(&mut self, value: &Expr) {
        self.0.compensated_expressions += 1;
        self.0.compensated += operations_inside(value);
    }

    fn operator(&mut self, op: BinaryOp) -> &mut u32 {
        match op {
            BinaryOp::Add | BinaryOp::Sub => &mut self.0.add,
            BinaryOp::Mul => &mut self.0.mul,
            BinaryOp::Div => &mut self.0.div,
        }
    }
}

/// The operations on pairs of a compensated expression.
fn operations_inside(expression: &Expr) -> u32 {
    let mut count = 0;
    expression.visit(&mut |part| count += u32::from(matches!(part, Expr::Binary { .. })));
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
        let expression = Operations { compensated: 2, compensated_expressions: 1, ..Operations::default() };
        assert_eq!(operations_of(&kernel, 0), Operations { mul: 1, div: 1, sqrt: 1, ..expression });
        assert_eq!(operations_of(&kernel, 1), Operations { add: 2, ..expression });
        assert_eq!(operations(&kernel), Operations { add: 2, mul: 1, div: 1, sqrt: 1, ..expression });
    }
}
