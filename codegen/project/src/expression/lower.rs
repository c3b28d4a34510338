//! Maxima text to exact expressions: what the generator understands, and a clear word about what it does not.

use super::Expr;
use closedform_maxima::ast::{BinaryOperator, Expr as Ast, ExprKind, UnaryOperator};
use closedform_maxima::{Relation, exact};
use closedform_syntax::Function;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use std::ops::Range;
use thiserror::Error;

/// What the generator cannot read, and where it stands.
#[derive(Debug, Error, Clone, PartialEq)]
#[error("{what}")]
pub struct LowerError {
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub remedy: String,
    /// Where it stands in the text.
    pub span: Range<usize>,
}

/// The largest exponent that is worth multiplying out.
const MAX_EXPONENT: i64 = 64;

/// Everything in an expression that the generator cannot read, each with its place.
#[must_use]
pub fn lower_errors(ast: &Ast) -> Vec<LowerError> {
    let Err(error) = lower(ast) else { return Vec::new() };
    let parts: Vec<&Ast> = match &ast.kind {
        ExprKind::Unary { operand, .. } => vec![operand],
        ExprKind::Binary { left, right, .. } => vec![left, right],
        ExprKind::Call { arguments, .. } => arguments.iter().collect(),
        _ => Vec::new(),
    };
    let inside: Vec<LowerError> = parts.into_iter().flat_map(lower_errors).collect();
    if inside.is_empty() { vec![error] } else { inside }
}

/// The exact expression that a Maxima expression means.
///
/// # Errors
/// When it uses what has no exact closed form of `+ - * /`, `sqrt`, `abs` and `positive_root`.
pub fn lower(ast: &Ast) -> Result<Expr, LowerError> {
    match &ast.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) => number(ast),
        ExprKind::Symbol(name) => symbol(name, ast),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Ok(lower(operand)?.negated()),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => lower(operand),
        ExprKind::Binary { operator, left, right } => binary(*operator, left, right, ast),
        ExprKind::Call { .. } => call(ast),
        ExprKind::If { .. } => Err(unsupported(
            ast,
            "an `if`",
            "branches are not known yet: define one function for each case, each with its own domain",
        )),
        _ => Err(unsupported(ast, "this", "write a formula of + - * / ^ sqrt abs and numbers")),
    }
}

fn unsupported(ast: &Ast, what: &str, remedy: &str) -> LowerError {
    LowerError {
        what: format!("{what} has no place in a reference expression"),
        remedy: remedy.to_owned(),
        span: ast.span.clone(),
    }
}

fn number(ast: &Ast) -> Result<Expr, LowerError> {
    match exact::rational(ast) {
        Ok(value) => Ok(Expr::Rational(value)),
        Err(_) => Err(unsupported(ast, "a number out of range", "write it as a fraction of integers")),
    }
}

fn symbol(name: &str, ast: &Ast) -> Result<Expr, LowerError> {
    match name {
        "%pi" => Ok(Expr::Pi),
        _ => match remedy_of_constant(name) {
            Some(remedy) => Err(unsupported(ast, &format!("the constant `{name}`"), remedy)),
            None => Ok(Expr::symbol(name)),
        },
    }
}

/// What to do instead of writing a constant of Maxima that is no variable; none for any other name.
#[must_use]
pub fn remedy_of_constant(name: &str) -> Option<&'static str> {
    Some(match name {
        "%e" => EXPONENTIAL,
        "%i" => "kernels compute real numbers: define the real and the imaginary part as a function each",
        "%phi" => "write (1+sqrt(5))/2",
        "%gamma" | "%catalan" => "only %pi is known as a constant: write its digits",
        "inf" | "minf" | "infinity" => "let the worksheet take the limit, and write what it gives",
        "und" | "ind" => "it is no number: let the worksheet exclude it",
        _ => return None,
    })
}

/// What to do instead of a power of %e or a call of a function of its kind.
const EXPONENTIAL: &str = "powers of %e, exp, log, sin and other functions of their kind are not known yet: compute the \
                           value outside and make it an input, such as y for %e^x, or write a rational function that is \
                           near enough";

/// What to do instead of calling a function of Maxima that kernels may know one day; none for any other name.
#[must_use]
pub fn remedy_of_function(name: &str) -> Option<&'static str> {
    const FUNCTIONS: [&str; 22] = [
        "exp", "log", "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "atan2", "sinh", "cosh",
        "tanh", "asinh", "acosh", "atanh", "erf", "gamma", "floor", "mod",
    ];
    FUNCTIONS.contains(&name).then_some(EXPONENTIAL)
}

fn binary(operator: BinaryOperator, left: &Ast, right: &Ast, ast: &Ast) -> Result<Expr, LowerError> {
    match operator {
        BinaryOperator::Add => Ok(lower(left)?.plus(lower(right)?)),
        BinaryOperator::Subtract => Ok(lower(left)?.minus(lower(right)?)),
        BinaryOperator::Multiply => Ok(lower(left)?.times(lower(right)?)),
        BinaryOperator::Divide => {
            let (above, below) = (lower(left)?, lower(right)?);
            if is_zero(&below) { Err(divides_by_zero(right)) } else { Ok(above.over(below)) }
        }
        BinaryOperator::Power => power(left, right, ast),
        BinaryOperator::Compare(Relation::Equal) => {
            Err(unsupported(ast, "an equation", "name the side that is meant, for example rhs(solution)"))
        }
        _ => Err(unsupported(ast, "this operator", "write a formula of + - * / ^ and sqrt")),
    }
}

fn power(base: &Ast, exponent: &Ast, ast: &Ast) -> Result<Expr, LowerError> {
    let Some(exponent_value) = constant(&lower(exponent)?) else {
        return Err(unsupported(
            ast,
            "a power with a variable exponent",
            "only powers with constant exponents are closed forms here",
        ));
    };
    let base = lower(base)?;
    let numerator = exponent_value.numer().to_i64().filter(|n| n.abs() <= MAX_EXPONENT);
    match (numerator, exponent_value.denom().to_i64()) {
        (Some(n), _) if n < 0 && is_zero(&base) => Err(divides_by_zero(ast)),
        (Some(0), _) if is_zero(&base) => {
            Err(unsupported(ast, "0^0", "it has no value, in Maxima either: say which one is meant"))
        }
        (Some(n), Some(1)) => Ok(integer_power(base, n as i32)),
        (Some(n), Some(degree)) if let Some(root) = root(degree) => {
            // an even root comes with a power of what stands under it, so that it stands above the bar
            let whole = if degree % 2 == 0 { n.div_euclid(degree) } else { n / degree };
            let root = integer_power(called(root, base.clone(), ast)?, (n - degree * whole) as i32);
            Ok(if whole == 0 { root } else { integer_power(base, whole as i32).times(root) })
        }
        _ => Err(unsupported(
            ast,
            &format!("the exponent {exponent_value}"),
            &format!(
                "only exponents n/d with n up to {MAX_EXPONENT} and d = 1, {} are possible; give another root of a \
                 polynomial as positive_root(polynomial, x)",
                degrees()
            ),
        )),
    }
}

fn is_zero(expr: &Expr) -> bool {
    constant(expr).is_some_and(|value| value.is_zero())
}

fn divides_by_zero(divisor: &Ast) -> LowerError {
    LowerError {
        what: "it divides by zero, whatever its inputs are".to_owned(),
        remedy: "correct the divisor, or leave the term out".to_owned(),
        span: divisor.span.clone(),
    }
}

/// The function of an argument; of a number that is not in its domain there is none.
fn called(function: Function, argument: Expr, ast: &Ast) -> Result<Expr, LowerError> {
    let sign = constant(&argument).map(|value| value.cmp(&BigRational::zero()));
    match sign.map(|sign| function.sign(sign)) {
        Some(None) => Err(LowerError {
            what: "it takes the square root of a negative number, whatever its inputs are".to_owned(),
            remedy: "correct the radicand: kernels compute real numbers".to_owned(),
            span: ast.span.clone(),
        }),
        _ => Ok(Expr::call(function, argument)),
    }
}

/// The root of this degree, if the table has it.
fn root(degree: i64) -> Option<Function> {
    u32::try_from(degree).ok().and_then(Function::root)
}

/// The degrees of the roots of the table, as a list.
fn degrees() -> String {
    let degrees = Function::ALL.into_iter().filter_map(Function::degree);
    degrees.map(|degree| degree.to_string()).collect::<Vec<_>>().join(", ")
}

fn integer_power(base: Expr, exponent: i32) -> Expr {
    match exponent {
        0 => Expr::integer(1),
        1 => base,
        _ => Expr::Power(Box::new(base), exponent),
    }
}

/// The value of an expression without variables, if it is rational.
fn constant(expr: &Expr) -> Option<BigRational> {
    match expr {
        Expr::Rational(value) => Some(value.clone()),
        Expr::Sum(items) => items.iter().map(constant).sum(),
        Expr::Product(items) => items.iter().map(constant).product(),
        Expr::Power(base, exponent) => {
            let base = constant(base).filter(|b| !b.is_zero() || exponent.is_positive())?;
            Some(base.pow(*exponent))
        }
        _ => None,
    }
}

/// Whether a function has a meaning of its own in a reference expression.
#[must_use]
pub fn is_known_function(name: &str) -> bool {
    Function::in_worksheets(name).is_some() || ["max", "min", "positive_root"].contains(&name)
}

/// How the functions that may stand in a reference expression are written, but for `positive_root`.
#[must_use]
pub fn known_functions() -> String {
    let of_table = Function::ALL.map(|function| function.properties().maxima).join(", ");
    format!("{of_table}, max(x, y, ..), min(x, y, ..)")
}

/// What is said before the name of a function that is not known.
pub const UNKNOWN_FUNCTION: &str = "unknown function ";

fn call(ast: &Ast) -> Result<Expr, LowerError> {
    let Some((name, arguments)) = ast.as_call() else {
        return Err(unsupported(ast, "this call", "write a formula of + - * / ^ sqrt abs and numbers"));
    };
    if let (Some(function), [argument]) = (Function::in_worksheets(name), arguments) {
        return called(function, lower(argument)?, ast);
    }
    match (name, arguments) {
        ("max" | "min", [_, _, ..]) => {
            let items = arguments.iter().map(lower).collect::<Result<_, _>>()?;
            Ok(Expr::Extreme { largest: name == "max", items })
        }
        ("positive_root", [polynomial, unknown]) => match unknown.as_symbol() {
            Some(unknown) => {
                Ok(Expr::PositiveRoot { polynomial: Box::new(lower(polynomial)?), unknown: unknown.to_owned() })
            }
            None => Err(unsupported(unknown, "an unknown that is no variable", "write positive_root(polynomial, x)")),
        },
        _ if is_known_function(name) => Err(LowerError {
            what: format!("`{name}` has {} arguments", arguments.len()),
            remedy: format!("write {} or positive_root(polynomial, x)", known_functions()),
            span: ast.span.clone(),
        }),
        _ => Err(LowerError {
            what: format!("{UNKNOWN_FUNCTION}`{name}`"),
            remedy: format!(
                "known are {} and positive_root(polynomial, x); define any other function in the worksheet",
                known_functions()
            ),
            span: ast.span.clone(),
        }),
    }
}
