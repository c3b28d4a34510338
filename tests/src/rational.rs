//! Maxima expressions and conditions decided exactly, in rational arithmetic: a twin of the project's, on purpose.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use closedform_maxima::ast::BinaryOperator as Operator;
use closedform_maxima::{Expr, ExprKind, Relation, UnaryOperator, exact};
use rug::Rational;
use rug::ops::Pow;

/// Exact values by name.
pub type Names<'a> = BTreeMap<&'a str, Rational>;

/// The exact value; none for what is no rational function of the names, and for a division by zero.
pub fn value(expression: &Expr, names: &Names) -> Option<Rational> {
    match &expression.kind {
        ExprKind::Symbol(name) => names.get(name.as_str()).cloned(),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(-value(operand, names)?),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => value(operand, names),
        ExprKind::Binary { operator: Operator::Power, left, right } => power(&value(left, names)?, right),
        ExprKind::Call { .. } => match expression.as_call() {
            Some(("abs", [inner])) => value(inner, names).map(Rational::abs),
            _ => None,
        },
        ExprKind::Binary { operator, left, right } => combine(*operator, value(left, names)?, value(right, names)?),
        _ => number(expression),
    }
}

/// Whether the condition is true; none where that depends on a comparison with a side that has no exact value. Such a
/// comparison is neither true nor false: `and` is false by any part, `or` true by any, whatever the others are.
pub fn holds(condition: &Expr, names: &Names) -> Option<bool> {
    match &condition.kind {
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => Some(!holds(operand, names)?),
        ExprKind::Binary { operator: Operator::And, left, right } => joined(left, right, names, false),
        ExprKind::Binary { operator: Operator::Or, left, right } => joined(left, right, names, true),
        ExprKind::Binary { operator, left, right } => {
            let Operator::Compare(relation) = operator else { return None };
            Some(compares(*relation, value(left, names)?.cmp(&value(right, names)?)))
        }
        _ => None,
    }
}

/// The truth of two conditions of which one alone decides if it is `decides`.
fn joined(left: &Expr, right: &Expr, names: &Names, decides: bool) -> Option<bool> {
    let parts = [holds(left, names), holds(right, names)];
    if parts.contains(&Some(decides)) {
        return Some(decides);
    }
    (!parts.contains(&None)).then_some(!decides)
}

fn number(expression: &Expr) -> Option<Rational> {
    match &expression.kind {
        ExprKind::Integer(integer) => i64::try_from(integer).ok().map(Rational::from).or_else(|| literal(expression)),
        _ => literal(expression),
    }
}

fn literal(expression: &Expr) -> Option<Rational> {
    exact::rational(expression).ok()?.to_string().parse().ok()
}

fn power(base: &Rational, exponent: &Expr) -> Option<Rational> {
    let exponent = value(exponent, &Names::new())?;
    let whole = exponent.is_integer().then(|| exponent.numer().to_i32()).flatten()?;
    (whole >= 0 || !base.is_zero()).then(|| Rational::from(base.pow(whole)))
}

fn combine(operator: Operator, left: Rational, right: Rational) -> Option<Rational> {
    match operator {
        Operator::Add => Some(left + right),
        Operator::Subtract => Some(left - right),
        Operator::Multiply => Some(left * right),
        Operator::Divide => (!right.is_zero()).then(|| left / right),
        _ => None,
    }
}

/// Decided here, not by the relation itself: the judges share its name only.
fn compares(relation: Relation, order: Ordering) -> bool {
    match relation {
        Relation::Equal => order.is_eq(),
        Relation::NotEqual => order.is_ne(),
        Relation::Less => order.is_lt(),
        Relation::LessOrEqual => order.is_le(),
        Relation::Greater => order.is_gt(),
        Relation::GreaterOrEqual => order.is_ge(),
    }
}

#[cfg(test)]
mod tests {
    use closedform_maxima::parse_expression;

    use super::*;

    fn names() -> Names<'static> {
        [("x", Rational::from((1, 3))), ("y", Rational::from(-2))].into()
    }

    #[test]
    fn values_are_exact() {
        // A float is the double nearest to it, as in Maxima.
        for (text, expected) in [("-x^2*y + 1", (11, 9)), ("(x-1/3)*y", (0, 1)), ("y^-3", (-1, 8)), ("0.25", (1, 4))] {
            let expected = Some(Rational::from(expected));
            assert_eq!(value(&parse_expression(text).unwrap(), &names()), expected, "{text}");
        }
    }

    #[test]
    fn what_is_not_rational_has_no_value() {
        for text in ["sqrt(x)", "z", "1/(x-1/3)", "y^x", "(x-1/3)^-1"] {
            assert_eq!(value(&parse_expression(text).unwrap(), &names()), None, "{text}");
        }
    }

    #[test]
    fn what_has_no_value_is_neither_true_nor_false() {
        let truth = |text: &str| holds(&parse_expression(text).unwrap(), &names());
        for pole in [
            "1/(3*x-1) > 0",
            "abs(1/(3*x-1)) >= 0",
            "(3*x-1)^-2 # 7",
            "(x^2-1/9)/(x-1/3) > 0",
            "0/(x-1/3) = 0",
            "1/(1/(x-1/3)) < 1",
        ] {
            assert_eq!(truth(pole), None, "{pole}");
            assert_eq!(truth(&format!("not {pole}")), None, "{pole}");
            for (joined, expected) in
                [("and x < y", Some(false)), ("and x > y", None), ("or x > y", Some(true)), ("or x < y", None)]
            {
                assert_eq!(truth(&format!("{pole} {joined}")), expected, "{pole} {joined}");
            }
        }
        assert_eq!(truth("abs(y) = 2 and abs(x-1) > 1/2"), Some(true));
    }

    #[test]
    fn conditions_are_decided() {
        for text in ["3*x >= 1", "3*x <= 1 and y # x", "y > x or x > y", "not x < y"] {
            assert_eq!(holds(&parse_expression(text).unwrap(), &names()), Some(true), "{text}");
        }
        for text in ["3*x > 1", "3*x <= 1 and y = x", "y > x or x < y", "not x > y"] {
            assert_eq!(holds(&parse_expression(text).unwrap(), &names()), Some(false), "{text}");
        }
        assert_eq!(holds(&parse_expression("x + y").unwrap(), &names()), None);
    }
}
