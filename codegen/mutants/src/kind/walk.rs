//! The walk over a tree: each expression or condition in it replaced, all others as they were.

use closedform_syntax::{Condition, Expr};

use super::{branch, condition};
use crate::mistake::Wrong;

/// What kind of expression stands at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Any.
    Plain,
    /// A side of a comparison.
    Side,
    /// Inside `compensated!` or `residual!`: sums and products of names and numbers.
    Compensated,
}

/// The mutations that a walk makes.
pub struct Walk<'a> {
    /// What may stand for an expression.
    pub expression: &'a dyn Fn(&Expr, Place) -> Vec<Wrong<Expr>>,
}

impl Walk<'_> {
    /// The expression with one mutation, somewhere.
    pub fn expression(&self, expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
        let mut found = (self.expression)(expr, place);
        found.extend(self.inside(expr, place));
        found
    }

    fn inside(&self, expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
        let place = match expr {
            Expr::If { condition, then, otherwise } => return self.choice(condition, then, otherwise),
            Expr::Residual(_) | Expr::Compensated(_) => Place::Compensated,
            Expr::Extreme { .. } | Expr::PositiveRoot(_) => Place::Plain,
            _ => place,
        };
        let children = expr.children();
        let with = |at: usize, child: Expr| {
            let mut all: Vec<Expr> = children.iter().copied().cloned().collect();
            all[at] = child;
            expr.with_children(all)
        };
        let each = children.iter().enumerate();
        each.flat_map(|(at, child)| {
            let values = self.expression(child, place).into_iter();
            values.filter_map(move |wrong| wrong.filter_map(|value| with(at, value))).collect::<Vec<_>>()
        })
        .collect()
    }

    fn choice(&self, condition: &Condition, then: &Expr, otherwise: &Expr) -> Vec<Wrong<Expr>> {
        let conditions = condition::mutations(condition, self).into_iter();
        let conditions =
            conditions.map(|wrong| wrong.map(|condition| branch::choice(condition, then.clone(), otherwise.clone())));
        let thens = self.expression(then, Place::Plain).into_iter();
        let thens = thens.map(|wrong| wrong.map(|then| branch::choice(condition.clone(), then, otherwise.clone())));
        let others = self.expression(otherwise, Place::Plain).into_iter();
        let others =
            others.map(|wrong| wrong.map(|otherwise| branch::choice(condition.clone(), then.clone(), otherwise)));
        conditions.chain(thens).chain(others).collect()
    }
}
