//! Closed forms whose parts are not real although their value is: roots by radicals, in complex MPFR numbers.

use std::collections::BTreeMap;

use closedform_maxima::ast::BinaryOperator as Operator;
use closedform_maxima::{Expr, ExprKind, UnaryOperator};
use rug::Float;

use crate::rational::{self, Names};

/// A complex number; its parts have one precision.
#[derive(Clone, Debug)]
struct Complex {
    real: Float,
    imaginary: Float,
}

/// The value of an expression that is real, roots and powers taken on their principal branches as Maxima takes them;
/// none where it is not real, or divides by zero, or has something else than sums, products, roots and powers.
pub fn real_value(expression: &Expr, names: &BTreeMap<String, Float>, precision: u32) -> Option<Float> {
    let value = value(expression, names, precision)?;
    value.imaginary.is_zero().then_some(value.real)
}

fn value(expression: &Expr, names: &BTreeMap<String, Float>, precision: u32) -> Option<Complex> {
    let inside = |part: &Expr| value(part, names, precision);
    match &expression.kind {
        ExprKind::Symbol(name) => Some(Complex::real(Float::with_val(precision, names.get(name)?))),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => Some(inside(operand)?.negative()),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => inside(operand),
        ExprKind::Binary { operator, left, right } => match operator {
            Operator::Add => Some(inside(left)?.plus(&inside(right)?)),
            Operator::Subtract => Some(inside(left)?.plus(&inside(right)?.negative())),
            Operator::Multiply => Some(inside(left)?.times(&inside(right)?)),
            Operator::Divide => Some(inside(left)?.times(&inside(right)?.inverse()?)),
            Operator::Power => inside(left)?.power(&constant(right, precision)?),
            _ => None,
        },
        ExprKind::Call { .. } => match expression.as_call()? {
            ("sqrt", [argument]) => inside(argument)?.power(&Float::with_val(precision, 0.5)),
            _ => None,
        },
        _ => constant(expression, precision).map(Complex::real),
    }
}

/// The value of a rational number.
fn constant(expression: &Expr, precision: u32) -> Option<Float> {
    Some(Float::with_val(precision, rational::value(expression, &Names::new())?))
}

impl Complex {
    fn real(real: Float) -> Self {
        let imaginary = Float::new(real.prec());
        Complex { real, imaginary }
    }

    /// The number, its parts rid of noise: one that is far below the other is 0, and 0 is not negative.
    fn clean(real: Float, imaginary: Float) -> Self {
        let zero = Float::new(real.prec());
        let is_noise = |part: &Float, other: &Float| {
            part.is_zero() || Float::with_val(part.prec(), part.abs_ref()) < other.clone().abs() >> (part.prec() / 2)
        };
        match (is_noise(&real, &imaginary), is_noise(&imaginary, &real)) {
            (_, true) => Complex { real, imaginary: zero },
            (true, false) => Complex { real: zero, imaginary },
            (false, false) => Complex { real, imaginary },
        }
    }

    fn negative(self) -> Self {
        Self::clean(-self.real, -self.imaginary)
    }

    fn plus(self, other: &Self) -> Self {
        Self::clean(self.real + &other.real, self.imaginary + &other.imaginary)
    }

    fn times(self, other: &Self) -> Self {
        let real = self.real.clone() * &other.real - self.imaginary.clone() * &other.imaginary;
        Self::clean(real, self.real * &other.imaginary + self.imaginary * &other.real)
    }

    fn inverse(self) -> Option<Self> {
        let square = self.real.clone().square() + self.imaginary.clone().square();
        (!square.is_zero()).then(|| Self::clean(self.real / &square, -self.imaginary / &square))
    }

    fn power(self, exponent: &Float) -> Option<Self> {
        let magnitude = self.real.clone().hypot(&self.imaginary);
        if magnitude.is_zero() {
            return exponent.is_sign_positive().then_some(self);
        }
        let angle = self.imaginary.atan2(&self.real) * exponent;
        let (sine, cosine) = angle.sin_cos(Float::new(exponent.prec()));
        let magnitude = (magnitude.ln() * exponent).exp();
        Some(Self::clean(cosine * &magnitude, sine * magnitude))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_maxima::parse_expression;

    fn real(text: &str, x: f64) -> Option<f64> {
        let names = BTreeMap::from([("x".to_owned(), Float::with_val(256, x))]);
        real_value(&parse_expression(text).expect("it parses"), &names, 256).map(|value| value.to_f64())
    }

    #[test]
    fn values_may_be_real_where_their_parts_are_not() {
        assert_eq!(real("sqrt(-x)^2+x/2", 3.0), Some(-1.5));
        assert_eq!(real("sqrt(x)", -1.0), None);
        assert_eq!(real("1/(x-1)", 1.0), None);
        // Three real roots of t^3 = 3*t + x by radicals: 2 of x = 2, and 2*cos(20 degrees) of x = 1.
        let root = "(x/2+sqrt(x^2/4-1))^(1/3)+1/(x/2+sqrt(x^2/4-1))^(1/3)";
        assert_eq!(real(root, 2.0), Some(2.0));
        assert_eq!(real(root, 1.0), Some(2.0 * (std::f64::consts::PI / 9.0).cos()));
    }
}
