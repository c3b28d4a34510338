//! Which signs a number may have, where nothing but the text of a program tells.

/// Which signs a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs {
    /// Whether it may be below zero.
    pub negative: bool,
    /// Whether it may be above zero.
    pub positive: bool,
    /// Whether it may be zero.
    pub zero: bool,
}

impl Signs {
    /// Any.
    pub const ANY: Self = Signs { negative: true, positive: true, zero: true };
    /// Above zero.
    pub const POSITIVE: Self = Signs { negative: false, positive: true, zero: false };
    /// Zero, or above it.
    pub const NOT_NEGATIVE: Self = Signs { zero: true, ..Self::POSITIVE };
    /// Below zero.
    pub const NEGATIVE: Self = Signs { negative: true, positive: false, zero: false };
    /// Zero, or below it.
    pub const NOT_POSITIVE: Self = Signs { zero: true, ..Self::NEGATIVE };

    /// Whether a number has one of these signs.
    #[inline(always)]
    #[must_use]
    pub fn admit(self, value: f64) -> bool {
        match (self.negative, self.positive, self.zero) {
            (true, true, _) => true,
            (false, _, true) => value >= 0.0,
            (false, _, false) => value > 0.0,
            (_, false, true) => value <= 0.0,
            (_, false, false) => value < 0.0,
        }
    }

    /// The magnitude of a number of these signs.
    #[inline(always)]
    #[must_use]
    pub fn magnitude(self, value: f64) -> f64 {
        match (self.negative, self.positive) {
            (false, _) => value,
            (_, false) => -value,
            _ => value.abs(),
        }
    }

    /// The sign of a number.
    #[inline(always)]
    pub(super) fn of(value: f64) -> Self {
        Signs { negative: value < 0.0, positive: value > 0.0, zero: value == 0.0 }
    }

    #[inline(always)]
    pub(super) fn is_zero(self) -> bool {
        !self.negative & !self.positive
    }

    /// Those of the negative.
    #[inline(always)]
    pub(super) fn negated(self) -> Self {
        Signs { negative: self.positive, positive: self.negative, ..self }
    }

    /// Those of a sum.
    #[inline(always)]
    pub(super) fn sum(self, other: Self) -> Self {
        let (negative, positive) = (self.negative | other.negative, self.positive | other.positive);
        Signs { negative, positive, zero: (negative & positive) | (self.zero & other.zero) }
    }

    /// Whether a sum cannot cancel.
    #[inline(always)]
    pub(super) fn agree(self, other: Self) -> bool {
        let sum = self.sum(other);
        !(sum.negative & sum.positive)
    }

    /// Those of a product or quotient that does not underflow.
    #[inline(always)]
    pub(super) fn product(self, other: Self) -> Self {
        Signs {
            negative: (self.negative & other.positive) | (self.positive & other.negative),
            positive: (self.negative & other.negative) | (self.positive & other.positive),
            zero: self.zero | other.zero,
        }
    }
}
