//! `Ball`: the arithmetic of certified calls, whose every value carries a rigorous bound of its own error.
//!
//! A value is a float of `L` words and a radius: the exact value of what the program computes lies between them (ball
//! arithmetic: van der Hoeven; Johansson's Arb). A comparison is decided where the balls are apart, and where a separation
//! bound shows that the two sides are equal. What is not decided is said to be [undecided](Decisions): the call is then
//! computed again with more words.

mod constants;
mod elementary;
mod enclosure;
mod end;
mod limbs;
mod polynomial;
mod radius;
mod real;
mod root;
mod separation;
mod step;
#[cfg(all(test, feature = "std"))]
mod tests;

use core::cell::Cell;
use core::cmp::Ordering;

use crate::error_model::CERTIFIED_RADIUS;
use crate::float;
use enclosure::Enclosure;
use limbs::{Cut, Limbs};
pub(crate) use polynomial::polynomial;
use radius::Radius;
use separation::Separation;

/// Balls of so few words do without separation bounds, which take time, and which they seldom are small enough for.
const WITHOUT_SEPARATION: usize = 4;

/// What a computation in balls leaves open, and how many values it has made so far.
#[derive(Default)]
pub struct Decisions {
    undecided: Cell<bool>,
    values: Cell<u32>,
}

impl Decisions {
    /// Whether a comparison was not decided.
    pub fn is_undecided(&self) -> bool {
        self.undecided.get()
    }

    /// A number that no value has had, from 1; the last one is given out for ever.
    fn next(&self) -> u32 {
        self.values.set(self.values.get().saturating_add(1));
        self.values.get()
    }
}

/// A number and a bound of its error.
#[derive(Clone)]
pub struct Ball<'a, const L: usize> {
    kind: Kind,
    middle: Limbs<L>,
    radius: Radius,
    /// How small the exact value can be if it is not zero, where that is known.
    separation: Option<Separation>,
    /// Which value of the computation it is: the same one is equal to itself.
    number: u32,
    decisions: &'a Decisions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Number,
    /// There is no value: the root of a negative number, a quotient by zero.
    Nothing,
    /// Whether there is a value could not be decided.
    Unknown,
}

impl<'a, const L: usize> Ball<'a, L> {
    /// Exact; no value unless finite.
    pub fn new(value: f64, decisions: &'a Decisions) -> Self {
        if !value.is_finite() {
            return Self::without_value(Kind::Nothing, decisions);
        }
        let (significand, exponent) = float::significand(value);
        Ball {
            kind: Kind::Number,
            middle: Limbs::from_f64(value),
            radius: Radius::ZERO,
            separation: (L > WITHOUT_SEPARATION).then(|| Separation::of_dyadic(significand, exponent.into())),
            number: decisions.next(),
            decisions,
        }
    }

    fn without_value(kind: Kind, decisions: &'a Decisions) -> Self {
        let number = decisions.next();
        Ball { kind, middle: Limbs::ZERO, radius: Radius::ZERO, separation: None, number, decisions }
    }

    fn of(&self, cut: Cut<L>, radius: Radius, separation: Option<Separation>) -> Self {
        self.enclosed_in(Enclosure::of(cut, radius), separation)
    }

    fn enclosed_in(&self, Enclosure { middle, radius }: Enclosure<L>, separation: Option<Separation>) -> Self {
        let number = self.decisions.next();
        Ball { kind: Kind::Number, middle, radius, separation, number, decisions: self.decisions }.zero_if_shown()
    }

    fn enclosure(&self) -> Enclosure<L> {
        Enclosure { middle: self.middle, radius: self.radius }
    }

    /// The exact zero, where the separation bound shows that the value can be nothing else.
    fn zero_if_shown(self) -> Self {
        let exact = self.radius.is_zero();
        let least = self.separation.and_then(Separation::least);
        let vanishes = !exact && !self.is_apart_from_zero() && least.is_some_and(|least| self.is_below(least));
        if vanishes { Ball::new(0.0, self.decisions) } else { self }
    }

    /// Whether all of the ball is of one sign.
    fn is_apart_from_zero(&self) -> bool {
        self.enclosure().is_apart_from_zero()
    }

    /// Whether it is the same value of the computation.
    fn is_the_same(&self, other: &Self) -> bool {
        self.number == other.number && self.number != u32::MAX
    }

    /// Whether all of the ball is below 2^exponent in magnitude.
    fn is_below(&self, exponent: i64) -> bool {
        self.size().is_less_than(0.5, exponent.saturating_add(1))
    }

    /// At least the largest magnitude in the ball.
    fn size(&self) -> Radius {
        self.enclosure().size()
    }

    /// The sign: `None` if it is not decided.
    fn sign(&self) -> Option<Ordering> {
        match self.kind {
            Kind::Number if self.is_apart_from_zero() && self.middle.is_negative() => Some(Ordering::Less),
            Kind::Number if self.is_apart_from_zero() => Some(Ordering::Greater),
            Kind::Number if self.radius.is_zero() => Some(Ordering::Equal),
            _ => None,
        }
    }

    /// What an operation on two balls gives where one of them has no value.
    fn without_values(&self, other: &Self) -> Option<Self> {
        let kind = match (self.kind, other.kind) {
            (Kind::Number, Kind::Number) => return None,
            (Kind::Nothing, _) | (_, Kind::Nothing) => Kind::Nothing,
            _ => Kind::Unknown,
        };
        Some(Self::without_value(kind, self.decisions))
    }

    /// The nearest `f64`, off by [as little](CERTIFIED_RADIUS) as certified calls are, and whether it is the value itself; NaN where there
    /// is no value. `None` where the ball is too large for that.
    pub fn accepted(&self) -> Option<(f64, bool)> {
        let rounded = self.middle.to_f64();
        match self.kind {
            Kind::Nothing => Some((f64::NAN, false)),
            Kind::Unknown => None,
            Kind::Number if self.radius.is_zero() => Some((rounded, self.middle.is_exactly(rounded))),
            Kind::Number => {
                let allowed = self.middle.exponent().saturating_add(CERTIFIED_RADIUS);
                let accepted = !self.middle.is_zero() && self.radius.is_less_than(0.5, allowed);
                accepted.then_some((rounded, false))
            }
        }
    }

    /// An integer, as it is.
    fn integer(&self, middle: Limbs<L>) -> Self {
        let separation = (L > WITHOUT_SEPARATION).then(|| Separation::of_integer(middle.exponent()));
        self.enclosed_in(Enclosure::exact(middle), separation)
    }

    /// As a number of which only the value counts.
    fn without_separation(self) -> Self {
        Ball { separation: None, ..self }
    }

    fn joined(&self, other: &Self, join: fn(Separation, Separation) -> Option<Separation>) -> Option<Separation> {
        join(self.separation?, other.separation?)
    }

    fn plus(&self, other: &Self) -> Self {
        self.without_values(other).unwrap_or_else(|| {
            self.enclosed_in(self.enclosure().plus(other.enclosure()), self.joined(other, Separation::plus))
        })
    }

    fn negated(&self) -> Self {
        Ball { middle: self.middle.negated(), number: self.decisions.next(), ..self.clone() }
    }

    fn times(&self, other: &Self) -> Self {
        self.without_values(other).unwrap_or_else(|| {
            self.enclosed_in(self.enclosure().times(other.enclosure()), self.joined(other, Separation::times))
        })
    }

    /// A quotient by what may be zero has no value, or it is not known whether it has one.
    fn over(&self, other: &Self) -> Self {
        if let Some(without) = self.without_values(other) {
            return without;
        }
        if other.sign() == Some(Ordering::Equal) {
            return Self::without_value(Kind::Nothing, self.decisions);
        }
        match self.enclosure().over(other.enclosure()) {
            Some(quotient) => self.enclosed_in(quotient, self.joined(other, Separation::over)),
            None => Self::without_value(Kind::Unknown, self.decisions),
        }
    }

    /// The magnitude of the middle is no farther from that of the value than the middle is from the value.
    pub(crate) fn magnitude(&self) -> Self {
        Ball { middle: self.middle.magnitude(), number: self.decisions.next(), ..self.clone() }
    }
}

impl<const L: usize> PartialEq for Ball<'_, L> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const L: usize> PartialOrd for Ball<'_, L> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = self.order(other);
        self.decisions.undecided.set(self.decisions.undecided.get() | order.is_none());
        order.flatten()
    }
}
