//! Operators: signs of sums, operators exchanged, terms and factors dropped, arguments swapped.

use closedform_syntax::{BinaryOp, Expr};

use super::coefficient::literal;
use super::walk::Place;

/// What may stand for an operation.
pub fn mutations(expr: &Expr, place: Place) -> Vec<Expr> {
    match expr {
        Expr::Neg(inner) => vec![(**inner).clone()],
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
fn exchanged(op: BinaryOp, left: &Expr, right: &Expr, place: Place) -> Vec<Expr> {
    let all = [BinaryOp::Add, BinaryOp::Sub, BinaryOp::Mul, BinaryOp::Div].into_iter();
    let allowed = all.filter(|other| *other != op && (place != Place::Slice || *other != BinaryOp::Div));
    allowed.map(|other| binary(other, left, right)).collect()
}

/// Other signs and another order.
fn turned(op: BinaryOp, left: &Expr, right: &Expr) -> Vec<Expr> {
    match op {
        BinaryOp::Add => vec![binary(op, &negated(left), right)],
        BinaryOp::Sub => vec![binary(op, &negated(left), right), binary(op, right, left)],
        BinaryOp::Div => vec![binary(op, right, left)],
        BinaryOp::Mul => Vec::new(),
    }
}

/// One operand alone, as the rest of its sum or product.
fn dropped(op: BinaryOp, left: &Expr, right: &Expr) -> Vec<Expr> {
    let rest = match op {
        BinaryOp::Add | BinaryOp::Mul => right.clone(),
        BinaryOp::Sub => negated(right),
        BinaryOp::Div => binary(op, &literal(1.0, right), right),
    };
    vec![left.clone(), rest]
}
