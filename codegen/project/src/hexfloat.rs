//! Hexadecimal floats, `0x1.8p-3`: the exact spelling of an `f64`, both ways.

use thiserror::Error;

/// Why a text is no hexadecimal float.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum HexFloatError {
    /// Another form.
    #[error("`{0}` is not a hexadecimal float such as -0x1.8p-3")]
    Malformed(String),
    /// A number between two neighbouring `f64`, or beyond the largest.
    #[error("`{0}` is not exactly a double-precision number")]
    Inexact(String),
}

/// The exact spelling of a finite number; `inf`, `-inf` and `NaN` otherwise.
pub fn print(value: f64) -> String {
    let sign = if value.is_sign_negative() && !value.is_nan() { "-" } else { "" };
    let bits = value.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    match (bits >> 52) & 0x7ff {
        0 if fraction == 0 => format!("{sign}0x0p+0"),
        0 => format!("{sign}0x0{point}{digits}p-1022"),
        0x7ff => value.to_string(),
        exponent => format!("{sign}0x1{point}{digits}p{:+}", exponent as i64 - 1023),
    }
}

/// The number that a text spells exactly.
pub fn parse(text: &str) -> Result<f64, HexFloatError> {
    let malformed = || HexFloatError::Malformed(text.to_owned());
    let (negative, unsigned) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let digits = unsigned.strip_prefix("0x").or_else(|| unsigned.strip_prefix("0X")).ok_or_else(malformed)?;
    let (mantissa, exponent) = digits.split_once(['p', 'P']).ok_or_else(malformed)?;
    let exponent: i64 = exponent.parse().map_err(|_| malformed())?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let significant = digits.trim_start_matches('0').trim_end_matches('0');
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return Err(malformed());
    }
    if significant.is_empty() {
        return Ok(if negative { -0.0 } else { 0.0 });
    }
    let dropped = digits.len() - digits.trim_end_matches('0').len();
    let scale = 4 * (dropped as i64 - fraction.len() as i64);
    let magnitude = exponent.checked_add(scale).and_then(|exponent| exact(significant, exponent));
    let magnitude = magnitude.ok_or_else(|| HexFloatError::Inexact(text.to_owned()))?;
    Ok(if negative { -magnitude } else { magnitude })
}

/// `significant * 2^exponent`, if that is a double; `significant` has no outer zeros.
fn exact(significant: &str, exponent: i64) -> Option<f64> {
    let mantissa = u64::from_str_radix(significant, 16).ok()?;
    let spare = mantissa.trailing_zeros();
    let (mantissa, exponent) = (mantissa >> spare, exponent.checked_add(i64::from(spare))?);
    let bits = i64::from(64 - mantissa.leading_zeros());
    let leading = exponent.checked_add(bits - 1)?;
    if bits > 53 || exponent < -1074 || leading > 1023 {
        return None;
    }
    Some(if leading < -1022 {
        f64::from_bits(mantissa << (exponent + 1074))
    } else {
        let fraction = (mantissa << (53 - bits)) & ((1 << 52) - 1);
        f64::from_bits((((leading + 1023) as u64) << 52) | fraction)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spelling_is_exact_both_ways() {
        let pairs = [
            (0.0, "0x0p+0"),
            (-0.0, "-0x0p+0"),
            (1.0, "0x1p+0"),
            (-0.1875, "-0x1.8p-3"),
            (0.1, "0x1.999999999999ap-4"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::from_bits(1), "0x0.0000000000001p-1022"),
        ];
        for (value, text) in pairs {
            assert_eq!(print(value), text);
            assert_eq!(parse(text).map(f64::to_bits), Ok(value.to_bits()), "{text}");
        }
    }

    #[test]
    fn every_bit_pattern_comes_back() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let value = f64::from_bits(bits);
            if value.is_finite() {
                assert_eq!(parse(&print(value)).map(f64::to_bits), Ok(bits));
            }
        }
    }

    #[test]
    fn other_spellings_of_the_same_number_are_read() {
        for text in ["0x18p-7", "0X0.3P0", "+0x.3p+0", "0x3.p-4", "0x0.30000000000000000000000p0"] {
            assert_eq!(parse(text), Ok(0.1875), "{text}");
        }
    }

    #[test]
    fn what_is_no_double_is_refused() {
        for text in ["", "0x", "0xp0", "1.5", "0x1", "0x1p", "0xgp0", "0x1.-1p0", "0x1p99999999999999999999", "é"] {
            assert!(matches!(parse(text), Err(HexFloatError::Malformed(_))), "{text}");
        }
        for text in ["0x1.00000000000001p0", "0x1p+1024", "0x1p-1075", "0x1.8p-1074", "0x123456789abcdef01p0"] {
            assert!(matches!(parse(text), Err(HexFloatError::Inexact(_))), "{text}");
        }
        assert!(matches!(parse("0x1p9223372036854775807"), Err(HexFloatError::Inexact(_))));
    }
}
