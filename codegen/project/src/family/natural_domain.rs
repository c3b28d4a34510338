//! Natural domains: what a formula needs by itself, whatever is promised of its inputs.

mod cubes;
mod number;
mod surds;

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator, print};
use num_bigint::BigInt;
use num_traits::Signed;

use super::super::domain::Condition;
use number::number;
use surds::Decision;

/// The conditions under which a formula has a real value: radicands not negative, denominators not zero.
///
/// Of sums of two terms with square roots, squares decide, and cubes of those with cube roots. Any other condition whose sides are no rational functions is
/// left out: it cannot be decided exactly.
pub(super) fn natural_domain(body: &Expr, parameters: &[String]) -> Vec<(String, Condition)> {
    let mut texts = Vec::new();
    collect(body, &mut texts);
    let conditions = texts.into_iter().filter_map(|text| {
        let condition = Condition::parse(&text, parameters).ok()?;
        Some((text, condition))
    });
    conditions.collect()
}

fn collect(expr: &Expr, texts: &mut Vec<String>) {
    match &expr.kind {
        ExprKind::Unary { operand, .. } => collect(operand, texts),
        ExprKind::Binary { operator, left, right } => {
            collect(left, texts);
            collect(right, texts);
            match operator {
                BinaryOperator::Divide => not_zero(right, texts),
                BinaryOperator::Power => power(left, right, texts),
                _ => {}
            }
        }
        ExprKind::Call { arguments, .. } => match expr.as_call() {
            Some(("sqrt", [radicand])) => {
                collect(radicand, texts);
                if !matches!(radicand.as_call(), Some(("abs", _))) {
                    condition(radicand, ">=", texts);
                }
            }
            // the unknown of a polynomial root is no input
            Some(("positive_root", _)) => {}
            _ => arguments.iter().for_each(|argument| collect(argument, texts)),
        },
        _ => {}
    }
}

/// `base^exponent`: a half needs a radicand, a minus a denominator. Odd roots are real of all numbers.
fn power(base: &Expr, exponent: &Expr, texts: &mut Vec<String>) {
    let Some(exponent) = number(exponent) else { return };
    match (is_odd(exponent.denom()), exponent.is_negative()) {
        (false, true) => condition(base, ">", texts),
        (false, false) => condition(base, ">=", texts),
        (true, true) => not_zero(base, texts),
        (true, false) => {}
    }
}

fn not_zero(expr: &Expr, texts: &mut Vec<String>) {
    match &expr.kind {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => not_zero(operand, texts),
        ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } => {
            not_zero(left, texts);
            not_zero(right, texts);
        }
        ExprKind::Binary { operator: BinaryOperator::Divide | BinaryOperator::Power, left, .. } => {
            not_zero(left, texts)
        }
        ExprKind::Call { .. } => match expr.as_call() {
            // what is never negative is positive where it is not zero
            Some(("sqrt", [radicand])) if matches!(radicand.as_call(), Some(("sqrt" | "abs", _))) => {
                not_zero(radicand, texts)
            }
            Some(("sqrt", [radicand])) => condition(radicand, ">", texts),
            Some(("abs", [inner])) => not_zero(inner, texts),
            _ => condition(expr, "#", texts),
        },
        _ => condition(expr, "#", texts),
    }
}

fn is_odd(number: &BigInt) -> bool {
    number.bit(0)
}

/// What has the sign of an odd power or root of it.
fn without_odd_power(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Binary { operator: BinaryOperator::Power, left, right } => match number(right) {
            Some(power) if is_odd(power.numer()) && is_odd(power.denom()) => without_odd_power(left),
            _ => expr,
        },
        _ => expr,
    }
}

/// `expr operator 0`, unless it says nothing because no input occurs in it.
fn condition(expr: &Expr, operator: &str, texts: &mut Vec<String>) {
    let expr = without_odd_power(expr);
    let text = match surds::decide(expr, operator) {
        Some(Decision::Always) => return,
        Some(Decision::Where(text)) => text,
        None => format!("{} {operator} 0", cubes::decide(expr).unwrap_or_else(|| print(expr))),
    };
    if has_input(expr) && !texts.contains(&text) {
        texts.push(text);
    }
}

fn has_input(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Symbol(name) => !name.starts_with('%'),
        ExprKind::Unary { operand, .. } => has_input(operand),
        ExprKind::Binary { left, right, .. } => has_input(left) || has_input(right),
        ExprKind::Call { arguments, .. } => arguments.iter().any(has_input),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::parse_expression;

    fn texts(formula: &str, parameters: &[&str]) -> Vec<String> {
        let parameters: Vec<String> = parameters.iter().map(|name| (*name).to_owned()).collect();
        let body = parse_expression(formula).unwrap();
        natural_domain(&body, &parameters).into_iter().map(|(text, _)| text).collect()
    }

    #[test]
    fn roots_and_denominators_give_conditions() {
        assert_eq!(texts("sqrt(x+1)-sqrt(x)", &["x"]), ["x+1 >= 0", "x >= 0"]);
        assert_eq!(texts("1/(1/f+1/g)", &["f", "g"]), ["f # 0", "g # 0", "1/f+1/g # 0"]);
        assert_eq!(texts("x^(-3)*y^(1/2)/sqrt(z)", &["x", "y", "z"]), ["x # 0", "y >= 0", "z >= 0", "z > 0"]);
        assert_eq!(texts("x^(-1/2)", &["x"]), ["x > 0"]);
        assert_eq!(texts("x^-(1/2)*y^0.5", &["x", "y"]), ["x > 0", "y >= 0"]);
        assert_eq!(texts("x^2.0*y^(1-2)*z^(4/2)", &["x", "y", "z"]), ["y # 0"]);
        assert_eq!(texts("x^(1-3/2)*y^(0.5+1)", &["x", "y"]), ["x > 0", "y >= 0"]);
        assert_eq!(texts("a/(2*b)", &["a", "b"]), ["b # 0"]);
        assert_eq!(texts("a/sqrt(sqrt(b))", &["a", "b"]), ["b >= 0", "b > 0"]);
        assert_eq!(texts("a/sqrt(abs(b))", &["a", "b"]), ["b # 0"]);
        assert_eq!(texts("a/%pi+a^2", &["a"]), [""; 0]);
        assert_eq!(texts("(a/b)^(2/3)-a^(1/3)", &["a", "b"]), ["b # 0"]);
        assert_eq!(texts("a^(-1/3)+sqrt((a-b)^(1/3))", &["a", "b"]), ["a # 0", "a-b >= 0"]);
    }

    #[test]
    fn what_cannot_be_decided_exactly_is_left_out() {
        assert_eq!(texts("sqrt(1-sqrt(1+sqrt(x)))", &["x"]), ["x >= 0"]);
        assert_eq!(texts("1/(sqrt(x)+sqrt(y)-sqrt(z))", &["x", "y", "z"]), ["x >= 0", "y >= 0", "z >= 0"]);
    }

    #[test]
    fn cubes_decide_about_two_cube_roots() {
        let last = |formula: &str| texts(formula, &["a", "b"]).pop();
        assert_eq!(last("1/(a^(1/3)-b^(1/3))").as_deref(), Some("a-b # 0"));
        assert_eq!(last("sqrt(2*a*b^(2/3)-3)").as_deref(), Some("2^3*a^3*b^2-3^3 >= 0"));
        assert_eq!(last("sqrt(b-a^(1/3)/2)").as_deref(), Some("b^3-a/2^3 >= 0"));
        assert_eq!(last("1/(a^(1/3)+b^(1/3)-1)"), None);
    }

    #[test]
    fn squares_decide_about_two_roots() {
        let last = |formula: &str| texts(formula, &["a", "b", "x"]).pop().unwrap();
        assert_eq!(last("sqrt(1-sqrt(x))"), "1-x >= 0");
        assert_eq!(last("sqrt(1+sqrt(x))"), "x >= 0", "always");
        assert_eq!(last("1/(b+sqrt(a))"), "a-b^2 # 0 or b*a > 0");
        assert_eq!(last("1/(sqrt(a)-sqrt(b))"), "a-b # 0");
        assert_eq!(last("1/(1-abs(a))"), "a^2-1 # 0");
        assert_eq!(last("1/(1+abs(a))+b/x"), "x # 0", "always");
        assert_eq!(last("1/(sqrt(a)+sqrt(b))"), "a-b # 0 or a > 0");
        assert_eq!(last("2*x/(-b-sqrt(b^2-4*a*x))"), "b^2-4*a*x-b^2 # 0 or b*(b^2-4*a*x) > 0");
        let clauses =
            ["-a/3 >= 0 and (a/3)^2*b-x^2 > 0", "x >= 0 and x^2-(a/3)^2*b > 0", "-a/3 > 0 and (a/3)^2*b > 0 and x > 0"];
        assert_eq!(last("1/sqrt(x-a*sqrt(b)/3)"), clauses.join(" or "));
    }
}
