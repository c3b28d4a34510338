//! The walk over a kernel's trees: what stands inside what, said once for every question asked of all of it.

use crate::kernel::{Condition, Expr, Kernel};

impl Expr {
    /// The expressions directly inside, in order; of an `if` those that its condition compares come first, and of a slice
    /// it is what is written in it.
    pub fn children(&self) -> Vec<&Expr> {
        match self {
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) => Vec::new(),
            Expr::Neg(inner) | Expr::Sqrt(inner) | Expr::Abs(inner) | Expr::Residual(inner) => vec![inner],
            Expr::Compensated(slice) => vec![&slice.value],
            Expr::Binary { left, right, .. } => vec![left, right],
            Expr::If { condition, then, otherwise } => {
                condition.sides().into_iter().chain([&**then, &**otherwise]).collect()
            }
            Expr::Extreme { items, .. } | Expr::PositiveRoot(items) => items.iter().collect(),
        }
    }

    /// Calls `see` with the expression and then with all inside it.
    pub fn visit<'e>(&'e self, see: &mut dyn FnMut(&'e Expr)) {
        see(self);
        self.children().into_iter().for_each(|child| child.visit(see));
    }

    /// Whether the expression, or one inside it, is such a one.
    pub fn any(&self, is_such: &mut dyn FnMut(&Expr) -> bool) -> bool {
        is_such(self) || self.children().into_iter().any(|child| child.any(is_such))
    }
}

impl Condition {
    /// The conditions directly inside.
    pub fn children(&self) -> Vec<&Condition> {
        match self {
            Condition::Compare { .. } => Vec::new(),
            Condition::And(left, right) | Condition::Or(left, right) => vec![left, right],
            Condition::Not(inner) => vec![inner],
        }
    }

    /// Every comparison in it, in order.
    pub fn comparisons(&self) -> Vec<&Condition> {
        match self {
            Condition::Compare { .. } => vec![self],
            _ => self.children().into_iter().flat_map(Condition::comparisons).collect(),
        }
    }

    /// Both sides of every comparison in it, in order.
    pub fn sides(&self) -> Vec<&Expr> {
        match self {
            Condition::Compare { left, right, .. } => vec![left, right],
            _ => self.children().into_iter().flat_map(Condition::sides).collect(),
        }
    }

    /// Calls `see` with every expression in it.
    pub fn visit<'e>(&'e self, see: &mut dyn FnMut(&'e Expr)) {
        self.sides().into_iter().for_each(|side| side.visit(see));
    }
}

impl Kernel {
    /// Calls `see` with every expression of the kernel: those of conditions, steps and results.
    pub fn visit<'k>(&'k self, see: &mut dyn FnMut(&'k Expr)) {
        self.requires.iter().for_each(|require| require.condition.visit(see));
        self.lets.iter().map(|step| &step.value).chain(self.output.values()).for_each(|value| value.visit(see));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A kernel in which every kind of expression holds a number of its own, wherever one can stand.
    const EVERYWHERE: &str = "#[kernel]
        pub fn f(x: f64) -> f64 {
            require!(!(x > 1.0 && abs(2.0) > 3.0) || 4.0 >= x);
            let a = -sqrt(5.0) / (PI - max(6.0, min(7.0, 8.0)));
            let b = compensated!(9.0 * x - -10.0) + positive_root([-11.0, if !(x < 12.0) { 13.0 } else { 14.0 }]);
            a + residual!(15.0 * b)
        }";

    #[test]
    fn nothing_is_left_out() {
        let kernel = crate::parse_file(EVERYWHERE).unwrap().remove(0);
        let mut numbers = Vec::new();
        kernel.visit(&mut |expr| {
            if let Expr::Literal { value, .. } = expr {
                numbers.push(*value);
            }
        });
        assert_eq!(numbers, (1..=15).map(f64::from).collect::<Vec<_>>());
    }
}
