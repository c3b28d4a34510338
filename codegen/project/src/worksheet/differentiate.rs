//! `diff` of formulas, by the rules of the schoolbook; what the rules do not know is left to Maxima.

use std::collections::BTreeSet;
use std::ops::Range;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator};

use super::arrays::each;
use super::numbers::exact;
use super::state::Refusal;
use super::tree::{any, binary, call, names, number, small};
use super::words::COMPUTE;
use num_traits::{One, Zero};

/// The most times that something is differentiated.
const MOST: i64 = 16;

/// The derivative of a value by a name, some times over, where `dependent` are the names that may be functions of it.
pub(super) fn differentiated(
    value: &Expr,
    by: &str,
    times: &Expr,
    dependent: &BTreeSet<String>,
    span: &Range<usize>,
) -> Result<Expr, Refusal> {
    let times = small(times).filter(|times| (0..=MOST).contains(times)).ok_or_else(|| unknown("that often", span))?;
    if let Some(name) = names(value).iter().find(|name| dependent.contains(*name)) {
        return Err(unknown(&format!("of `{name}`, which depends on others"), span));
    }
    let mut value = value.clone();
    for _ in 0..times {
        let mut refused = None;
        value = each(&value, &mut |item| {
            by_rules(item, by, span).unwrap_or_else(|because| {
                refused.get_or_insert(because);
                item.clone()
            })
        });
        if let Some(because) = refused {
            return Err(because);
        }
    }
    Ok(value)
}

fn unknown(what: &str, span: &Range<usize>) -> Refusal {
    Refusal::new(format!("it must be computed: it calls `diff` {what}"), COMPUTE, span)
}

fn by_rules(value: &Expr, by: &str, span: &Range<usize>) -> Result<Expr, Refusal> {
    let is_by = |part: &Expr| part.as_symbol() == Some(by);
    if !any(value, &is_by) {
        return Ok(number(0, span));
    }
    let of = |part: &Expr| by_rules(part, by, span);
    match &value.kind {
        ExprKind::Symbol(_) => Ok(number(1, span)),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Ok(minus(of(operand)?, span)),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => of(operand),
        ExprKind::Binary { operator, left, right } => match operator {
            BinaryOperator::Add => Ok(sum(of(left)?, of(right)?, span)),
            BinaryOperator::Subtract => Ok(difference(of(left)?, of(right)?, span)),
            BinaryOperator::Multiply => {
                let (one, other) = (of(left)?, of(right)?);
                Ok(sum(product(one, (**right).clone(), span), product((**left).clone(), other, span), span))
            }
            BinaryOperator::Divide => {
                let (above, below) = (of(left)?, of(right)?);
                let first = quotient(above, (**right).clone(), span);
                let square = power((**right).clone(), number(2, span), span);
                Ok(difference(first, quotient(product((**left).clone(), below, span), square, span), span))
            }
            BinaryOperator::Power => of_power(left, right, by, span),
            _ => Err(unknown("of this operator", span)),
        },
        ExprKind::Call { .. } => match value.as_call() {
            Some((name, [argument])) => {
                let outer = of_function(name, argument, span)
                    .ok_or_else(|| unknown(&format!("of `{name}`, whose derivative is not known"), span))?;
                Ok(product(outer, of(argument)?, span))
            }
            _ => Err(unknown("of a function whose derivative is not known", span)),
        },
        _ => Err(unknown("of this", span)),
    }
}

fn of_power(base: &Expr, exponent: &Expr, by: &str, span: &Range<usize>) -> Result<Expr, Refusal> {
    let has = |part: &Expr| any(part, &|part| part.as_symbol() == Some(by));
    if !has(exponent) {
        let less = match exact(exponent) {
            Some(value) => exact_number(&(value - num_rational::BigRational::one()), span),
            None => difference(exponent.clone(), number(1, span), span),
        };
        let outer = product(exponent.clone(), power(base.clone(), less, span), span);
        return Ok(product(outer, by_rules(base, by, span)?, span));
    }
    if has(base) {
        return Err(unknown("of a power with a variable base and exponent", span));
    }
    let whole = binary(BinaryOperator::Power, base.clone(), exponent.clone(), span);
    let outer = match base.as_symbol() {
        Some("%e") => whole,
        _ => product(call("log", vec![base.clone()], span), whole, span),
    };
    Ok(product(outer, by_rules(exponent, by, span)?, span))
}

/// The derivative of a function at an argument.
fn of_function(name: &str, argument: &Expr, span: &Range<usize>) -> Option<Expr> {
    let x = || argument.clone();
    let of = |name: &str| call(name, vec![x()], span);
    let one = || number(1, span);
    let square = |inner: Expr| power(inner, number(2, span), span);
    let over = |below: Expr| quotient(one(), below, span);
    let root = |radicand: Expr| call("sqrt", vec![radicand], span);
    Some(match name {
        "sqrt" => over(product(number(2, span), root(x()), span)),
        "abs" => quotient(x(), of("abs"), span),
        "exp" => of("exp"),
        "log" => over(x()),
        "sin" => of("cos"),
        "cos" => minus(of("sin"), span),
        "tan" => sum(one(), square(of("tan")), span),
        "asin" => over(root(difference(one(), square(x()), span))),
        "acos" => minus(over(root(difference(one(), square(x()), span))), span),
        "atan" => over(sum(one(), square(x()), span)),
        "sinh" => of("cosh"),
        "cosh" => of("sinh"),
        "tanh" => difference(one(), square(of("tanh")), span),
        "asinh" => over(root(sum(square(x()), one(), span))),
        "atanh" => over(difference(one(), square(x()), span)),
        _ => return None,
    })
}

fn is_zero(value: &Expr) -> bool {
    exact(value).is_some_and(|value| value.is_zero())
}

fn is_one(value: &Expr) -> bool {
    exact(value).is_some_and(|value| value.is_one())
}

fn minus(value: Expr, span: &Range<usize>) -> Expr {
    match is_zero(&value) {
        true => value,
        false => Expr::new(ExprKind::Unary { operator: UnaryOperator::Minus, operand: Box::new(value) }, span.clone()),
    }
}

fn sum(left: Expr, right: Expr, span: &Range<usize>) -> Expr {
    match (is_zero(&left), is_zero(&right)) {
        (true, _) => right,
        (_, true) => left,
        _ => binary(BinaryOperator::Add, left, right, span),
    }
}

fn difference(left: Expr, right: Expr, span: &Range<usize>) -> Expr {
    match (is_zero(&left), is_zero(&right)) {
        (_, true) => left,
        (true, _) => minus(right, span),
        _ => binary(BinaryOperator::Subtract, left, right, span),
    }
}

fn product(left: Expr, right: Expr, span: &Range<usize>) -> Expr {
    if is_zero(&left) || is_zero(&right) {
        return number(0, span);
    }
    match (is_one(&left), is_one(&right)) {
        (true, _) => right,
        (_, true) => left,
        _ => binary(BinaryOperator::Multiply, left, right, span),
    }
}

fn quotient(left: Expr, right: Expr, span: &Range<usize>) -> Expr {
    match is_zero(&left) || is_one(&right) {
        true => left,
        false => binary(BinaryOperator::Divide, left, right, span),
    }
}

fn power(base: Expr, exponent: Expr, span: &Range<usize>) -> Expr {
    match (is_zero(&exponent), is_one(&exponent)) {
        (true, _) => number(1, span),
        (_, true) => base,
        _ => binary(BinaryOperator::Power, base, exponent, span),
    }
}

fn exact_number(value: &num_rational::BigRational, span: &Range<usize>) -> Expr {
    let whole = |value: &num_bigint::BigInt| {
        let magnitude = Expr::new(ExprKind::Integer(value.magnitude().clone().into()), span.clone());
        if value.sign() == num_bigint::Sign::Minus { minus(magnitude, span) } else { magnitude }
    };
    quotient(whole(value.numer()), whole(value.denom()), span)
}
