//! Numbers and conditions that hold whatever the inputs are.

use std::cmp::Ordering;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, ToPrimitive, Zero};

/// The largest exponent and factorial that are multiplied out.
const LARGEST: i64 = 1000;

/// The value of an expression of integers alone. Floats have none here: Maxima rounds what it computes with them.
pub(super) fn exact(expression: &Expr) -> Option<BigRational> {
    match &expression.kind {
        ExprKind::Integer(value) => Some(BigRational::from_integer(value.clone())),
        ExprKind::Unary { operator, operand } => {
            let value = exact(operand)?;
            match operator {
                UnaryOperator::Minus => Some(-value),
                UnaryOperator::Plus => Some(value),
                UnaryOperator::Factorial => factorial(&value),
                _ => None,
            }
        }
        ExprKind::Binary { operator, left, right } => {
            let (left, right) = (exact(left)?, exact(right)?);
            match operator {
                BinaryOperator::Add => Some(left + right),
                BinaryOperator::Subtract => Some(left - right),
                BinaryOperator::Multiply => Some(left * right),
                BinaryOperator::Divide => (!right.is_zero()).then(|| left / right),
                BinaryOperator::Power => power(left, &right),
                _ => None,
            }
        }
        _ => None,
    }
}

fn power(base: BigRational, exponent: &BigRational) -> Option<BigRational> {
    let exponent = exponent.is_integer().then(|| exponent.to_integer().to_i64())?.filter(|n| n.abs() <= LARGEST)?;
    let small = base.numer().bits().max(base.denom().bits()) <= 64;
    (small && (exponent > 0 || !base.is_zero())).then(|| base.pow(i32::try_from(exponent).unwrap_or_default()))
}

/// `n!`
pub(super) fn factorial(value: &BigRational) -> Option<BigRational> {
    let n = value.is_integer().then(|| value.to_integer().to_i64())?.filter(|n| (0..=LARGEST).contains(n))?;
    Some(BigRational::from_integer((1..=n).map(BigInt::from).product()))
}

/// Whether a condition holds, if numbers or logic alone decide it.
pub(super) fn decided(condition: &Expr) -> Option<bool> {
    match &condition.kind {
        ExprKind::Symbol(name) if name == "true" => Some(true),
        ExprKind::Symbol(name) if name == "false" => Some(false),
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => Some(!decided(operand)?),
        ExprKind::Binary { operator: BinaryOperator::And, left, right } => match (decided(left), decided(right)) {
            (Some(false), _) | (_, Some(false)) => Some(false),
            (Some(true), Some(true)) => Some(true),
            _ => None,
        },
        ExprKind::Binary { operator: BinaryOperator::Or, left, right } => match (decided(left), decided(right)) {
            (Some(true), _) | (_, Some(true)) => Some(true),
            (Some(false), Some(false)) => Some(false),
            _ => None,
        },
        ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
            Some(holds(*relation, exact(left)?.cmp(&exact(right)?)))
        }
        ExprKind::Call { arguments, .. } => match (condition.as_call()?.0, arguments.as_slice()) {
            ("equal", [left, right]) => Some(exact(left)? == exact(right)?),
            ("notequal", [left, right]) => Some(exact(left)? != exact(right)?),
            ("is", [inner]) => decided(inner),
            _ => None,
        },
        _ => None,
    }
}

fn holds(relation: Relation, ordering: Ordering) -> bool {
    match relation {
        Relation::Equal => ordering.is_eq(),
        Relation::NotEqual => ordering.is_ne(),
        Relation::Less => ordering.is_lt(),
        Relation::LessOrEqual => ordering.is_le(),
        Relation::Greater => ordering.is_gt(),
        Relation::GreaterOrEqual => ordering.is_ge(),
    }
}
