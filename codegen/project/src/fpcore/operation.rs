//! Operations of FPCore as Maxima's; what Maxima or kernels do not know keeps its name, and is refused by it.

use std::ops::Range;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};

use super::mistake::CoreMistake;
use super::name::maxima_name;
use super::scope::Value;
use crate::construct::{binary, integer, joined, negative, squared};

/// The operation of operands.
pub(super) fn operation(name: &str, operands: Vec<Value>, span: &Range<usize>) -> Result<Value, CoreMistake> {
    let count = operands.len();
    let wrong = || {
        let what = format!("`{name}` does not take {count} operands");
        Err(CoreMistake::new(what, "see the operations of FPCore 2.0", span.clone()))
    };
    // a chain of operators is as high as it is long
    if count > 2
        && !matches!(name, "fmin" | "fmax")
        && let Some(folded) = fold(name, &operands, span)
    {
        return folded;
    }
    if name == "round" {
        let what = "`round`, which turns from the middle between two integers away from zero";
        let remedy = "write `nearbyint`, which turns to the even one, or `floor` and `ceil` on the side that is meant";
        return Err(CoreMistake::new(what, remedy, span.clone()));
    }
    let Some(fits) = arity(name) else {
        return Value::made(span, operands, |operands| called(&maxima_name(name), operands));
    };
    if fits(count) { Value::made(span, operands, |operands| known(name, operands)) } else { wrong() }
}

/// How many operands a known operation takes.
fn arity(name: &str) -> Option<fn(usize) -> bool> {
    Some(match name {
        "+" | "*" => |count| count >= 1,
        "-" | "/" => |count| count == 1 || count == 2,
        "fmin" | "fmax" | "fdim" | "fmod" | "remainder" | "hypot" | "pow" | "atan2" => |count| count == 2,
        "fabs" | "sqrt" | "cbrt" | "not" | "expm1" | "log1p" | "exp2" | "log2" | "log10" => |count| count == 1,
        "floor" | "ceil" | "trunc" | "nearbyint" | "rint" => |count| count == 1,
        "fma" => |count| count == 3,
        "and" | "or" => |count| count >= 1,
        "<" | ">" | "<=" | ">=" | "==" | "!=" => |count| count >= 1,
        _ => return None,
    })
}

/// `+` and the like of more than two operands, one after the other.
fn fold(name: &str, operands: &[Value], span: &Range<usize>) -> Option<Result<Value, CoreMistake>> {
    if !["+", "-", "*", "/", "and", "or"].contains(&name) {
        return None;
    }
    let mut operands = operands.iter().cloned();
    let first = operands.next()?;
    Some(
        operands
            .try_fold(first, |all, operand| Value::made(span, vec![all, operand], |operands| known(name, operands))),
    )
}

fn known(name: &str, operands: Vec<Expr>) -> Expr {
    if let Some(relation) = relation(name) {
        return chain(relation, &operands);
    }
    let operator = match name {
        "+" => Some(BinaryOperator::Add),
        "-" => Some(BinaryOperator::Subtract),
        "*" => Some(BinaryOperator::Multiply),
        "/" => Some(BinaryOperator::Divide),
        "pow" => Some(BinaryOperator::Power),
        "and" => Some(BinaryOperator::And),
        "or" => Some(BinaryOperator::Or),
        _ => None,
    };
    match (operator, name, operands.as_slice()) {
        (_, "-", [operand]) => negative(operand.clone()),
        // as Herbie writes the inverse
        (_, "/", [operand]) => binary(BinaryOperator::Divide, integer(1), operand.clone()),
        (Some(operator), ..) => joined(operator, operands).unwrap_or_else(always),
        (_, "not", [operand]) => {
            ExprKind::Unary { operator: UnaryOperator::Not, operand: Box::new(operand.clone()) }.into()
        }
        (_, "fabs", _) => called("abs", operands),
        (_, "ceil", _) => called("ceiling", operands),
        (_, "trunc", _) => called("truncate", operands),
        // as processors do it unless they are told otherwise: from the middle to the even one
        (_, "nearbyint" | "rint", _) => called("round", operands),
        (_, "fmin", _) => called("min", operands),
        (_, "fmax", _) => called("max", operands),
        // they differ in how the quotient becomes an integer
        (_, "fmod", [x, y]) => left_of(x, y, "truncate"),
        (_, "remainder", [x, y]) => left_of(x, y, "round"),
        (_, "fdim", [x, y]) => called("max", vec![binary(BinaryOperator::Subtract, x.clone(), y.clone()), integer(0)]),
        (_, "hypot", [x, y]) => {
            let sum = binary(BinaryOperator::Add, squared(x.clone()), squared(y.clone()));
            called("sqrt", vec![sum])
        }
        (_, "cbrt", [x]) => {
            let third = binary(BinaryOperator::Divide, integer(1), integer(3));
            binary(BinaryOperator::Power, x.clone(), third)
        }
        (_, "expm1", [x]) => binary(BinaryOperator::Subtract, called("exp", vec![x.clone()]), integer(1)),
        (_, "log1p", [x]) => called("log", vec![binary(BinaryOperator::Add, integer(1), x.clone())]),
        (_, "exp2", [x]) => binary(BinaryOperator::Power, integer(2), x.clone()),
        (_, "log2" | "log10", [x]) => {
            let base = integer(if name == "log2" { 2 } else { 10 });
            binary(BinaryOperator::Divide, called("log", vec![x.clone()]), called("log", vec![base]))
        }
        (_, "fma", [x, y, z]) => {
            let product = binary(BinaryOperator::Multiply, x.clone(), y.clone());
            binary(BinaryOperator::Add, product, z.clone())
        }
        _ => called(name, operands),
    }
}

/// What a divisor leaves of a number when it is taken away as often as this function of the quotient says.
fn left_of(number: &Expr, divisor: &Expr, function: &str) -> Expr {
    let often = called(function, vec![binary(BinaryOperator::Divide, number.clone(), divisor.clone())]);
    let taken = binary(BinaryOperator::Multiply, divisor.clone(), often);
    binary(BinaryOperator::Subtract, number.clone(), taken)
}

fn called(name: &str, arguments: Vec<Expr>) -> Expr {
    ExprKind::Call { function: Box::new(ExprKind::Symbol(name.to_owned()).into()), arguments }.into()
}

fn relation(name: &str) -> Option<Relation> {
    Some(match name {
        "<" => Relation::Less,
        "<=" => Relation::LessOrEqual,
        ">" => Relation::Greater,
        ">=" => Relation::GreaterOrEqual,
        "==" => Relation::Equal,
        "!=" => Relation::NotEqual,
        _ => return None,
    })
}

/// `a < b and b < c`; of `!=` every two operands differ.
fn chain(relation: Relation, operands: &[Expr]) -> Expr {
    let compared = |left: &Expr, right: &Expr| binary(BinaryOperator::Compare(relation), left.clone(), right.clone());
    let pairs: Vec<Expr> = match relation {
        Relation::NotEqual => {
            let after = |at: usize| operands.iter().skip(at + 1);
            operands.iter().enumerate().flat_map(|(at, one)| after(at).map(move |other| compared(one, other))).collect()
        }
        _ => operands.windows(2).map(|pair| compared(&pair[0], &pair[1])).collect(),
    };
    joined(BinaryOperator::And, pairs).unwrap_or_else(always)
}

/// What of no operands holds.
fn always() -> Expr {
    ExprKind::Symbol("true".to_owned()).into()
}
