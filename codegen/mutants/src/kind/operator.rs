//! Operators: signs of sums, operators exchanged, terms and factors dropped, arguments swapped.

use closedform_syntax::{BinaryOp, Expr};

use super::coefficient::literal;
use super::walk::Place;
use crate::mistake::Wrong;

/// What may stand for an operation.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Wrong<Expr>> {
    match expr {
        Expr::Neg(inner) => vec![Wrong::new("minus dropped", (**inner).clone())],
        Expr::Binary { op, left, right } => {
            let mut found = exchanged(*op, left, right, place);
            found.extend(turned(*op, left, right));
            found.extend(dropped(*op, left, right));
            found
        }
        _ => Vec::new(),
    }
}

/// The expression with the other sign.
pub fn negated(expr: &Expr) -> Expr {
    match expr {
        Expr::Neg(inner) => (**inner).clone(),
        _ => Expr::Neg(expr.clone().into()),
    }
}

fn binary(op: BinaryOp, left: &Expr, right: &Expr) -> Expr {
    Expr::Binary { op, left: left.clone().into(), right: right.clone().into() }
}

/// Every other operator.
fn exchanged(op: BinaryOp, left: &Expr, right: &Expr, place: Place) -> Vec<Wrong<Expr>> {
    let all = [BinaryOp::Add, BinaryOp::Sub, BinaryOp::Mul, BinaryOp::Div].into_iter();
    let allowed = all.filter(|other| *other != op && (place != Place::Compensated || *other != BinaryOp::Div));
    let wrong = |other| Wrong::new(format!("{} as {}", written(op), written(other)), binary(other, left, right));
    allowed.map(wrong).collect()
}

fn written(op: BinaryOp) -> char {
    match op {
        BinaryOp::Add => '+',
        BinaryOp::Sub => '-',
        BinaryOp::Mul => '*',
        BinaryOp::Div => '/',
    }
}

/// Other signs and another order.
fn turned(op: BinaryOp, left: &Expr, right: &Expr) -> Vec<Wrong<Expr>> {
    let sign = || Wrong::new("first operand negated", binary(op, &negated(left), right));
    let order = || Wrong::new("operands swapped", binary(op, right, left));
    match op {
        BinaryOp::Add => vec![sign()],
        BinaryOp::Sub => vec![sign(), order()],
        BinaryOp::Div => vec![order()],
        BinaryOp::Mul => Vec::new(),
    }
}

/// One operand alone, as the rest of its sum or product.
fn dropped(op: BinaryOp, left: &Expr, right: &Expr) -> Vec<Wrong<Expr>> {
    let rest = match op {
        BinaryOp::Add | BinaryOp::Mul => right.clone(),
        BinaryOp::Sub => negated(right),
        BinaryOp::Div => binary(op, &literal(1.0, right), right),
    };
    vec![Wrong::new("first operand alone", left.clone()), Wrong::new("second operand alone", rest)]
}
