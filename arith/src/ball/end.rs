//! What is read off a ball: its order to another one, its value in `f64` and the error of that.

use core::cmp::Ordering;

use super::enclosure::Enclosure;
use super::limbs::Limbs;
use super::radius::Radius;
use super::{Ball, Decisions, Kind};
use crate::operand::Operand;
use crate::rounded::{Certified, Rounded};
use crate::soft_float::SoftFloat;

impl<'a, const L: usize> Ball<'a, L> {
    /// What no step has computed yet.
    pub(crate) fn unknown(decisions: &'a Decisions) -> Self {
        Self::without_value(Kind::Unknown, decisions)
    }

    /// How it compares, if that is decided; in no way where one has no value.
    pub(crate) fn order(&self, other: &Self) -> Option<Option<Ordering>> {
        match (self.kind, other.kind) {
            (Kind::Nothing, _) | (_, Kind::Nothing) => return Some(None),
            (Kind::Number, Kind::Number) if self.is_the_same(other) => return Some(Some(Ordering::Equal)),
            _ => {}
        }
        self.plus(&other.negated()).sign().map(Some)
    }

    /// Whether its sign is decided.
    pub(crate) fn has_sign(&self) -> bool {
        self.sign().is_some()
    }

    /// The one that compares so with the other, or as large as that one.
    ///
    /// Where x and y are the numbers and a and b the middles, |max(x, y) - max(a, b)| <= max(|x - a|, |y - b|). So both
    /// lie in a ball around the larger middle, even where it is open which of them is larger.
    pub(crate) fn extreme(&self, other: &Self, wanted: Ordering) -> Self {
        match (self.kind, other.kind) {
            (Kind::Number, Kind::Number) => {}
            // nothing compares with what has no value, which stays where it comes first
            (_, Kind::Nothing) | (Kind::Nothing, _) => return self.clone(),
            _ => return Self::without_value(Kind::Unknown, self.decisions),
        }
        match self.order(other) {
            Some(Some(order)) => {
                if order == wanted.reverse() {
                    other.clone()
                } else {
                    self.clone()
                }
            }
            _ => {
                let by_middle = self.middle.order(&other.middle);
                let middle = if by_middle == wanted.reverse() { other.middle } else { self.middle };
                self.of((middle, None), self.radius.larger(other.radius), None)
            }
        }
    }

    /// The number as an operand, if it is exact and has no more bits than one.
    pub(crate) fn operand(&self) -> Option<Operand> {
        let rounded = self.middle.to_f64();
        let exact = self.kind == Kind::Number && self.radius.is_zero() && self.middle.is_exactly(rounded);
        if exact { Operand::of(rounded) } else { None }
    }

    /// The same value, found in another way.
    pub(crate) fn found(&self, value: SoftFloat) -> Self {
        self.of(Limbs::from_soft(value), Radius::ZERO, self.separation)
    }

    /// The result, if it is decided: to the nearest `f64` if that is asked for, else as [`accepted`](Self::accepted).
    pub(crate) fn certified(&self, nearest: bool) -> Option<Certified> {
        let rounded = match self.kind {
            Kind::Number if nearest => self.enclosure().nearest()?,
            _ => {
                let (value, exact) = self.accepted()?;
                Rounded::to_nearest(value, exact)
            }
        };
        Some(Certified { rounded, error: self.enclosure().distance_of(rounded.value) })
    }
}

impl<const L: usize> Enclosure<L> {
    /// The nearest `f64`, where all numbers of it have the same one.
    fn nearest(&self) -> Option<Rounded> {
        let value = self.middle.to_f64();
        if self.radius.is_zero() {
            return Some(Rounded::to_nearest(value, self.middle.is_exactly(value)));
        }
        let (least, most) = self.ends();
        // a zero of either sign is the nearest where the ends are that small
        let agree = least.to_f64() == most.to_f64();
        agree.then(|| Rounded::to_nearest(value, false))
    }

    /// No number of it is farther than this from `value`; NaN of NaN.
    fn distance_of(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return value.abs();
        }
        let off = Self::of(self.middle.plus(Limbs::from_f64(-value)), self.radius);
        off.size().to_f64_above()
    }
}
