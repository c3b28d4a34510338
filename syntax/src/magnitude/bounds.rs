//! What is known of a value: bounds of its magnitude, what it is a multiple of, its sign.

use std::cmp::Ordering;

use closedform_arith::Function;
use closedform_arith::range::STEP;

/// Bits of a number after its leading one.
const FRACTION: i64 = f64::MANTISSA_DIGITS as i64 - 1;

/// The exponents of the least normal number, of the largest power of two, and of the least number.
const NORMAL: i64 = f64::MIN_EXP as i64 - 1;
const LARGEST: i64 = f64::MAX_EXP as i64 - 1;
pub(super) const LEAST: i64 = NORMAL - FRACTION;

/// A value that is 0, if it may be `zero`, or of a magnitude from 2^low to 2^high; and a multiple of 2^grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Bounds {
    pub zero: bool,
    pub low: i64,
    pub high: i64,
    pub grid: i64,
    pub sign: Sign,
}

/// The sign of a value, unless it is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Positive,
    Negative,
    Open,
}

impl Sign {
    fn turned(self) -> Self {
        match self {
            Sign::Positive => Sign::Negative,
            Sign::Negative => Sign::Positive,
            Sign::Open => Sign::Open,
        }
    }

    pub(super) fn times(self, other: Self) -> Self {
        match self {
            Sign::Positive => other,
            Sign::Negative => other.turned(),
            Sign::Open => Sign::Open,
        }
    }

    /// That of a function's value.
    fn called(self, function: Function) -> Self {
        let at = |sign| match function.signs(sign) {
            [] => None,
            [Ordering::Less] => Some(Sign::Negative),
            [Ordering::Greater] => Some(Sign::Positive),
            _ => Some(Sign::Open),
        };
        let (negative, positive) = (at(Ordering::Less), at(Ordering::Greater));
        let image = match self {
            Sign::Negative => negative,
            Sign::Positive => positive,
            Sign::Open => negative.map_or(positive, |negative| positive.map(|positive| negative.or(positive))),
        };
        // where there is no value nothing depends on it
        image.or(positive).unwrap_or(Sign::Open)
    }

    fn or(self, other: Self) -> Self {
        if self == other { self } else { Sign::Open }
    }

    /// Whether numbers of these signs cannot cancel.
    fn agrees(self, other: Self) -> bool {
        self == other && self != Sign::Open
    }
}

impl Bounds {
    /// A number of 53 bits, or zero.
    pub(super) fn float(low: i64, high: i64) -> Self {
        Bounds { zero: true, low, high, grid: low - FRACTION, sign: Sign::Open }
    }

    pub(super) fn literal(value: f64) -> Self {
        let zero = value == 0.0;
        let bits = value.to_bits() & !(1 << 63);
        let fraction = bits & ((1 << FRACTION) - 1);
        let field = (bits >> FRACTION) as i64;
        let significand = if field == 0 { fraction } else { fraction | 1 << FRACTION };
        // The exponent of the last place; of zero any number will do.
        let unit = if zero { 0 } else { field.max(1) - 1 + LEAST };
        let low = unit + i64::from(significand.max(1).ilog2());
        let grid = unit + i64::from(significand.max(1).trailing_zeros());
        let sign = if value < 0.0 { Sign::Negative } else { Sign::Positive };
        Bounds { zero, low, high: if low == grid { low } else { low + 1 }, grid, sign }
    }

    pub(super) fn negated(self) -> Self {
        Bounds { sign: self.sign.turned(), ..self }
    }

    pub(super) fn magnitude(self) -> Self {
        Bounds { sign: Sign::Positive, ..self }
    }

    pub(super) fn or(self, other: Self) -> Self {
        Bounds {
            zero: self.zero || other.zero,
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            grid: self.grid.min(other.grid),
            sign: self.sign.or(other.sign),
        }
    }

    /// A sum, wherever it lies. Rounding keeps multiples of a power of two what they are, and bounds that are powers of
    /// two.
    pub(super) fn sum(self, other: Self) -> Self {
        let grid = self.grid.min(other.grid);
        let high = self.high.max(other.high) + 1;
        let agree = self.sign.agrees(other.sign);
        let low = match (self.zero, other.zero) {
            _ if !agree => grid,
            (false, false) => self.low.max(other.low),
            (false, true) => self.low,
            (true, false) => other.low,
            (true, true) => self.low.min(other.low),
        };
        let zero = !agree || self.zero && other.zero;
        Bounds { zero, low, high, grid, sign: self.sign.or(other.sign) }
    }

    /// A product, wherever it lies, before it is rounded.
    pub(super) fn product(self, other: Self) -> Self {
        Bounds {
            zero: self.zero || other.zero,
            low: self.low + other.low,
            high: self.high + other.high,
            grid: self.grid + other.grid,
            sign: self.sign.times(other.sign),
        }
    }

    /// The number, rounded to 53 bits.
    pub(super) fn rounded(self) -> Self {
        Bounds { grid: self.grid.max(self.low - FRACTION), ..self }
    }

    /// The number, unless it may overflow.
    pub(super) fn finite(self) -> Option<Self> {
        (self.high <= LARGEST).then_some(self)
    }

    /// The number, unless it may overflow, or underflow to one that is not normal.
    pub(super) fn normal(self) -> Option<Self> {
        (self.low >= NORMAL).then_some(self)?.finite()
    }

    /// The number, unless it may overflow, or underflow to one of which a unit of relative error is not normal.
    pub(super) fn with_its_error(self) -> Option<Self> {
        (self.low > NORMAL + FRACTION).then_some(self)?.finite()
    }

    /// The leading part of a number in double-double, tested to be 0 or of a magnitude in range. What it is a
    /// multiple of depends on its low part too.
    pub(super) fn tested(self) -> Self {
        let (low, high) = (STEP.0, self.high.min(STEP.1));
        Bounds { zero: true, low, high, grid: low - FRACTION, ..self }
    }

    /// The quotient; the divisor is not zero.
    pub(super) fn quotient(self, other: Self) -> Self {
        let (low, high) = (self.low - other.high, self.high - other.low);
        Bounds { low, high, grid: low - FRACTION, sign: self.sign.times(other.sign), ..self }
    }

    /// The value of a function, where it has one; `None` of one that is no power, whose magnitude does not follow from that of
    /// its argument.
    pub(super) fn called(self, function: Function) -> Option<Self> {
        let sign = self.sign.called(function);
        if function.is_exact() {
            return Some(Bounds { sign, ..self });
        }
        let (p, q) = function.properties().exponent?;
        let (p, q) = (i64::from(p), i64::from(q));
        let low = (self.low * p).div_euclid(q);
        let high = (self.high * p + q - 1).div_euclid(q);
        Some(Bounds { low, high, grid: low - FRACTION, sign, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_known_exactly() {
        let of = |value| {
            let Bounds { low, high, grid, .. } = Bounds::literal(value);
            (low, high, grid)
        };
        assert_eq!(of(1.0), (0, 0, 0));
        assert_eq!(of(-6.0), (2, 3, 1));
        assert_eq!(of(0.1), (-4, -3, -55));
        assert_eq!(of(f64::MAX), (1023, 1024, 971));
        assert_eq!(of(f64::from_bits(1)), (-1074, -1074, -1074));
        assert_eq!(of(f64::MIN_POSITIVE * 0.75), (-1023, -1022, -1024));
        assert!(Bounds::literal(0.0).zero && Bounds::literal(-0.0).zero);
        assert_eq!(Bounds::literal(-1.0).sign, Sign::Negative);
    }
}
