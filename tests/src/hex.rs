//! Hexadecimal floats: `0x1.8p-3` is 0.1875, exactly.

use rug::{Float, Integer};

/// The exact spelling of a finite number; `inf`, `-inf` and `NaN` otherwise.
pub fn print(value: f64) -> String {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    match exponent {
        0x7ff => value.to_string(),
        0 if fraction == 0 => format!("{sign}0x0p+0"),
        0 => format!("{sign}0x0{point}{digits}p-1022"),
        _ => format!("{sign}0x1{point}{digits}p{:+}", exponent as i64 - 1023),
    }
}

/// The number that `text` spells, if it spells one and that is a double.
pub fn parse(text: &str) -> Option<f64> {
    let unsigned = text.trim_start_matches('-');
    let (mantissa, exponent) = unsigned.strip_prefix("0x")?.split_once('p')?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = Integer::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
    let exponent = exponent.parse::<i32>().ok()? - 4 * i32::try_from(fraction.len()).ok()?;
    let magnitude = Float::with_val(digits.significant_bits().max(53), digits) << exponent;
    let value = magnitude.to_f64();
    (value == magnitude).then_some(if text.starts_with('-') { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::{parse, print};

    #[test]
    fn spellings_are_exact() {
        let spelled = [
            (0.1875, "0x1.8p-3"),
            (-1.0, "-0x1p+0"),
            (0.0, "0x0p+0"),
            (5e-324, "0x0.0000000000001p-1022"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
        ];
        for (value, text) in spelled {
            assert_eq!((print(value).as_str(), parse(text)), (text, Some(value)));
        }
    }

    #[test]
    fn what_is_no_double_is_refused() {
        for text in ["0.5", "0x1", "0xp0", "0x1p2000", "0x1.00000000000001p+0", "0x1p-1080"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
