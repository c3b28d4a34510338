//! Distances in units in the last place: a twin of the commands' own, on purpose, so that one mistake is not in both.

use rug::Float;

/// A binary format: how many bits, and from which exponent on they are spaced evenly.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    bits: i32,
    lowest: i32,
}

/// Double precision.
pub const F64: Format = Format { bits: 53, lowest: -1074 };
/// Single precision.
pub const F32: Format = Format { bits: 24, lowest: -149 };

impl Format {
    /// The exponent of the unit in the last place of numbers like `exact`.
    fn unit(self, exact: &Float) -> i32 {
        // MPFR's exponent has the leading bit just below the point, hence no +1.
        exact.get_exp().map_or(self.lowest, |exponent| (exponent - self.bits).max(self.lowest))
    }
}

/// |actual - exact| in units in the last place of `exact`; an infinite `actual` is right where `exact` rounds to it, and
/// like NaN infinitely far from anything else.
pub fn distance(actual: f64, exact: &Float, format: Format) -> f64 {
    if !actual.is_finite() {
        return if actual == exact.to_f64() { 0.0 } else { f64::INFINITY };
    }
    let difference = Float::with_val(exact.prec() + 64, exact - actual).abs();
    (difference >> format.unit(exact)).to_f64()
}

/// One unit in the last place of `exact`.
pub fn unit(exact: &Float, format: Format) -> Float {
    Float::with_val(exact.prec(), 1) << format.unit(exact)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(value: f64, ulp: f64) -> Float {
        Float::with_val(200, value) + Float::with_val(200, ulp) * f64::EPSILON
    }

    #[test]
    fn units_are_those_of_the_exact_value() {
        assert_eq!(distance(1.0, &exact(1.0, 0.25), F64), 0.25);
        assert_eq!(distance(1.0 - f64::EPSILON, &exact(1.0, 0.0), F64), 1.0);
        assert_eq!(distance(1.0, &exact(1.0, -1.0), F64), 2.0);
        assert_eq!(distance(-2.0, &exact(-2.0, 1.0), F64), 1.0);
        assert_eq!(distance(1.0, &exact(1.0, f64::from(f32::EPSILON) / f64::EPSILON), F32), 1.0);
    }

    #[test]
    fn the_smallest_numbers_are_spaced_evenly() {
        assert_eq!(distance(15e-324, &Float::with_val(200, 5e-324), F64), 2.0);
        assert_eq!(distance(5e-324, &Float::new(200), F64), 1.0);
        assert_eq!(distance(0.0, &Float::new(200), F64), 0.0);
    }

    #[test]
    fn what_is_no_number_is_infinitely_far() {
        assert_eq!(distance(f64::NAN, &exact(1.0, 0.0), F64), f64::INFINITY);
        assert_eq!(distance(f64::INFINITY, &exact(1.0, 0.0), F64), f64::INFINITY);
    }
}
