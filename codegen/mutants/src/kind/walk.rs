//! The walk over a tree: each expression or condition in it replaced, all others as they were.

use closedform_syntax::{Condition, Expr, Slice};

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
    Slice,
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
        let wrapped = |inner: &Expr, place: Place, wrap: fn(Box<Expr>) -> Expr| -> Vec<Wrong<Expr>> {
            { self.expression(inner, place).into_iter() }.map(|wrong| wrong.map(|inner| wrap(inner.into()))).collect()
        };
        match expr {
            Expr::Literal { .. } | Expr::Name(_) | Expr::Pi(_) => Vec::new(),
            Expr::Neg(inner) => wrapped(inner, place, Expr::Neg),
            Expr::Sqrt(inner) => wrapped(inner, place, Expr::Sqrt),
            Expr::Abs(inner) => wrapped(inner, place, Expr::Abs),
            Expr::Residual(inner) => wrapped(inner, Place::Slice, Expr::Residual),
            Expr::Compensated(slice) => {
                let values = self.expression(&slice.value, Place::Slice).into_iter();
                let slice = |value| Slice::new(value).ok().map(Expr::Compensated);
                values.filter_map(|wrong| wrong.filter_map(slice)).collect()
            }
            Expr::Binary { op, left, right } => {
                let lefts = self.expression(left, place).into_iter();
                let of_left = |left: Expr| Expr::Binary { op: *op, left: left.into(), right: right.clone() };
                let rights = self.expression(right, place).into_iter();
                let of_right = |right: Expr| Expr::Binary { op: *op, left: left.clone(), right: right.into() };
                lefts.map(|wrong| wrong.map(of_left)).chain(rights.map(|wrong| wrong.map(of_right))).collect()
            }
            Expr::If { condition, then, otherwise } => self.choice(condition, then, otherwise),
            Expr::Extreme { largest, items } => {
                let extreme = |items| Expr::Extreme { largest: *largest, items };
                self.one_of(items).into_iter().map(|wrong| wrong.map(extreme)).collect()
            }
            Expr::PositiveRoot(coefficients) => {
                self.one_of(coefficients).into_iter().map(|wrong| wrong.map(Expr::PositiveRoot)).collect()
            }
        }
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

    /// The list with one mutation, in one of its expressions.
    fn one_of(&self, list: &[Expr]) -> Vec<Wrong<Vec<Expr>>> {
        let replaced = |at: usize, value: Expr| {
            let mut list = list.to_vec();
            list[at] = value;
            list
        };
        let each = list.iter().enumerate();
        each.flat_map(|(at, expr)| {
            let values = self.expression(expr, Place::Plain).into_iter();
            values.map(move |wrong| wrong.map(|value| replaced(at, value)))
        })
        .collect()
    }
}
