//! Maxima text to exact expressions: what the generator understands, and a clear word about what it does not.

use super::choice::{atan2, signum};
use super::tree::{Expr, Test};
use closedform_maxima::ast::{BinaryOperator, Branch, Expr as Ast, ExprKind, UnaryOperator};
use closedform_maxima::{Relation, exact};
use closedform_syntax::{Function, FunctionDomain};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
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
        ExprKind::If { branches, otherwise } => {
            branches.iter().map(|branch| &branch.value).chain(otherwise.as_deref()).collect()
        }
        _ => Vec::new(),
    };
    let mut inside: Vec<LowerError> = parts.into_iter().flat_map(lower_errors).collect();
    if ast.as_call().is_some_and(|(name, _)| !is_known_function(name)) {
        // what a function takes that is not known may be no number
        inside.retain(|error| error.what.starts_with(UNKNOWN_FUNCTION));
    }
    if inside.is_empty() { vec![error] } else { inside }
}

/// The exact expression that a Maxima expression means.
///
/// # Errors
/// When it uses what is no formula of `+ - * / ^`, the functions of the table and what is made of them.
pub fn lower(ast: &Ast) -> Result<Expr, LowerError> {
    match &ast.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) => number(ast),
        ExprKind::Symbol(name) => symbol(name, ast),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Ok(lower(operand)?.negated()),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => lower(operand),
        ExprKind::Binary { operator, left, right } => binary(*operator, left, right, ast),
        ExprKind::Call { .. } => call(ast),
        ExprKind::If { branches, otherwise } => choice(branches, otherwise.as_deref(), ast),
        _ => Err(unsupported(ast, "this", "write a formula of + - * / ^ sqrt abs and numbers")),
    }
}

/// The value of the first branch whose condition holds, else of `otherwise`.
fn choice(branches: &[Branch], otherwise: Option<&Ast>, ast: &Ast) -> Result<Expr, LowerError> {
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
        "%e" => Ok(Expr::call(Function::Exp, Expr::integer(1))),
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
        "%i" => "kernels compute real numbers: define the real and the imaginary part as a function each",
        "%phi" => "write (1+sqrt(5))/2",
        "%gamma" | "%catalan" => "only %pi is known as a constant: write its digits",
        "inf" | "minf" | "infinity" => "let the worksheet take the limit, and write what it gives",
        "und" | "ind" => "it is no number: let the worksheet exclude it",
        _ => return None,
    })
}

/// Whether a name is a constant that kernels know.
#[must_use]
pub fn is_known_constant(name: &str) -> bool {
    ["%pi", "%e"].contains(&name)
}

/// What to do instead of a call of a function that kernels do not know yet.
const NOT_YET: &str = "this function is not known yet: compute its value outside and make it an input";

/// What to do instead of calling a function of Maxima that kernels may know one day; none for any other name.
#[must_use]
pub fn remedy_of_function(name: &str) -> Option<&'static str> {
    const FUNCTIONS: [&str; 2] = ["erf", "gamma"];
    FUNCTIONS.contains(&name).then_some(NOT_YET)
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
    let exponent = lower(exponent)?;
    if base.as_symbol() == Some("%e") {
        return called(Function::Exp, exponent, ast);
    }
    let base = lower(base)?;
    let Some(exponent_value) = constant(&exponent) else { return positive_power(base, exponent, ast) };
    let numerator = exponent_value.numer().to_i64();
    match (numerator.filter(|_| is_of_roots(&exponent_value)), exponent_value.denom().to_i64()) {
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
        _ => positive_power(base, exponent, ast),
    }
}

/// Whether a power with this exponent is made of products and roots, so that its base may have any sign that these allow.
#[must_use]
pub fn is_of_roots(exponent: &BigRational) -> bool {
    let is_small = exponent.numer().to_i64().is_some_and(|n| n.abs() <= MAX_EXPONENT);
    is_small && exponent.denom().to_i64().is_some_and(|degree| degree == 1 || root(degree).is_some())
}

/// A power whose exponent is no number, or neither a small integer nor that of a root: of positive numbers only.
fn positive_power(base: Expr, exponent: Expr, ast: &Ast) -> Result<Expr, LowerError> {
    match constant(&base) {
        Some(value) if !value.is_positive() => Err(unsupported(
            ast,
            &format!("such a power of {value}"),
            "powers with exponents that are neither small integers nor n/2 or n/3 are those of positive numbers",
        )),
        _ => Ok(power_of_positive(base, exponent)),
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
    let Some(value) = constant(&argument) else { return Ok(Expr::call(function, argument)) };
    let holds = match function.properties().domain {
        FunctionDomain::All => true,
        FunctionDomain::NotNegative => !value.is_negative(),
        FunctionDomain::Positive => value.is_positive(),
        FunctionDomain::Unit => value.abs() <= BigRational::one(),
    };
    match exact_value(function, &value) {
        _ if !holds => Err(LowerError {
            what: format!("it takes the {} of {value}, whatever its inputs are", function.properties().noun),
            remedy: "correct the argument: kernels compute real numbers".to_owned(),
            span: ast.span.clone(),
        }),
        Some(exact) => Ok(Expr::Rational(exact.into())),
        None => Ok(Expr::call(function, argument)),
    }
}

/// The root of this degree, if the table has it.
fn root(degree: i64) -> Option<Function> {
    u32::try_from(degree).ok().and_then(Function::root)
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

/// The function of the table that worksheets call so: `entier` is another name of `floor`.
fn in_worksheets(name: &str) -> Option<Function> {
    Function::in_worksheets(if name == "entier" { "floor" } else { name })
}

/// Whether a name is that of a function of one number.
#[must_use]
pub fn is_function_of_one(name: &str) -> bool {
    in_worksheets(name).is_some() || COMPOSED.contains(&name)
}

/// Whether a function has a meaning of its own in a reference expression.
#[must_use]
pub fn is_known_function(name: &str) -> bool {
    is_function_of_one(name) || ["atan2", "max", "min", "mod", "positive_root"].contains(&name)
}

/// How the functions that may stand in a reference expression are written, but for `positive_root`.
#[must_use]
pub fn known_functions() -> String {
    let of_table = Function::ALL.map(|function| function.properties().maxima).join(", ");
    let composed = COMPOSED.map(|name| format!("{name}(x)")).join(", ");
    format!("{of_table}, {composed}, atan2(y, x), max(x, y, ..), min(x, y, ..), mod(x, y)")
}

/// What is said before the name of a function that is not known.
pub const UNKNOWN_FUNCTION: &str = "unknown function ";

fn call(ast: &Ast) -> Result<Expr, LowerError> {
    let Some((name, arguments)) = ast.as_call() else {
        return Err(unsupported(ast, "this call", "write a formula of + - * / ^ sqrt abs and numbers"));
    };
    if let (Some(function), [argument]) = (in_worksheets(name), arguments) {
        return called(function, lower(argument)?, ast);
    }
    if let [argument] = arguments
        && let Some(value) = composed(name, lower(argument)?)
    {
        return Ok(value);
    }
    match (name, arguments) {
        ("max" | "min", [_, _, ..]) => {
            let items = arguments.iter().map(lower).collect::<Result<_, _>>()?;
            Ok(Expr::Extreme { largest: name == "max", items })
        }
        ("atan2", [y, x]) => Ok(atan2(lower(y)?, lower(x)?)),
        ("mod", [x, y]) => remainder(lower(x)?, lower(y)?, y),
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

/// The functions that are made of others.
const COMPOSED: [&str; 10] = ["sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "cot", "sec", "csc", "signum"];

/// One of the [composed](COMPOSED) functions of an expression.
fn composed(name: &str, x: Expr) -> Option<Expr> {
    let call = |function, argument: Expr| Expr::call(function, argument);
    let one = || Expr::integer(1);
    let halved = |whole: Expr| whole.over(Expr::integer(2));
    let with_square = |x: Expr, sum: fn(Expr, Expr) -> Expr| {
        let root = Expr::call(Function::Sqrt, sum(Expr::Power(Box::new(x.clone()), 2), Expr::integer(1)));
        Expr::call(Function::Log, x.plus(root))
    };
    Some(match name {
        "sinh" => halved(call(Function::Exp, x.clone()).minus(call(Function::Exp, x.negated()))),
        "cosh" => halved(call(Function::Exp, x.clone()).plus(call(Function::Exp, x.negated()))),
        // of -2 |x| it would never overflow, but its sign would have to be chosen
        "tanh" => {
            let power = call(Function::Exp, Expr::integer(2).times(x));
            power.clone().minus(one()).over(power.plus(one()))
        }
        "asinh" => with_square(x, Expr::plus),
        "acosh" => with_square(x, Expr::minus),
        "atanh" => halved(call(Function::Log, one().plus(x.clone()).over(one().minus(x)))),
        "cot" => call(Function::Cos, x.clone()).over(call(Function::Sin, x)),
        "sec" => one().over(call(Function::Cos, x)),
        "csc" => one().over(call(Function::Sin, x)),
        "signum" => signum(x),
        _ => return None,
    })
}

/// `mod(x, y)`: what `y` leaves of `x`, `x - y*floor(x/y)`. Of no `y` that is 0, for which Maxima gives `x`: kernels divide.
fn remainder(x: Expr, y: Expr, divisor: &Ast) -> Result<Expr, LowerError> {
    if is_zero(&y) {
        return Err(divides_by_zero(divisor));
    }
    let whole = called(Function::Floor, x.clone().over(y.clone()), divisor)?;
    Ok(x.minus(y.times(whole)))
}

/// A power of a positive number: `exp(exponent * log(base))`.
fn power_of_positive(base: Expr, exponent: Expr) -> Expr {
    Expr::call(Function::Exp, exponent.times(Expr::call(Function::Log, base)))
}

/// The value of a function at a number where it is one; that of a root is found by the algebra.
fn exact_value(function: Function, argument: &BigRational) -> Option<BigInt> {
    let is = |number: i64| *argument == BigRational::from_integer(number.into());
    match function {
        Function::Exp | Function::Cos if is(0) => Some(1.into()),
        Function::Log | Function::Acos if is(1) => Some(0.into()),
        Function::Sin | Function::Tan | Function::Asin | Function::Atan if is(0) => Some(0.into()),
        Function::Floor => Some(argument.floor().to_integer()),
        Function::Ceiling => Some(argument.ceil().to_integer()),
        Function::Round => Some(nearest_integer(argument)),
        Function::Truncate => Some(argument.to_integer()),
        _ => None,
    }
}

/// The nearest integer; of two that are as near, the even one.
fn nearest_integer(value: &BigRational) -> BigInt {
    let half = BigRational::new(1.into(), 2.into());
    let up = (value + &half).floor();
    let is_in_the_middle = &up - value == half;
    let nearest = up.to_integer();
    if is_in_the_middle && nearest.bit(0) { nearest - 1 } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::parse_expression;

    fn lowered(text: &str) -> Result<Expr, LowerError> {
        lower(&parse_expression(text).unwrap())
    }

    #[test]
    fn integers_of_numbers_are_exact() {
        for (text, value) in [
            ("floor(-5/2)", -3),
            ("ceiling(-5/2)", -2),
            ("truncate(-5/2)", -2),
            ("round(-5/2)", -2),
            ("round(-3/2)", -2),
            ("round(1/2)", 0),
            ("round(3/2)", 2),
            ("round(0.7)", 1),
            ("entier(7/2)+floor(3*(1/3))", 4),
            ("mod(-7,3)", 2),
            ("mod(7,-3)", -2),
        ] {
            let value = BigRational::from_integer(value.into());
            assert_eq!(constant(&lowered(text).unwrap()), Some(value), "{text}");
        }
    }

    #[test]
    fn remainders_and_integers_of_inputs_are_calls() {
        let (x, y) = (Expr::symbol("x"), Expr::symbol("y"));
        let floor = Expr::call(Function::Floor, x.clone().over(y.clone()));
        assert_eq!(lowered("mod(x,y)"), Ok(x.clone().minus(y.times(floor))));
        assert_eq!(lowered("entier(x)"), lowered("floor(x)"));
        assert_eq!(lowered("floor(x)").unwrap().derivative("x"), None);
        for (name, function) in
            [("ceiling", Function::Ceiling), ("round", Function::Round), ("truncate", Function::Truncate)]
        {
            assert_eq!(lowered(&format!("{name}(x)")), Ok(Expr::call(function, x.clone())));
        }
    }

    #[test]
    fn what_is_left_by_zero_is_refused() {
        for text in ["mod(x,0)", "mod(x,1-1)"] {
            assert!(lowered(text).unwrap_err().what.contains("divides by zero"), "{text}");
        }
        assert!(lowered("mod(x)").unwrap_err().what.contains("`mod` has 1 arguments"));
    }

    #[test]
    fn branches_are_choices_in_choices() {
        let nested = lowered("if a<b then x else (if not (c=d) or e#x then y else z)").unwrap();
        assert_eq!(lowered("if a<b then x elseif not (c=d) or e#x then y else z").unwrap(), nested);
        assert_eq!(nested.symbols().into_iter().collect::<String>(), "abcdexyz");
        assert_eq!(lowered("signum(x)").unwrap(), lowered("if x>0 then 1 elseif x<0 then -1 else 0").unwrap());
    }

    #[test]
    fn what_is_no_choice_between_numbers_is_refused() {
        let told = |text: &str| lowered(text).unwrap_err().what;
        assert!(told("if a<b then x").contains("without `else`"));
        assert!(told("if f(a) then x else y").contains("such a condition"));
        assert!(told("if a<b then erf(x) else y").contains("erf"));
    }
}
