//! Natural domains: what a formula needs by itself, whatever is promised of its inputs.

mod cubes;
mod number;
mod positive;
mod surds;

use closedform_maxima::ast::Branch;
use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator, print};
use num_bigint::BigInt;
use num_traits::Signed;
use std::cmp::Ordering;

use super::super::domain::Condition;
use crate::construct::{binary, compared, integer, joined, squared};
use crate::expression::is_of_roots;
use number::{has_input, number};
use positive::{is_positive, without_positive_constants};
use surds::{Clause, Decision};

/// The conditions under which a formula has a real value: radicands not negative, denominators not zero.
///
/// Of sums of two terms with square roots, squares decide, and cubes of those with cube roots. Any other condition whose
/// sides are no rational functions is left out: it cannot be decided exactly.
pub(super) fn natural_domain(body: &Expr, parameters: &[String]) -> Vec<(String, Condition)> {
    all(body, parameters).filter_map(|(text, condition)| Some((text, condition?))).collect()
}

/// Those conditions that cannot be decided exactly, as people read them.
pub(super) fn left_open(body: &Expr, parameters: &[String]) -> Vec<String> {
    all(body, parameters).filter_map(|(text, condition)| condition.is_none().then_some(text)).collect()
}

/// All conditions, with their exact forms if they have any.
fn all(body: &Expr, parameters: &[String]) -> impl Iterator<Item = (String, Option<Condition>)> {
    let mut needs = Needs::default();
    needs.collect(body);
    needs.found.into_iter().filter_map(|(text, clauses)| {
        let clauses = clauses.into_iter().filter_map(|clause| joined(BinaryOperator::And, clause));
        let condition = Condition::read(&joined(BinaryOperator::Or, clauses)?, parameters).ok();
        Some((text, condition))
    })
}

/// Conditions in the order in which they were met, each as people read it and as clauses of which one must hold.
#[derive(Default)]
struct Needs {
    found: Vec<(String, Vec<Clause>)>,
    /// Where one of these holds, another side of an `if` is taken than that around the current place.
    elsewhere: Vec<Expr>,
}

impl Needs {
    /// That the expression compares so with zero, unless it says nothing because no input occurs in it.
    fn condition(&mut self, expr: &Expr, relation: Relation) {
        let expr = without_positive_constants(without_odd_power(expr));
        if relation != Relation::Equal && is_positive(expr) {
            return;
        }
        let clauses = match surds::decide(expr, relation) {
            Some(Decision::Always) => return,
            Some(Decision::Where(clauses)) => clauses,
            None => {
                let decided = cubes::decide(expr).unwrap_or_else(|| expr.clone());
                vec![vec![compared(relation, decided, integer(0))]]
            }
        };
        // nothing is needed where another side is taken
        let clauses: Vec<Clause> = self.elsewhere.iter().map(|other| vec![other.clone()]).chain(clauses).collect();
        let text = text_of(&clauses);
        if has_input(expr) && !is_certain(&clauses) && self.found.iter().all(|(known, _)| *known != text) {
            self.found.push((text, clauses));
        }
    }

    /// The sides of an `if`, each where it is taken; a condition is reached where those before it fail.
    fn choice(&mut self, branches: &[Branch], otherwise: Option<&Expr>) {
        let outer = self.elsewhere.len();
        for Branch { condition, value } in branches {
            self.collect(condition);
            self.elsewhere.push(fails(condition));
            self.collect(value);
            self.elsewhere.pop();
            self.elsewhere.push(condition.clone());
        }
        otherwise.iter().for_each(|value| self.collect(value));
        self.elsewhere.truncate(outer);
    }

    fn collect(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Unary { operand, .. } => self.collect(operand),
            ExprKind::Binary { operator, left, right } => {
                self.collect(left);
                self.collect(right);
                match operator {
                    BinaryOperator::Divide => self.not_zero(right),
                    BinaryOperator::Power => self.power(left, right),
                    _ => {}
                }
            }
            ExprKind::If { branches, otherwise } => self.choice(branches, otherwise.as_deref()),
            ExprKind::Call { arguments, .. } => match expr.as_call() {
                Some(("sqrt", [radicand])) => {
                    self.collect(radicand);
                    if !matches!(radicand.as_call(), Some(("abs", _))) {
                        self.condition(radicand, Relation::GreaterOrEqual);
                    }
                }
                Some(("log", [argument])) => {
                    self.collect(argument);
                    self.condition(argument, Relation::Greater);
                }
                Some((name @ ("asin" | "acos" | "atanh"), [argument])) => {
                    self.collect(argument);
                    let rest = binary(BinaryOperator::Subtract, integer(1), squared(argument.clone()));
                    let relation = if name == "atanh" { Relation::Greater } else { Relation::GreaterOrEqual };
                    self.condition(&rest, relation);
                }
                Some(("acosh", [argument])) => {
                    self.collect(argument);
                    let rest = binary(BinaryOperator::Subtract, argument.clone(), integer(1));
                    self.condition(&rest, Relation::GreaterOrEqual);
                }
                // the origin has no angle
                Some(("atan2", [y, x])) => {
                    arguments.iter().for_each(|argument| self.collect(argument));
                    let sum = binary(BinaryOperator::Add, squared(x.clone()), squared(y.clone()));
                    self.condition(&sum, Relation::Greater);
                }
                Some(("mod", [x, y])) => {
                    self.collect(x);
                    self.collect(y);
                    self.not_zero(y);
                }
                // the unknown of a polynomial root is no input
                Some(("positive_root", _)) => {}
                _ => arguments.iter().for_each(|argument| self.collect(argument)),
            },
            _ => {}
        }
    }

    /// `base^exponent`: a half needs a radicand, a minus a denominator. Odd roots are real of all numbers.
    fn power(&mut self, base: &Expr, exponent: &Expr) {
        if base.as_symbol() == Some("%e") {
            return;
        }
        let Some(exponent) = number(exponent).filter(is_of_roots) else {
            return self.condition(base, Relation::Greater);
        };
        match (is_odd(exponent.denom()), exponent.is_negative()) {
            (false, true) => self.condition(base, Relation::Greater),
            (false, false) => self.condition(base, Relation::GreaterOrEqual),
            (true, true) => self.not_zero(base),
            (true, false) => {}
        }
    }

    fn not_zero(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Unary { operator: UnaryOperator::Minus, operand } => self.not_zero(operand),
            ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } => {
                self.not_zero(left);
                self.not_zero(right);
            }
            ExprKind::Binary { operator: BinaryOperator::Divide | BinaryOperator::Power, left, .. } => {
                self.not_zero(left)
            }
            ExprKind::Call { .. } => match expr.as_call() {
                // what is never negative is positive where it is not zero
                Some(("sqrt", [radicand])) if matches!(radicand.as_call(), Some(("sqrt" | "abs", _))) => {
                    self.not_zero(radicand)
                }
                Some(("sqrt", [radicand])) => self.condition(radicand, Relation::Greater),
                Some(("abs", [inner])) => self.not_zero(inner),
                _ => self.condition(expr, Relation::NotEqual),
            },
            _ => self.condition(expr, Relation::NotEqual),
        }
    }
}

/// The condition that holds where this one fails.
fn fails(condition: &Expr) -> Expr {
    match &condition.kind {
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => (**operand).clone(),
        ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right } => {
            compared(relation.negated(), (**left).clone(), (**right).clone())
        }
        _ => {
            let operand = Box::new(condition.clone());
            Expr::new(ExprKind::Unary { operator: UnaryOperator::Not, operand }, condition.span.clone())
        }
    }
}

/// Whether comparisons of the same two sides hold in every order of them.
fn is_certain(clauses: &[Clause]) -> bool {
    let single = |clause: &Clause| match clause.as_slice() {
        [Expr { kind: ExprKind::Binary { operator: BinaryOperator::Compare(relation), left, right }, .. }] => {
            Some((*relation, print(left), print(right)))
        }
        _ => None,
    };
    let singles: Vec<_> = clauses.iter().filter_map(single).collect();
    singles.iter().any(|(_, left, right)| {
        let same = singles.iter().filter(|(_, a, b)| a == left && b == right);
        let relations: Vec<Relation> = same.map(|(relation, ..)| *relation).collect();
        [Ordering::Less, Ordering::Equal, Ordering::Greater]
            .into_iter()
            .all(|order| relations.iter().any(|relation| relation.holds(order)))
    })
}

fn text_of(clauses: &[Clause]) -> String {
    let clause = |clause: &Clause| clause.iter().map(comparison_text).collect::<Vec<_>>().join(" and ");
    clauses.iter().map(clause).collect::<Vec<_>>().join(" or ")
}

fn comparison_text(comparison: &Expr) -> String {
    match &comparison.kind {
        ExprKind::Binary { operator, left, right } => {
            format!("{} {} {}", print(left), operator.symbol(), print(right))
        }
        _ => print(comparison),
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

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::parse_expression;

    fn texts(formula: &str, parameters: &[&str]) -> Vec<String> {
        let parameters: Vec<String> = parameters.iter().map(|name| (*name).to_owned()).collect();
        let body = parse_expression(formula).unwrap();
        let read = |(text, condition): (String, Condition)| {
            // what people read is what is decided
            assert_eq!(Condition::parse(&text, &parameters).as_ref(), Ok(&condition), "{text}");
            text
        };
        natural_domain(&body, &parameters).into_iter().map(read).collect()
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
        assert_eq!(texts("atan2(a,b/a)", &["a", "b"]), ["a # 0", "(b/a)^2+a^2 > 0"]);
        assert_eq!(texts("(a/b)^(2/3)-a^(1/3)", &["a", "b"]), ["b # 0"]);
        assert_eq!(texts("mod(1/a,b-a)+mod(a,2)", &["a", "b"]), ["a # 0", "b-a # 0"]);
        assert_eq!(texts("(2*%pi*a)^b+log(b/%pi)", &["a", "b"]), ["a > 0", "b > 0"]);
        assert_eq!(texts("1/(1+exp(-a/b))+log(cosh(a)+%e^b*2)+sqrt(sqrt(a)/%pi+1)", &["a", "b"]), ["b # 0", "a >= 0"]);
        assert_eq!(texts("a^(-1/3)+sqrt((a-b)^(1/3))", &["a", "b"]), ["a # 0", "a-b >= 0"]);
    }

    #[test]
    fn a_side_of_an_if_needs_something_only_where_it_is_taken() {
        assert_eq!(texts("if x > 0 then sqrt(x) else 1/x", &["x"]), ["x > 0 or x # 0"]);
        assert_eq!(
            texts("if x > 0 and y > 1 then 1/y elseif y < x then sqrt(x) else 0", &["x", "y"]),
            ["not (x>0 and y>1) or y # 0", "x>0 and y>1 or y >= x or x >= 0"]
        );
        assert_eq!(texts("if 1/x > 0 then x else y", &["x", "y"]), ["x # 0"]);
    }

    #[test]
    fn what_cannot_be_decided_exactly_is_left_out() {
        assert_eq!(texts("sqrt(1-sqrt(1+sqrt(x)))", &["x"]), ["x >= 0"]);
        assert_eq!(texts("1/(sqrt(x)+sqrt(y)-sqrt(z))", &["x", "y", "z"]), ["x >= 0", "y >= 0", "z >= 0"]);
    }

    #[test]
    fn what_is_left_open_is_known() {
        let open = |formula: &str| left_open(&parse_expression(formula).unwrap(), &["x".to_owned(), "y".to_owned()]);
        assert_eq!(open("sqrt(1-sqrt(1+sqrt(x)))/y"), ["1-sqrt(1+sqrt(x)) >= 0"]);
        assert_eq!(open("sqrt(x)/(1+sqrt(y))"), [""; 0]);
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
