//! `if` in a formula, and functions that are defined by cases, as choices between two values.

use super::lower::{LowerError, lower, unsupported};
use super::{Expr, Test};
use closedform_maxima::Relation;
use closedform_maxima::ast::{BinaryOperator, Branch, Expr as Ast, ExprKind, UnaryOperator};
use closedform_syntax::Function;

/// The value of the first branch whose condition holds, else of `otherwise`.
pub(super) fn choice(branches: &[Branch], otherwise: Option<&Ast>, ast: &Ast) -> Result<Expr, LowerError> {
    let Some(otherwise) = otherwise else {
        let remedy = "write `else` and a value: without it there is none where no condition holds";
        return Err(unsupported(ast, "an `if` without `else`", remedy));
    };
    branches.iter().rev().try_fold(lower(otherwise)?, |otherwise, Branch { condition, value }| {
        Ok(Expr::Choice(test(condition)?, Box::new([lower(value)?, otherwise])))
    })
}

fn test(condition: &Ast) -> Result<Test, LowerError> {
    match &condition.kind {
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => Ok(Test::Not(Box::new(test(operand)?))),
        ExprKind::Binary { operator: BinaryOperator::And, left, right } => {
            Ok(Test::And(Box::new([test(left)?, test(right)?])))
        }
        ExprKind::Binary { operator: BinaryOperator::Or, left, right } => {
            Ok(Test::Or(Box::new([test(left)?, test(right)?])))
        }
        ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
            Ok(Test::Compare(*relation, Box::new([lower(left)?, lower(right)?])))
        }
        _ => {
            let remedy = "compare with < <= > >= = #, and join comparisons with and, or, not";
            Err(unsupported(condition, "such a condition", remedy))
        }
    }
}

/// 1 of positive numbers, -1 of negative ones, 0 of zero.
pub(super) fn signum(x: Expr) -> Expr {
    let negative = by_sign(x.clone(), Relation::Less, Expr::integer(-1), Expr::integer(0));
    by_sign(x, Relation::Greater, Expr::integer(1), negative)
}

/// The angle of the point (x, y), from -pi to pi: by the arc tangent of the quotient that has a value. At the origin, which is
/// in no domain, there is none.
pub(super) fn atan2(y: Expr, x: Expr) -> Expr {
    let angle = |above: &Expr, below: &Expr| Expr::call(Function::Atan, above.clone().over(below.clone()));
    let from = |right_angle: i64| Expr::Pi.times(Expr::integer(right_angle)).over(Expr::integer(2));
    let below = by_sign(y.clone(), Relation::Less, from(-1).minus(angle(&x, &y)), Expr::Pi);
    let left = by_sign(y.clone(), Relation::Greater, from(1).minus(angle(&x, &y)), below);
    by_sign(x.clone(), Relation::Greater, angle(&y, &x), left)
}

fn by_sign(x: Expr, relation: Relation, then: Expr, otherwise: Expr) -> Expr {
    Expr::Choice(Test::Compare(relation, Box::new([x, Expr::integer(0)])), Box::new([then, otherwise]))
}

#[cfg(test)]
mod tests {
    use super::super::lower;
    use super::*;
    use closedform_maxima::parse_expression;

    fn read(text: &str) -> Result<Expr, LowerError> {
        lower(&parse_expression(text).unwrap())
    }

    #[test]
    fn branches_are_choices_in_choices() {
        let nested = read("if a<b then x else (if not (c=d) or e#x then y else z)").unwrap();
        assert_eq!(read("if a<b then x elseif not (c=d) or e#x then y else z").unwrap(), nested);
        assert_eq!(nested.symbols().into_iter().collect::<String>(), "abcdexyz");
        assert_eq!(read("signum(x)").unwrap(), read("if x>0 then 1 elseif x<0 then -1 else 0").unwrap());
    }

    #[test]
    fn what_is_no_choice_between_numbers_is_refused() {
        let told = |text: &str| read(text).unwrap_err().what;
        assert!(told("if a<b then x").contains("without `else`"));
        assert!(told("if f(a) then x else y").contains("such a condition"));
        assert!(told("if a<b then erf(x) else y").contains("erf"));
    }
}
