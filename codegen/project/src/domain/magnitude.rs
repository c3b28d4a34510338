//! Comparisons with magnitudes, as comparisons without: `abs(x) < y` is `x < y and -x < y`.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator};

use crate::construct::{binary, compared, integer, negative};

/// The most magnitudes of a comparison: each doubles what is compared.
const MOST: usize = 8;

/// A comparison of two sides without one of its magnitudes; `None` if it has none, or too many.
pub(super) fn without_one(relation: Relation, left: &Expr, right: &Expr) -> Option<Expr> {
    let difference = binary(BinaryOperator::Subtract, left.clone(), right.clone());
    let inner = magnitude(&difference).filter(|_| magnitudes(&difference) <= MOST)?;
    let [as_it_is, negated] = [inner.clone(), negative(inner.clone())].map(|value| {
        let side = |side: &Expr| replaced(side, inner, &value);
        compared(relation, side(left), side(right))
    });
    let rises = direction(&difference, inner);
    let join = match rises {
        Some(rises) if relation.is_below() || relation.is_above() => {
            // a magnitude is the larger of the two values: below an edge are both, above it is one
            if rises == relation.is_below() { BinaryOperator::And } else { BinaryOperator::Or }
        }
        _ => return Some(by_sign(inner, as_it_is, negated)),
    };
    Some(binary(join, as_it_is, negated))
}

/// What holds where the sign is known.
fn by_sign(inner: &Expr, as_it_is: Expr, negated: Expr) -> Expr {
    let case = |relation, then| binary(BinaryOperator::And, compared(relation, inner.clone(), integer(0)), then);
    let (above, below) = (case(Relation::GreaterOrEqual, as_it_is), case(Relation::Less, negated));
    binary(BinaryOperator::Or, above, below)
}

/// What stands in the first innermost magnitude.
fn magnitude(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Unary { operand, .. } => magnitude(operand),
        ExprKind::Binary { left, right, .. } => magnitude(left).or_else(|| magnitude(right)),
        ExprKind::Call { .. } => match expr.as_call() {
            Some(("abs", [inner])) => magnitude(inner).or(Some(inner)),
            _ => None,
        },
        _ => None,
    }
}

fn magnitudes(expr: &Expr) -> usize {
    match &expr.kind {
        ExprKind::Unary { operand, .. } => magnitudes(operand),
        ExprKind::Binary { left, right, .. } => magnitudes(left) + magnitudes(right),
        ExprKind::Call { arguments, .. } => 1 + arguments.iter().map(magnitudes).sum::<usize>(),
        _ => 0,
    }
}

/// Whether the expression rises with the magnitude of `inner`, or falls, wherever it stands; `None` where that is open.
fn direction(expr: &Expr, inner: &Expr) -> Option<bool> {
    let is_positive_number = |expr: &Expr| matches!(&expr.kind, ExprKind::Integer(_) | ExprKind::Float(_));
    match &expr.kind {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(!direction(operand, inner)?),
        ExprKind::Binary { operator, left, right } => match (operator, contains(left, inner), contains(right, inner)) {
            (BinaryOperator::Add | BinaryOperator::Subtract, true, false) => direction(left, inner),
            (BinaryOperator::Add, false, true) => direction(right, inner),
            (BinaryOperator::Subtract, false, true) => Some(!direction(right, inner)?),
            (BinaryOperator::Multiply, false, true) if is_positive_number(left) => direction(right, inner),
            (BinaryOperator::Multiply | BinaryOperator::Divide, true, false) if is_positive_number(right) => {
                direction(left, inner)
            }
            _ => None,
        },
        ExprKind::Call { .. } => is_magnitude_of(expr, inner).then_some(true),
        _ => None,
    }
}

fn contains(expr: &Expr, inner: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Unary { operand, .. } => contains(operand, inner),
        ExprKind::Binary { left, right, .. } => contains(left, inner) || contains(right, inner),
        ExprKind::Call { arguments, .. } => {
            is_magnitude_of(expr, inner) || arguments.iter().any(|argument| contains(argument, inner))
        }
        _ => false,
    }
}

fn is_magnitude_of(expr: &Expr, inner: &Expr) -> bool {
    matches!(expr.as_call(), Some(("abs", [argument])) if argument == inner)
}

/// The expression with `value` for every magnitude of `inner`.
fn replaced(expr: &Expr, inner: &Expr, value: &Expr) -> Expr {
    let part = |part: &Expr| Box::new(replaced(part, inner, value));
    let kind = match &expr.kind {
        _ if is_magnitude_of(expr, inner) => return value.clone(),
        ExprKind::Unary { operator, operand } => ExprKind::Unary { operator: *operator, operand: part(operand) },
        ExprKind::Binary { operator, left, right } => {
            ExprKind::Binary { operator: *operator, left: part(left), right: part(right) }
        }
        ExprKind::Call { function, arguments } => {
            let arguments = arguments.iter().map(|argument| replaced(argument, inner, value)).collect();
            ExprKind::Call { function: function.clone(), arguments }
        }
        kind => kind.clone(),
    };
    Expr::new(kind, expr.span.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::{parse_expression, print};

    fn split(condition: &str) -> String {
        let ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } =
            parse_expression(condition).unwrap().kind
        else {
            panic!("no comparison")
        };
        without_one(relation, &left, &right).map_or_else(|| "none".to_owned(), |split| print(&split))
    }

    #[test]
    fn magnitudes_become_two_comparisons() {
        assert_eq!(split("x < y"), "none");
        assert_eq!(split("abs(x) < y"), "x<y and -x<y");
        assert_eq!(split("y > 2*abs(x)+1"), "y>2*x+1 and y>2*-x+1");
        assert_eq!(split("abs(x-y) >= 1"), "x-y>=1 or -(x-y)>=1");
        assert_eq!(split("1-abs(x)/2 <= y"), "1-x/2<=y or 1--x/2<=y");
        assert_eq!(split("abs(x) # y"), "x>=0 and x#y or x<0 and -x#y");
        assert_eq!(split("y*abs(x) < 1"), "x>=0 and y*x<1 or x<0 and y*-x<1");
    }
}
