//! Functions that are defined by cases, as choices between two values.

use super::tree::{Expr, Test};
use closedform_maxima::Relation;
use closedform_syntax::Function;

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
