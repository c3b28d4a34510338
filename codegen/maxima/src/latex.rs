//! Expressions as LaTeX.

mod name;

use num_bigint::{BigInt, Sign};

use crate::ast::{BinaryOperator, Branch, Expr, ExprKind, LoopClause, UnaryOperator};

use name::{name, text};

/// The expression as LaTeX for mathematics mode.
///
/// Quotients become fractions, powers with exponent 1/2 or 1/3 roots; `tOut` becomes `t_{\mathrm{Out}}`.
#[must_use]
pub fn to_latex(expression: &Expr) -> String {
    match &expression.kind {
        ExprKind::Integer(value) => value.to_string(),
        ExprKind::Float(digits) | ExprKind::BigFloat(digits) => number(digits),
        ExprKind::String(content) => format!(r"\text{{{}}}", text(content)),
        ExprKind::Symbol(symbol) => name(symbol),
        ExprKind::Quote { expression, .. } => to_latex(expression),
        ExprKind::Call { function, arguments } => call(function, arguments),
        ExprKind::Subscript { array, indices } => format!("{{{}}}_{{{}}}", atom(array), joined(indices)),
        ExprKind::List(elements) => format!(r"\left[{}\right]", joined(elements)),
        ExprKind::Set(elements) => format!(r"\left\{{{}\right\}}", joined(elements)),
        ExprKind::Sequence(elements) => parentheses(&joined(elements)),
        ExprKind::Unary { operator, operand } => unary(*operator, operand),
        ExprKind::Binary { operator, left, right } => binary(*operator, left, right),
        ExprKind::If { branches, otherwise } => cases(branches, otherwise.as_deref()),
        ExprKind::Loop { clauses, body } => repetition(clauses, body),
        ExprKind::Ev { expression, options } => {
            format!(r"\left.{}\right|_{{{}}}", to_latex(expression), joined(options))
        }
    }
}

/// How tightly the drawn form holds together; more than Maxima has, as fractions need no parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Statement,
    Or,
    And,
    Not,
    Relation,
    Sum,
    Product,
    Fraction,
    Power,
    Atom,
}

fn hold(expression: &Expr) -> Hold {
    match &expression.kind {
        ExprKind::Integer(value) if value.sign() == Sign::Minus => Hold::Sum,
        ExprKind::Float(digits) | ExprKind::BigFloat(digits) if has_exponent(digits) => Hold::Product,
        ExprKind::Unary { operator: UnaryOperator::Not, .. } => Hold::Not,
        ExprKind::Unary { operator, .. } if operator.is_postfix() => Hold::Power,
        ExprKind::Unary { .. } => Hold::Sum,
        ExprKind::Binary { operator: BinaryOperator::Power, right, .. } if root(right).is_some() => Hold::Fraction,
        ExprKind::Binary { operator, .. } => operator_hold(*operator),
        ExprKind::If { .. } | ExprKind::Loop { .. } => Hold::Statement,
        ExprKind::Quote { expression, .. } => hold(expression),
        ExprKind::Call { function, .. } if function.as_symbol() == Some("exp") => Hold::Power,
        ExprKind::Call { function, .. } if function.as_symbol() == Some("sqrt") => Hold::Fraction,
        _ => Hold::Atom,
    }
}

fn operator_hold(operator: BinaryOperator) -> Hold {
    use BinaryOperator as B;
    match operator {
        B::Add | B::Subtract => Hold::Sum,
        B::Multiply | B::Dot => Hold::Product,
        B::Divide => Hold::Fraction,
        B::Power | B::DotPower => Hold::Power,
        B::And => Hold::And,
        B::Or => Hold::Or,
        B::Assign | B::AssignValue | B::Define | B::DefineMacro => Hold::Statement,
        B::Field => Hold::Atom,
        _ => Hold::Relation,
    }
}

/// The operand, in parentheses unless it holds together more tightly than `least`, or as tightly.
fn operand(expression: &Expr, least: Hold) -> String {
    let drawn = to_latex(expression);
    if hold(expression) < least { parentheses(&drawn) } else { drawn }
}

fn atom(expression: &Expr) -> String {
    operand(expression, Hold::Atom)
}

fn parentheses(inner: &str) -> String {
    format!(r"\left({inner}\right)")
}

fn joined(elements: &[Expr]) -> String {
    elements.iter().map(to_latex).collect::<Vec<_>>().join(", ")
}

fn has_exponent(digits: &str) -> bool {
    digits.contains(|c: char| c.is_ascii_alphabetic())
}

fn number(digits: &str) -> String {
    match digits.split_once(|c: char| c.is_ascii_alphabetic()) {
        Some((mantissa, exponent)) => format!(r"{mantissa}\cdot 10^{{{}}}", exponent.trim_start_matches('+')),
        None => digits.to_owned(),
    }
}

fn unary(operator: UnaryOperator, inner: &Expr) -> String {
    match operator {
        UnaryOperator::Plus => format!("+{}", operand(inner, Hold::Product)),
        UnaryOperator::Minus => format!("-{}", operand(inner, Hold::Product)),
        UnaryOperator::Not => format!(r"\lnot {}", operand(inner, Hold::Relation)),
        UnaryOperator::Factorial | UnaryOperator::DoubleFactorial => format!("{}{}", atom(inner), operator.symbol()),
    }
}

fn binary(operator: BinaryOperator, left: &Expr, right: &Expr) -> String {
    match operator {
        BinaryOperator::Divide => format!(r"\frac{{{}}}{{{}}}", to_latex(left), to_latex(right)),
        BinaryOperator::Multiply => product(left, right),
        BinaryOperator::Power => power(left, right),
        BinaryOperator::DotPower => format!(r"{}^{{\langle {}\rangle}}", atom(left), to_latex(right)),
        _ => {
            let level = operator_hold(operator);
            let after = if operator == BinaryOperator::Subtract { Hold::Product } else { tighter(level) };
            format!("{}{}{}", operand(left, level), sign(operator), operand(right, after))
        }
    }
}

/// What the right operand of a chain at `level` must hold, so that it is not drawn as a part of the chain.
fn tighter(level: Hold) -> Hold {
    match level {
        Hold::Sum => Hold::Product,
        Hold::Product => Hold::Fraction,
        Hold::Relation => Hold::Sum,
        level => level,
    }
}

fn sign(operator: BinaryOperator) -> &'static str {
    use BinaryOperator as B;
    match operator {
        B::Compare(relation) => relation.latex(),
        B::And => r"\land ",
        B::Or => r"\lor ",
        B::Dot => r"\cdot ",
        B::Define | B::DefineMacro => ":=",
        other => other.symbol(),
    }
}

/// Factors side by side; between digits a dot, so that `2*3` is not read as 23.
fn product(left: &Expr, right: &Expr) -> String {
    let (first, second) = (operand(left, Hold::Product), operand(right, Hold::Fraction));
    let dot = second.starts_with(|c: char| c.is_ascii_digit());
    format!("{first}{}{second}", if dot { r"\cdot " } else { r"\," })
}

/// The degree of the root that the exponent `1/n` draws.
fn root(exponent: &Expr) -> Option<&BigInt> {
    let ExprKind::Binary { operator: BinaryOperator::Divide, left, right } = &exponent.kind else {
        return None;
    };
    match (&left.kind, &right.kind) {
        (ExprKind::Integer(one), ExprKind::Integer(degree)) if *one == BigInt::from(1) => Some(degree),
        _ => None,
    }
}

fn power(base: &Expr, exponent: &Expr) -> String {
    match root(exponent) {
        Some(degree) if *degree == BigInt::from(2) => format!(r"\sqrt{{{}}}", to_latex(base)),
        Some(degree) => format!(r"\sqrt[{degree}]{{{}}}", to_latex(base)),
        None => format!("{}^{{{}}}", atom(base), to_latex(exponent)),
    }
}

fn call(function: &Expr, arguments: &[Expr]) -> String {
    match (function.as_symbol(), arguments) {
        (Some("sqrt"), [inner]) => format!(r"\sqrt{{{}}}", to_latex(inner)),
        (Some("abs"), [inner]) => format!(r"\left|{}\right|", to_latex(inner)),
        (Some("exp"), [inner]) => format!("e^{{{}}}", to_latex(inner)),
        (Some("positive_root"), [polynomial, variable]) => {
            let variable = to_latex(variable);
            format!(r"\operatorname{{root}}_{{{variable}>0}}{}", parentheses(&to_latex(polynomial)))
        }
        (Some(known), _) if KNOWN.contains(&known) => format!(r"\{known}{}", parentheses(&joined(arguments))),
        _ => format!("{}{}", atom(function), parentheses(&joined(arguments))),
    }
}

/// Functions that LaTeX has a command for.
const KNOWN: [&str; 11] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "log", "min", "max", "cot", "sec"];

fn cases(branches: &[Branch], otherwise: Option<&Expr>) -> String {
    let mut rows: Vec<String> = branches
        .iter()
        .map(|branch| format!(r"{} & \text{{if }} {}", to_latex(&branch.value), to_latex(&branch.condition)))
        .collect();
    rows.extend(otherwise.map(|value| format!(r"{} & \text{{otherwise}}", to_latex(value))));
    format!(r"\begin{{cases}}{}\end{{cases}}", rows.join(r" \\ "))
}

fn repetition(clauses: &[LoopClause], body: &Expr) -> String {
    let words =
        clauses.iter().map(|clause| format!(r"\text{{{} }}{}\;", clause.word.symbol(), to_latex(&clause.value)));
    format!(r"{}\text{{do }}{}", words.collect::<String>(), to_latex(body))
}
