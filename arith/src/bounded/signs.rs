//! Which signs a number may have, where nothing but the text of a program tells.

/// Which signs a number may have, besides being zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs {
    /// Whether it may be below zero.
    pub negative: bool,
    /// Whether it may be above zero.
    pub positive: bool,
}

impl Signs {
    /// Either.
    pub const ANY: Self = Signs { negative: true, positive: true };
    /// Zero, or above it.
    pub const NOT_NEGATIVE: Self = Signs { negative: false, positive: true };
    /// Zero, or below it.
    pub const NOT_POSITIVE: Self = Signs { negative: true, positive: false };

    /// The sign of a number.
    #[inline(always)]
    pub(super) fn of(value: f64) -> Self {
        Signs { negative: value < 0.0, positive: value > 0.0 }
    }

    #[inline(always)]
    pub(super) fn is_zero(self) -> bool {
        !self.negative & !self.positive
    }

    /// Those of the negative.
    #[inline(always)]
    pub(super) fn negated(self) -> Self {
        Signs { negative: self.positive, positive: self.negative }
    }

    /// Those of a sum.
    #[inline(always)]
    pub(super) fn sum(self, other: Self) -> Self {
        Signs { negative: self.negative | other.negative, positive: self.positive | other.positive }
    }

    /// Whether a sum cannot cancel.
    #[inline(always)]
    pub(super) fn agree(self, other: Self) -> bool {
        let sum = self.sum(other);
        !(sum.negative & sum.positive)
    }

    /// Those of a product or quotient.
    #[inline(always)]
    pub(super) fn product(self, other: Self) -> Self {
        Signs {
            negative: (self.negative & other.positive) | (self.positive & other.negative),
            positive: (self.negative & other.negative) | (self.positive & other.positive),
        }
    }
}
