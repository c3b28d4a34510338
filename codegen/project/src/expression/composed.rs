//! Functions of worksheets that are made of those of the table, and powers that are no roots.

use super::Expr;
use closedform_syntax::Function;
use num_rational::BigRational;

/// The functions that are made of others.
pub(super) const COMPOSED: [&str; 9] = ["sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "cot", "sec", "csc"];

/// One of the [composed](COMPOSED) functions of an expression.
pub(super) fn composed(name: &str, x: Expr) -> Option<Expr> {
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
        _ => return None,
    })
}

/// A power of a positive number: `exp(exponent * log(base))`.
pub(super) fn power(base: Expr, exponent: Expr) -> Expr {
    Expr::call(Function::Exp, exponent.times(Expr::call(Function::Log, base)))
}

/// The value of a function at a number where it is one; that of a root is found by the algebra.
pub(super) fn value(function: Function, argument: &BigRational) -> Option<i64> {
    let is = |number: i64| *argument == BigRational::from_integer(number.into());
    match function {
        Function::Exp | Function::Cos if is(0) => Some(1),
        Function::Log | Function::Acos if is(1) => Some(0),
        Function::Sin | Function::Tan | Function::Asin | Function::Atan if is(0) => Some(0),
        _ => None,
    }
}
