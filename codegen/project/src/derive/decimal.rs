//! Decimal numbers with more digits than any float has.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// The digits of a golden value.
const DIGITS: usize = 40;

/// The largest power of ten that is computed with.
const EXPONENT_LIMIT: i64 = 10_000;

/// A number as Maxima prints it, `-1.25b-3`, rounded to 40 digits: `-1.25e-3`.
pub(super) fn round(text: &str) -> Option<String> {
    let (digits, exponent) = parse(text)?;
    let spelt = digits.abs().to_string();
    let dropped = spelt.len().saturating_sub(DIGITS);
    let unit = BigInt::from(10).pow(u32::try_from(dropped).ok()?);
    let kept: BigInt = (digits.abs() * 2 + &unit) / (unit * 2);
    let kept = kept.to_string();
    let exponent = exponent + dropped as i64 + kept.len() as i64 - 1;
    let (first, rest) = kept.split_at(1);
    let rest = rest.trim_end_matches('0');
    let (sign, point) = (if digits.is_negative() { "-" } else { "" }, if rest.is_empty() { "" } else { "." });
    Some(if digits.is_zero() { "0".to_owned() } else { format!("{sign}{first}{point}{rest}e{exponent}") })
}

/// Whether two numbers differ by no more than the rounding of their last digits; zero agrees with zero alone.
pub(super) fn agree(one: &str, other: &str) -> bool {
    let (Some(one), Some(other)) = (rational(one), rational(other)) else { return false };
    let scale = BigRational::from_integer(BigInt::from(10).pow(DIGITS as u32 - 1));
    (&one - &other).abs() * scale <= other.abs().min(one.abs()) * BigInt::from(2)
}

fn rational(text: &str) -> Option<BigRational> {
    let (digits, exponent) = parse(text)?;
    let exponent = i32::try_from(exponent).ok().filter(|exponent| i64::from(exponent.abs()) <= EXPONENT_LIMIT)?;
    Some(BigRational::from_integer(digits) * BigRational::from_integer(10.into()).pow(exponent))
}

/// An integer and the power of ten that it is multiplied by.
fn parse(text: &str) -> Option<(BigInt, i64)> {
    let (mantissa, exponent) = text.split_once(['b', 'e']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}").parse().ok()?;
    Some((digits, exponent.parse::<i64>().ok()?.checked_sub(fraction.len() as i64)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_round_to_forty_digits() {
        let nines = "9".repeat(45);
        let pairs = [
            ("1.25b-3".to_owned(), "1.25e-3"),
            ("-6.0b0".to_owned(), "-6e0"),
            ("0".to_owned(), "0"),
            ("0.0b0".to_owned(), "0"),
            (format!("0.00{nines}b2"), "1e0"),
            (format!("1.{}5b10", "0".repeat(38)), "1.000000000000000000000000000000000000005e10"),
            (format!("-1.{}5b10", "0".repeat(39)), "-1.000000000000000000000000000000000000001e10"),
            (format!("1.{}49b10", "0".repeat(39)), "1e10"),
        ];
        for (maxima, rounded) in pairs {
            assert_eq!(round(&maxima).as_deref(), Some(rounded), "{maxima}");
        }
        assert_eq!(round("x"), None);
    }

    #[test]
    fn numbers_agree_up_to_their_last_digit() {
        let digits = "1.23456789012345678901234567890123456789";
        assert!(agree(&format!("{digits}0e5"), &format!("{digits}1e5")));
        assert!(!agree(&format!("{digits}0e5"), &format!("{digits}9e5")));
        assert!(agree("1e0", &format!("9.{}e-1", "9".repeat(39))));
        assert!(!agree("1e0", "-1e0") && !agree("0", "1e-300") && !agree("1e0", "x") && agree("0", "0.0b0"));
    }
}
