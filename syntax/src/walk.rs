//! The walk over a kernel's trees: what stands inside what, said once for every question asked of all of it.

use crate::kernel::{CompensatedExpr, Condition, Expr, Kernel};

impl Expr {
    /// The expressions directly inside, in order; of an `if` those that its condition compares come first, and of a
    /// compensated expression it is what is written in it.
    pub fn children(&self) -> Vec<&Expr> {
        match self {
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) => Vec::new(),
            Expr::Neg(inner) | Expr::Call(_, inner) | Expr::Residual(inner) => vec![inner],
            Expr::Compensated(expression) => vec![&expression.value],
            Expr::Binary { left, right, .. } => vec![left, right],
            Expr::If { condition, then, otherwise } => {
                condition.sides().into_iter().chain([&**then, &**otherwise]).collect()
            }
            Expr::Extreme { items, .. } | Expr::PositiveRoot(items) => items.iter().collect(),
        }
    }

    /// The same expression of other [children](Self::children), as many as it has; `None` where a compensated expression
    /// of them is too large.
    pub fn with_children(&self, children: Vec<Expr>) -> Option<Expr> {
        let mut children = children.into_iter();
        let mut next = || children.next().map(Box::new);
        Some(match self {
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) => self.clone(),
            Expr::Neg(_) => Expr::Neg(next()?),
            Expr::Call(function, _) => Expr::Call(*function, next()?),
            Expr::Residual(_) => Expr::Residual(next()?),
            Expr::Compensated(_) => Expr::Compensated(CompensatedExpr::new(*next()?).ok()?),
            Expr::Binary { op, .. } => Expr::Binary { op: *op, left: next()?, right: next()? },
            Expr::If { condition, .. } => {
                let condition = condition.with_sides(&mut || next().map(|side| *side))?.into();
                Expr::If { condition, then: next()?, otherwise: next()? }
            }
            Expr::Extreme { largest, .. } => Expr::Extreme { largest: *largest, items: children.collect() },
            Expr::PositiveRoot(_) => Expr::PositiveRoot(children.collect()),
        })
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

    /// The same condition of other sides, in order.
    pub(crate) fn with_sides(&self, next: &mut dyn FnMut() -> Option<Expr>) -> Option<Condition> {
        let mut boxed = |inner: &Condition| inner.with_sides(next).map(Box::new);
        Some(match self {
            Condition::And(left, right) => Condition::And(boxed(left)?, boxed(right)?),
            Condition::Or(left, right) => Condition::Or(boxed(left)?, boxed(right)?),
            Condition::Not(inner) => Condition::Not(boxed(inner)?),
            Condition::Compare { op, .. } => Condition::Compare { op: *op, left: next()?, right: next()? },
        })
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
    use crate::print::expression_text;

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

    /// The expression with this added to every number.
    fn raised(expr: &Expr, by: f64) -> Expr {
        match expr {
            Expr::Literal { value, span } => Expr::Literal { value: value + by, span: *span },
            _ => expr.with_children(expr.children().into_iter().map(|child| raised(child, by)).collect()).unwrap(),
        }
    }

    #[test]
    fn other_children_stand_where_theirs_stood() {
        let kernel = crate::parse_file(EVERYWHERE).unwrap().remove(0);
        for value in kernel.lets.iter().map(|step| &step.value).chain(kernel.output.values()) {
            let text = expression_text(value);
            let other = raised(value, 100.0);
            assert_ne!(expression_text(&other), text);
            assert_eq!(expression_text(&raised(&other, -100.0)), text);
        }
    }
}
