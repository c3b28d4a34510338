//! Sets of signs.

use closedform_syntax::{Function, Relation};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::fmt;

/// The signs that a value can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sign {
    /// It can be less than zero.
    pub negative: bool,
    /// It can be zero.
    pub zero: bool,
    /// It can be greater than zero.
    pub positive: bool,
}

impl Sign {
    /// Nothing is known.
    pub const ANY: Self = Self { negative: true, zero: true, positive: true };
    /// `< 0`
    pub const NEGATIVE: Self = Self { negative: true, zero: false, positive: false };
    /// `== 0`
    pub const ZERO: Self = Self { negative: false, zero: true, positive: false };
    /// `> 0`
    pub const POSITIVE: Self = Self { negative: false, zero: false, positive: true };
    /// `>= 0`
    pub const NONNEGATIVE: Self = Self { negative: false, ..Self::ANY };
    /// `<= 0`
    pub const NONPOSITIVE: Self = Self { positive: false, ..Self::ANY };
    /// `!= 0`
    pub const NONZERO: Self = Self { zero: false, ..Self::ANY };

    /// The sign of a number.
    pub fn of(value: &BigRational) -> Self {
        Self { negative: value.is_negative(), zero: value.is_zero(), positive: value.is_positive() }
    }

    /// The signs of what stands so to zero.
    pub fn of_relation(relation: Relation) -> Self {
        Self {
            negative: relation.holds(Ordering::Less),
            zero: relation.holds(Ordering::Equal),
            positive: relation.holds(Ordering::Greater),
        }
    }

    /// Whether it is one of these signs.
    pub fn is(self, other: Self) -> bool {
        self.and(other) == self
    }

    /// Whether it is never negative, or never positive.
    pub fn is_definite(self) -> bool {
        !(self.negative && self.positive)
    }

    /// Whether it is always positive, or always negative.
    pub fn is_strict(self) -> bool {
        self.is_definite() && !self.zero
    }

    /// Whether no value has it.
    pub fn is_impossible(self) -> bool {
        !(self.negative || self.zero || self.positive)
    }

    /// Both are known.
    pub fn and(self, other: Self) -> Self {
        Self {
            negative: self.negative && other.negative,
            zero: self.zero && other.zero,
            positive: self.positive && other.positive,
        }
    }

    /// One of them holds.
    pub fn or(self, other: Self) -> Self {
        Self {
            negative: self.negative || other.negative,
            zero: self.zero || other.zero,
            positive: self.positive || other.positive,
        }
    }

    /// That of the negative.
    pub fn negated(self) -> Self {
        Self { negative: self.positive, zero: self.zero, positive: self.negative }
    }

    /// The signs left when it is not one of these.
    pub fn complement(self) -> Self {
        Self { negative: !self.negative, zero: !self.zero, positive: !self.positive }
    }

    /// That of a sum.
    pub fn plus(self, other: Self) -> Self {
        let possible = !(self.is_impossible() || other.is_impossible());
        Self {
            negative: possible && (self.negative || other.negative),
            zero: self.zero && other.zero || self.negative && other.positive || self.positive && other.negative,
            positive: possible && (self.positive || other.positive),
        }
    }

    /// That of a product.
    pub fn times(self, other: Self) -> Self {
        Self {
            negative: self.negative && other.positive || self.positive && other.negative,
            zero: self.zero && !other.is_impossible() || other.zero && !self.is_impossible(),
            positive: self.positive && other.positive || self.negative && other.negative,
        }
    }

    /// That of a function's value, where there is one.
    pub fn called(self, function: Function) -> Self {
        let signs = [(self.negative, Less), (self.zero, Equal), (self.positive, Greater)];
        let values = signs.into_iter().filter(|(possible, _)| *possible).flat_map(|(_, sign)| function.signs(sign));
        let is = |wanted: Ordering| values.clone().any(|sign| *sign == wanted);
        Self { negative: is(Less), zero: is(Equal), positive: is(Greater) }
    }

    /// That of a power.
    pub fn power(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::POSITIVE,
            _ if exponent % 2 == 1 => self,
            _ => Self { negative: false, zero: self.zero, positive: self.positive || self.negative },
        }
    }
}

impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match (self.negative, self.zero, self.positive) {
            (false, false, true) => "positive",
            (true, false, false) => "negative",
            (false, true, false) => "zero",
            (false, true, true) => "not negative",
            (true, true, false) => "not positive",
            (true, false, true) => "not zero",
            (false, false, false) => "impossible",
            (true, true, true) => "open",
        })
    }
}
