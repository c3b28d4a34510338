//! Sets of signs.

use closedform_arith::{Function, Relation};
use num_rational::BigRational;
use num_traits::Signed;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{BitAnd, Mul, Neg};

/// The set of signs that a value can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sign(u8);

const NEGATIVE: u8 = 1;
const ZERO: u8 = 2;
const POSITIVE: u8 = 4;

impl Sign {
    /// Nothing is known.
    pub const ANY: Self = Self(NEGATIVE | ZERO | POSITIVE);
    /// Greater than zero.
    pub const POSITIVE: Self = Self(POSITIVE);
    /// Less than zero.
    pub const NEGATIVE: Self = Self(NEGATIVE);
    /// Zero.
    pub const ZERO: Self = Self(ZERO);
    /// At least zero.
    pub const NONNEGATIVE: Self = Self(ZERO | POSITIVE);
    /// At most zero.
    pub const NONPOSITIVE: Self = Self(ZERO | NEGATIVE);
    /// Not zero.
    pub const NONZERO: Self = Self(NEGATIVE | POSITIVE);

    /// The sign of a number.
    #[must_use]
    pub fn of(value: &BigRational) -> Self {
        if value.is_positive() {
            Self::POSITIVE
        } else if value.is_negative() {
            Self::NEGATIVE
        } else {
            Self::ZERO
        }
    }

    /// The signs of what stands so to zero.
    #[must_use]
    pub fn of_relation(relation: Relation) -> Self {
        let orders = [(Ordering::Less, NEGATIVE), (Ordering::Equal, ZERO), (Ordering::Greater, POSITIVE)];
        Self(orders.into_iter().filter(|(order, _)| relation.holds(*order)).fold(0, |set, (_, sign)| set | sign))
    }

    /// Whether every sign in this set is in the other one.
    #[must_use]
    pub fn is(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    /// Whether the value never changes sign: it is at least zero, or it is at most zero.
    #[must_use]
    pub fn is_definite(self) -> bool {
        self.is(Self::NONNEGATIVE) || self.is(Self::NONPOSITIVE)
    }

    /// The signs that are not in this set.
    #[must_use]
    pub fn complement(self) -> Self {
        Self(Self::ANY.0 & !self.0)
    }

    /// Whether no value has it.
    #[must_use]
    pub fn is_impossible(self) -> bool {
        self.0 == 0
    }

    /// The sign of a sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        self.combine(other, |a, b| match (a, b) {
            (ZERO, sign) | (sign, ZERO) => sign,
            (a, b) if a == b => a,
            _ => Self::ANY.0,
        })
    }

    /// The sign of a value that has one of two signs.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The signs of a function's value, where there is one.
    #[must_use]
    pub fn called(self, function: Function) -> Self {
        let signs = [(NEGATIVE, Ordering::Less), (ZERO, Ordering::Equal), (POSITIVE, Ordering::Greater)];
        let bit = |sign: Ordering| signs.iter().find(|(_, other)| *other == sign).map_or(0, |(bit, _)| *bit);
        let values = signs.iter().filter(|(bit, _)| self.0 & bit != 0).flat_map(|(_, sign)| function.signs(*sign));
        Self(values.fold(0, |all, sign| all | bit(*sign)))
    }

    /// The sign of a power.
    #[must_use]
    pub fn power(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::POSITIVE,
            _ if exponent % 2 == 1 => self,
            _ => self.square(),
        }
    }

    fn square(self) -> Self {
        let zero = self.0 & ZERO;
        let rest = if self.0 & (NEGATIVE | POSITIVE) == 0 { 0 } else { POSITIVE };
        Self(zero | rest)
    }

    fn combine(self, other: Self, rule: impl Fn(u8, u8) -> u8) -> Self {
        let mut result = 0;
        for a in [NEGATIVE, ZERO, POSITIVE] {
            for b in [NEGATIVE, ZERO, POSITIVE] {
                if self.0 & a != 0 && other.0 & b != 0 {
                    result |= rule(a, b);
                }
            }
        }
        Self(result)
    }
}

impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match *self {
            Self::POSITIVE => "positive",
            Self::NEGATIVE => "negative",
            Self::ZERO => "zero",
            Self::NONNEGATIVE => "nonnegative",
            Self::NONPOSITIVE => "nonpositive",
            Self::NONZERO => "nonzero",
            _ => "open",
        })
    }
}

impl Neg for Sign {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0 & ZERO | (self.0 & NEGATIVE) << 2 | (self.0 & POSITIVE) >> 2)
    }
}

impl Mul for Sign {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, |a, b| match (a, b) {
            (ZERO, _) | (_, ZERO) => ZERO,
            (a, b) if a == b => POSITIVE,
            _ => NEGATIVE,
        })
    }
}

impl BitAnd for Sign {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}
