//! The distance of a float from a real number.

use rug::Float;
use rug::float::Round;

/// The exponent of the smallest normal number: ulps of smaller ones are as large.
const LOWEST: i32 = f64::MIN_EXP - 1;

/// How many bits the fraction of a float has.
const FRACTION: i32 = f64::MANTISSA_DIGITS as i32 - 1;

/// The distance of `got` from the exact value in units of the last place of the exact value's binade, rounded up.
///
/// Subnormal numbers are all in units of the smallest. An infinite result is right where the exact value rounds to it;
/// otherwise infinity and NaN are infinitely far from anything else.
pub fn ulp_error(got: f64, exact: &Float) -> f64 {
    if got.is_nan() || exact.is_nan() {
        return if got.is_nan() && exact.is_nan() { 0.0 } else { f64::INFINITY };
    }
    if got.is_infinite() || exact.is_infinite() {
        return if got == exact.to_f64() { 0.0 } else { f64::INFINITY };
    }
    // MPFR counts exponents from the point before the leading bit.
    let exponent = exact.get_exp().map_or(LOWEST, |exponent| (exponent - 1).max(LOWEST));
    let distance = Float::with_val(exact.prec().max(f64::MANTISSA_DIGITS) + 64, got - exact).abs();
    (distance << (FRACTION - exponent)).to_f64_round(Round::Up)
}

/// An error in ulp as people read it, rounded up so that it is never taken for less.
pub fn ulp_text(ulp: f64) -> String {
    if ulp < 1e6 { format!("{:.3}", (ulp * 1e3).ceil() / 1e3) } else { format!("{ulp:.3e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(text: &str) -> Float {
        Float::with_val(200, Float::parse(text).unwrap())
    }

    #[test]
    fn distances_are_exact() {
        let third = Float::with_val(200, 1) / 3;
        assert!((0.33..0.34).contains(&ulp_error(1.0 / 3.0, &third)));
        assert_eq!(ulp_error(1.0, &exact("1")), 0.0);
        assert_eq!(ulp_error(1.0f64.next_up(), &exact("1")), 1.0);
        assert_eq!(ulp_error(1.0f64.next_down(), &exact("1")), 0.5);
        assert_eq!(ulp_error(-1.0, &exact("1")), 2.0f64.powi(53));
        let between = exact("1") + (exact("1") >> 54u32);
        assert_eq!(ulp_error(1.0, &between), 0.25);
    }

    #[test]
    fn subnormal_numbers_are_in_units_of_the_smallest() {
        let tiny = f64::from_bits(1);
        assert_eq!(ulp_error(tiny, &exact("0")), 1.0);
        assert_eq!(ulp_error(0.0, &exact("0")), 0.0);
        assert_eq!(ulp_error(-0.0, &exact("0")), 0.0);
        assert_eq!(ulp_error(f64::from_bits(3), &Float::with_val(200, tiny)), 2.0);
        assert_eq!(ulp_error(0.0, &(Float::with_val(200, tiny) >> 2u32)), 0.25);
    }

    #[test]
    fn text_is_rounded_up() {
        let text = [0.0, 0.5, 0.50000001, 123.4561, 4.5e15, f64::INFINITY].map(ulp_text);
        assert_eq!(text, ["0.000", "0.500", "0.501", "123.457", "4.500e15", "inf"]);
    }

    #[test]
    fn infinity_is_right_where_it_is_the_rounded_value() {
        assert_eq!(ulp_error(f64::INFINITY, &exact("1e400")), 0.0);
        assert_eq!(ulp_error(f64::NEG_INFINITY, &exact("1e400")), f64::INFINITY);
        assert_eq!(ulp_error(f64::INFINITY, &exact("1")), f64::INFINITY);
        assert!(ulp_error(f64::MAX, &exact("1e400")) > 1.0);
        assert_eq!(ulp_error(f64::NAN, &exact("1")), f64::INFINITY);
        assert_eq!(ulp_error(f64::NAN, &Float::with_val(53, f64::NAN)), 0.0);
        assert_eq!(ulp_error(1.0, &Float::with_val(53, f64::NAN)), f64::INFINITY);
    }
}
