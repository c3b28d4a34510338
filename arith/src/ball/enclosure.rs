//! `Enclosure`: a float of `L` words and a bound of its error, with the operations that polynomials need.

use super::limbs::{Cut, Limbs};
use super::radius::Radius;
use crate::error_model::ball::APART;
use crate::soft_float::SoftFloat;

/// A number that is no farther than the radius from the middle.
#[derive(Clone, Copy)]
pub(super) struct Enclosure<const L: usize> {
    pub(super) middle: Limbs<L>,
    pub(super) radius: Radius,
}

impl<const L: usize> Enclosure<L> {
    /// A number that was cut off, and what it was off by before.
    pub(super) fn of((middle, cut): Cut<L>, radius: Radius) -> Self {
        Enclosure { middle, radius: cut.map_or(radius, |exponent| radius.plus(Radius::power_of_two(exponent))) }
    }

    /// A number as it is.
    pub(super) fn exact(middle: Limbs<L>) -> Self {
        Enclosure { middle, radius: Radius::ZERO }
    }

    /// An integer, times 2^twos.
    pub(super) fn integer(integer: u64, twos: i64) -> Self {
        Self::exact(Limbs::from_integer(false, integer, twos))
    }

    /// The number times 2^by.
    pub(super) fn scaled(self, by: i64) -> Self {
        let radius = self.radius.times(Radius::power_of_two(by));
        Enclosure { middle: self.middle.scaled(by), radius: if self.radius.is_zero() { self.radius } else { radius } }
    }

    /// The same, and all that is no farther than this from it.
    pub(super) fn widened(self, by: Radius) -> Self {
        Enclosure { radius: self.radius.plus(by), ..self }
    }

    /// At least the largest magnitude in it.
    pub(super) fn size(&self) -> Radius {
        self.middle_size().plus(self.radius)
    }

    /// At least the magnitude of the middle.
    pub(super) fn middle_size(&self) -> Radius {
        Radius::new(self.middle.leading(), self.middle.exponent())
    }

    /// |(x + y) - (a + b)| <= r_x + r_y, where x and y are the numbers and a and b the middles.
    pub(super) fn plus(self, other: Self) -> Self {
        Self::of(self.middle.plus(other.middle), self.radius.plus(other.radius))
    }

    /// |x y - a b| <= |x - a| |y| + |a| |y - b| <= r_x (|b| + r_y) + |a| r_y.
    pub(super) fn times(self, other: Self) -> Self {
        let radius = if self.radius.is_zero() && other.radius.is_zero() {
            Radius::ZERO
        } else {
            self.radius.times(other.size()).plus(self.middle_size().times(other.radius))
        };
        Self::of(self.middle.times(other.middle), radius)
    }

    /// |x/y - a/b| <= (r_x + |a/b| r_y)/|y|, where y is no nearer to zero than |b| - r_y, which must be at least |b|/2.
    pub(super) fn over(self, other: Self) -> Option<Self> {
        let (value, exponent) = (other.middle.leading(), other.middle.exponent());
        if other.middle.is_zero() || !other.radius.is_less_than(value, exponent - 1) {
            return None;
        }
        let quotient = self.middle_size().over(value, exponent);
        let radius = self.radius.plus(quotient.times(other.radius)).over(value, exponent - 1);
        Some(Self::of(self.middle.over(other.middle), radius))
    }

    /// A quotient by an integer that is not zero.
    pub(super) fn over_integer(self, integer: u64) -> Self {
        let divisor = Limbs::from_integer(false, integer, 0);
        Self::of(self.middle.over(divisor), self.radius.over(divisor.leading(), divisor.exponent()))
    }

    pub(super) fn negated(self) -> Self {
        Enclosure { middle: self.middle.negated(), ..self }
    }

    /// Whether all of it is of one sign.
    pub(super) fn is_apart_from_zero(&self) -> bool {
        !self.middle.is_zero() && self.radius.is_less_than(self.middle.leading(), self.middle.exponent())
    }

    /// Two numbers between which all of it lies, and none of it is one of them.
    ///
    /// They are [farther apart](APART) than the radius says: more than what their sums cut off.
    pub(super) fn ends(&self) -> (Limbs<L>, Limbs<L>) {
        let reach: Limbs<L> = self.radius.upper();
        let unit = if self.middle.is_zero() { reach.unit() } else { self.middle.unit().max(reach.unit()) };
        let reach = self.radius.plus(Radius::power_of_two(unit + APART)).upper();
        (self.middle.plus(reach.negated()).0, self.middle.plus(reach).0)
    }

    /// Its first 128 bits and whether there are more, where all numbers of the enclosure agree on that.
    pub(super) fn to_soft(self) -> Option<SoftFloat> {
        if self.radius.is_zero() {
            return Some(self.middle.to_soft());
        }
        if !self.is_apart_from_zero() {
            return None;
        }
        let (least, most) = self.ends();
        let (first, last) = (least.to_soft(), most.to_soft());
        // strictly between numbers that share these bits, it has more
        let agree = !least.is_zero() && !most.is_zero() && first == last;
        agree.then(|| first.with_more())
    }
}
