//! Numbers of FPCore as Maxima's: whole, decimal, hexadecimal, fractions, and digits with an exponent.

use closedform_maxima::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

/// The largest exponent that is written out: beyond all doubles.
const LARGEST_EXPONENT: u32 = 5_000;

/// How many letters a number has at most.
const LONGEST: usize = 2_000;

/// The number that a text is, if it is one.
pub(super) fn number(text: &str) -> Option<ExprKind> {
    if text.len() > LONGEST {
        return None;
    }
    let (negative, rest) = match text.as_bytes().first()? {
        b'-' => (true, &text[1..]),
        b'+' => (false, &text[1..]),
        _ => (false, text),
    };
    let value = decimal(rest).or_else(|| fraction(rest)).or_else(|| hexadecimal(rest))?;
    Some(if negative {
        ExprKind::Unary { operator: UnaryOperator::Minus, operand: Box::new(value.into()) }
    } else {
        value
    })
}

/// `(digits mantissa exponent base)`.
pub(super) fn digits(mantissa: &str, exponent: &str, base: &str) -> Option<ExprKind> {
    let base: BigInt = base.parse().ok().filter(|base: &BigInt| base.is_positive())?;
    if mantissa.len() > LONGEST || base.bits() > 64 {
        return None;
    }
    Some(exact(scaled(mantissa.parse().ok()?, &base, exponent.parse().ok()?)?))
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// `12`, `1.5`, `.5`, `1e-3`.
fn decimal(text: &str) -> Option<ExprKind> {
    if is_digits(text) {
        return text.parse().ok().map(ExprKind::Integer);
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let fits =
        is_digits(exponent.strip_prefix(['-', '+']).unwrap_or(exponent)) && is_digits(&mantissa.replacen('.', "", 1));
    fits.then(|| ExprKind::Float(text.to_ascii_lowercase()))
}

/// `1/3`.
fn fraction(text: &str) -> Option<ExprKind> {
    let (above, below) = text.split_once('/').filter(|(above, below)| is_digits(above) && is_digits(below))?;
    let divisor: BigInt = below.parse().ok()?;
    Some(divided(above.parse().ok()?, divisor))
}

/// `0x1.8p-3`.
fn hexadecimal(text: &str) -> Option<ExprKind> {
    let text = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    let (mantissa, exponent) = text.split_once(['p', 'P']).unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{part}");
    let digits =
        BigInt::parse_bytes(all.as_bytes(), 16).filter(|_| all.bytes().all(|byte| byte.is_ascii_hexdigit()))?;
    let shift = 4 * i64::try_from(part.len()).ok()?;
    let exponent: i64 = exponent.parse().ok()?;
    Some(exact(scaled(digits, &BigInt::from(2), exponent.checked_sub(shift)?)?))
}

fn scaled(mantissa: BigInt, base: &BigInt, exponent: i64) -> Option<BigRational> {
    let size = u32::try_from(exponent.unsigned_abs()).ok().filter(|size| *size <= LARGEST_EXPONENT)?;
    let power = base.pow(size);
    Some(if exponent < 0 { BigRational::new(mantissa, power) } else { (mantissa * power).into() })
}

/// A number as Maxima writes it.
fn exact(value: BigRational) -> ExprKind {
    let (above, below) = (value.numer().abs(), value.denom().clone());
    let positive = if below.is_one() { ExprKind::Integer(above) } else { divided(above, below) };
    match value.is_negative() {
        true => ExprKind::Unary { operator: UnaryOperator::Minus, operand: Box::new(positive.into()) },
        false => positive,
    }
}

fn divided(above: BigInt, below: BigInt) -> ExprKind {
    let [left, right] = [above, below].map(|number| Box::new(Expr::from(ExprKind::Integer(number))));
    ExprKind::Binary { operator: BinaryOperator::Divide, left, right }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn printed(kind: ExprKind) -> String {
        closedform_maxima::print(&kind.into())
    }

    #[test]
    fn every_spelling_of_a_number_is_read() {
        for (text, maxima) in [
            ("12", "12"),
            ("-12", "-12"),
            ("+1.5", "1.5"),
            (".5", ".5"),
            ("-1E-3", "-1e-3"),
            ("1/3", "1/3"),
            ("-2/6", "-(2/6)"),
            ("0x1.8p3", "12"),
            ("-0x.8", "-(1/2)"),
            ("0x10", "16"),
        ] {
            assert_eq!(number(text).map(printed).as_deref(), Some(maxima), "{text}");
        }
        for text in ["x", "-", "", "1.2.3", "1e", "0x", "1/x", "e5", "0x1p99999", "--1", "0x-1", "."] {
            assert_eq!(number(text), None, "{text}");
        }
        assert_eq!(digits("3", "-2", "2").map(printed).as_deref(), Some("3/4"));
        assert_eq!(digits("-3", "2", "10").map(printed).as_deref(), Some("-300"));
        assert_eq!(digits("3", "2", "0"), None);
    }
}
