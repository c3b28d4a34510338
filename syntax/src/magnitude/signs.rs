//! The signs that conditions tell: of inputs, of sums of two inputs, of whole `compensated!` expressions.

use std::collections::BTreeMap;

use closedform_arith::{Relation, Signs as InputSigns};
use proc_macro2::Ident;

use crate::kernel::{BinaryOp, Condition, Expr};
use crate::print::expression_text;

use super::bounds::{Bounds, Sign};

/// What conditions tell, by the text of expressions.
///
/// All of these are evaluated without an error of sign wherever they stand: in `f64`, in double-double, inside
/// compensated expressions.
#[derive(Default)]
pub(super) struct Signs {
    known: BTreeMap<String, Known>,
    /// Whether it heeds inputs and their differences alone: these have no error of sign in any arithmetic.
    inputs_alone: bool,
}

/// A sign, and whether the number may be zero.
#[derive(Clone, Copy)]
struct Known {
    sign: Sign,
    zero: bool,
}

impl Signs {
    /// One that heeds inputs and their differences alone.
    pub(super) fn of_inputs() -> Self {
        Signs { inputs_alone: true, ..Signs::default() }
    }

    /// The signs that an input may have.
    pub(super) fn of_input(&self, name: &Ident) -> InputSigns {
        let of = |known: &Known| match known.sign {
            Sign::Positive => InputSigns { zero: known.zero, ..InputSigns::POSITIVE },
            Sign::Negative => InputSigns { zero: known.zero, ..InputSigns::NEGATIVE },
            Sign::Open => InputSigns::ANY,
        };
        self.known.get(&name.to_string()).map_or(InputSigns::ANY, of)
    }

    /// The bounds of an expression, with its sign if that is known.
    pub(super) fn refine(&self, expr: &Expr, bounds: Bounds) -> Bounds {
        let known =
            if self.known.is_empty() || !is_exact(expr) { None } else { self.known.get(&expression_text(expr)) };
        known.map_or(bounds, |known| Bounds { sign: known.sign, zero: known.zero && bounds.zero, ..bounds })
    }

    /// Takes a condition in that holds.
    pub(super) fn learn(&mut self, condition: &Condition) {
        match condition {
            Condition::And(left, right) => [left, right].into_iter().for_each(|side| self.learn(side)),
            Condition::Compare { op, left, right } if self.heeds(left) && self.heeds(right) => match op {
                Relation::Greater => self.above(left, right, false),
                Relation::GreaterOrEqual => self.above(left, right, true),
                Relation::Less => self.above(right, left, false),
                Relation::LessOrEqual => self.above(right, left, true),
                Relation::Equal | Relation::NotEqual => {}
            },
            Condition::Compare { .. } | Condition::Or(..) | Condition::Not(_) => {}
        }
    }

    fn heeds(&self, side: &Expr) -> bool {
        if self.inputs_alone { is_leaf(side) } else { is_exact(side) }
    }

    /// `high` is larger than `low`, or perhaps `equal` to it.
    fn above(&mut self, high: &Expr, low: &Expr, equal: bool) {
        let (known_high, known_low) = (self.known(high), self.known(low));
        if let Some(known) = known_low.filter(|known| known.sign == Sign::Positive) {
            self.enter(high, Sign::Positive, known.zero && equal);
        }
        if let Some(known) = known_high.filter(|known| known.sign == Sign::Negative || is_zero(high)) {
            self.enter(low, Sign::Negative, known.zero && equal);
        }
        let difference = |left: &Expr, right: &Expr| {
            let (left, right) = (Box::new(left.clone()), Box::new(right.clone()));
            Expr::Binary { op: BinaryOp::Sub, left, right }
        };
        self.enter(&difference(high, low), Sign::Positive, equal);
        self.enter(&difference(low, high), Sign::Negative, equal);
    }

    fn enter(&mut self, expr: &Expr, sign: Sign, zero: bool) {
        let before = self.known.entry(expression_text(expr)).or_insert(Known { sign, zero });
        *before = Known { sign, zero: zero && before.zero };
    }

    /// What is known of an expression.
    fn known(&self, expr: &Expr) -> Option<Known> {
        match expr {
            Expr::Literal { value, .. } => {
                let Bounds { sign, zero, .. } = Bounds::literal(*value);
                Some(Known { sign, zero })
            }
            _ => self.known.get(&expression_text(expr)).copied(),
        }
    }
}

fn is_zero(expr: &Expr) -> bool {
    matches!(expr, Expr::Literal { value, .. } if *value == 0.0)
}

/// A name or number, a sum of two of them, or a `compensated!` expression.
fn is_exact(expr: &Expr) -> bool {
    match expr {
        Expr::Binary { op: BinaryOp::Add | BinaryOp::Sub, left, right } => is_leaf(left) && is_leaf(right),
        Expr::Compensated(_) => true,
        other => is_leaf(other),
    }
}

fn is_leaf(expr: &Expr) -> bool {
    matches!(expr, Expr::Name(_) | Expr::Literal { .. })
}
