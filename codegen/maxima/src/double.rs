//! Expressions to doubles: the plain evaluation of a formula as it is written, and what that costs.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use crate::ast::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use crate::exact;

/// How many operations a formula takes as it is written; signs and magnitudes are free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DoubleOperations {
    /// Additions and subtractions.
    pub add: u32,
    /// Multiplications.
    pub mul: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots.
    pub sqrt: u32,
    /// Real cube roots.
    pub cbrt: u32,
}

/// The value in double precision, every operation rounded once, in the order of the text; `values` are those of `names`.
///
/// Integer powers are products, by repeated squaring; halves and thirds of powers are powers of a root. `None` where the
/// formula has another function than `sqrt` and `abs`, or something else than numbers, names and `+ - * / ^`.
#[must_use]
pub fn evaluate_double(formula: &Expr, names: &[impl AsRef<str>], values: &[f64]) -> Option<f64> {
    let name =
        |name: &str| names.iter().position(|known| known.as_ref() == name).and_then(|at| values.get(at).copied());
    fold(formula, &Rounded(&name))
}

/// The operations that [`evaluate_double`] takes; `None` where it has no value for any input.
#[must_use]
pub fn double_operations(formula: &Expr) -> Option<DoubleOperations> {
    fold(formula, &Counted)
}

/// What a formula is folded into.
pub(crate) trait Arithmetic {
    type Value: Clone;

    fn number(&self, value: f64) -> Self::Value;
    fn name(&self, name: &str) -> Option<Self::Value>;
    fn neg(&self, a: Self::Value) -> Self::Value;
    fn abs(&self, a: Self::Value) -> Self::Value;
    fn sqrt(&self, a: Self::Value) -> Self::Value;
    fn cbrt(&self, a: Self::Value) -> Self::Value;
    fn add(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn sub(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn mul(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn div(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// `a^count`, where `count` is not zero.
    fn power(&self, a: Self::Value, count: u32) -> Self::Value;
}

pub(crate) fn fold<A: Arithmetic>(formula: &Expr, arithmetic: &A) -> Option<A::Value> {
    let part = |part: &Expr| fold(part, arithmetic);
    Some(match &formula.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) => {
            arithmetic.number(exact::rational(formula).ok()?.to_f64()?)
        }
        ExprKind::Symbol(name) if name == "%pi" => arithmetic.number(std::f64::consts::PI),
        ExprKind::Symbol(name) => arithmetic.name(name)?,
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => part(operand)?,
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => arithmetic.neg(part(operand)?),
        ExprKind::Binary { operator: BinaryOperator::Add, left, right } => arithmetic.add(part(left)?, part(right)?),
        ExprKind::Binary { operator: BinaryOperator::Subtract, left, right } => {
            arithmetic.sub(part(left)?, part(right)?)
        }
        ExprKind::Binary { operator: BinaryOperator::Multiply, left, right } => {
            arithmetic.mul(part(left)?, part(right)?)
        }
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right } => arithmetic.div(part(left)?, part(right)?),
        ExprKind::Binary { operator: BinaryOperator::Power, left, right } => {
            power(arithmetic, part(left)?, &exponent(right)?)?
        }
        _ => match formula.as_call()? {
            ("sqrt", [argument]) => arithmetic.sqrt(part(argument)?),
            ("abs", [argument]) => arithmetic.abs(part(argument)?),
            _ => return None,
        },
    })
}

/// An exponent that is written with integers, signs and quotients only.
fn exponent(formula: &Expr) -> Option<BigRational> {
    match &formula.kind {
        ExprKind::Integer(value) => Some(BigRational::from_integer(value.clone())),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(-exponent(operand)?),
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right } => {
            let divisor = exponent(right).filter(|divisor| divisor.numer() != &BigInt::ZERO)?;
            Some(exponent(left)? / divisor)
        }
        _ => None,
    }
}

fn power<A: Arithmetic>(arithmetic: &A, base: A::Value, exponent: &BigRational) -> Option<A::Value> {
    let base = match exponent.denom().to_u32()? {
        1 => base,
        2 => arithmetic.sqrt(base),
        3 => arithmetic.cbrt(base),
        _ => return None,
    };
    let count = exponent.numer().abs().to_u32()?;
    let product = if count == 0 { arithmetic.number(1.0) } else { arithmetic.power(base, count) };
    let inverted = exponent.is_negative();
    Some(if inverted { arithmetic.div(arithmetic.number(1.0), product) } else { product })
}

/// Doubles, each operation rounded.
struct Rounded<'a>(&'a dyn Fn(&str) -> Option<f64>);

impl Arithmetic for Rounded<'_> {
    type Value = f64;

    fn number(&self, value: f64) -> f64 {
        value
    }

    fn name(&self, name: &str) -> Option<f64> {
        (self.0)(name)
    }

    fn neg(&self, a: f64) -> f64 {
        -a
    }

    fn abs(&self, a: f64) -> f64 {
        a.abs()
    }

    fn sqrt(&self, a: f64) -> f64 {
        a.sqrt()
    }

    /// Not that of the standard library, which differs between systems.
    fn cbrt(&self, a: f64) -> f64 {
        libm::cbrt(a)
    }

    fn add(&self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn sub(&self, a: f64, b: f64) -> f64 {
        a - b
    }

    fn mul(&self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&self, a: f64, b: f64) -> f64 {
        a / b
    }

    /// By repeated squaring, from the leading bit of `count`.
    fn power(&self, a: f64, count: u32) -> f64 {
        (0..count.ilog2()).rev().fold(a, |power, bit| {
            let square = power * power;
            if count >> bit & 1 == 1 { square * a } else { square }
        })
    }
}

/// Operations so far.
struct Counted;

impl Counted {
    fn both(a: DoubleOperations, b: DoubleOperations) -> DoubleOperations {
        DoubleOperations {
            add: a.add + b.add,
            mul: a.mul + b.mul,
            div: a.div + b.div,
            sqrt: a.sqrt + b.sqrt,
            cbrt: a.cbrt + b.cbrt,
        }
    }
}

impl Arithmetic for Counted {
    type Value = DoubleOperations;

    fn number(&self, _: f64) -> DoubleOperations {
        DoubleOperations::default()
    }

    fn name(&self, _: &str) -> Option<DoubleOperations> {
        Some(DoubleOperations::default())
    }

    fn neg(&self, a: DoubleOperations) -> DoubleOperations {
        a
    }

    fn abs(&self, a: DoubleOperations) -> DoubleOperations {
        a
    }

    fn sqrt(&self, a: DoubleOperations) -> DoubleOperations {
        DoubleOperations { sqrt: a.sqrt + 1, ..a }
    }

    fn cbrt(&self, a: DoubleOperations) -> DoubleOperations {
        DoubleOperations { cbrt: a.cbrt + 1, ..a }
    }

    fn add(&self, a: DoubleOperations, b: DoubleOperations) -> DoubleOperations {
        let both = Self::both(a, b);
        DoubleOperations { add: both.add + 1, ..both }
    }

    fn sub(&self, a: DoubleOperations, b: DoubleOperations) -> DoubleOperations {
        self.add(a, b)
    }

    fn mul(&self, a: DoubleOperations, b: DoubleOperations) -> DoubleOperations {
        let both = Self::both(a, b);
        DoubleOperations { mul: both.mul + 1, ..both }
    }

    fn div(&self, a: DoubleOperations, b: DoubleOperations) -> DoubleOperations {
        let both = Self::both(a, b);
        DoubleOperations { div: both.div + 1, ..both }
    }

    /// A square a bit, and one more product for each that is set.
    fn power(&self, a: DoubleOperations, count: u32) -> DoubleOperations {
        DoubleOperations { mul: a.mul + count.ilog2() + count.count_ones() - 1, ..a }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse_expression;

    fn value(text: &str, x: f64) -> Option<f64> {
        evaluate_double(&parse_expression(text).unwrap(), &["x"], &[x])
    }

    #[test]
    fn every_operation_rounds_once() {
        assert_eq!(value("1/3*x", 3.0), Some(1.0 / 3.0 * 3.0));
        assert_eq!(value("x+1-x", 1e16), Some(0.0));
        assert_eq!(value("-x^3", 1.1), Some(-(1.1 * 1.1 * 1.1)));
        assert_eq!(value("x^(3/2)", 4.0), Some(8.0));
        assert_eq!(value("x^-2", 3.0), Some(1.0 / 9.0));
        assert_eq!(value("sqrt(abs(x))", -2.0), Some(2.0_f64.sqrt()));
        assert_eq!(value("0.1*%pi", 0.0), Some(0.1 * std::f64::consts::PI));
        assert_eq!(value("x^(2/3)", -8.0), Some(4.0));
        assert_eq!(value("x^(-1/3)", -8.0), Some(-0.5));
        assert!(value("sqrt(x)", -1.0).is_some_and(f64::is_nan));
    }

    #[test]
    fn what_is_no_plain_formula_has_no_value() {
        for text in ["y", "sin(x)", "x^x", "x^(1/5)", "positive_root(z^2-x,z)", "x < 1"] {
            assert_eq!(value(text, 2.0), None, "{text}");
        }
    }

    #[test]
    fn operations_are_counted_as_written() {
        let count = |text: &str| double_operations(&parse_expression(text).unwrap());
        let [add, mul, div, sqrt, cbrt] = [3, 5, 2, 1, 1];
        let expected = Some(DoubleOperations { add, mul, div, sqrt, cbrt });
        assert_eq!(count("-(a+b)^5*c/d - x^(2/3) + sqrt(1/x)"), expected);
        assert_eq!(count("sin(x)"), None);
    }
}
