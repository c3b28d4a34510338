//! Ranges: interval arithmetic over rational numbers, without any rounding.

use super::set::Sign;
use crate::polynomial::{Atom, Polynomial};
use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering;

/// Where a range ends.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// Nowhere below.
    Below,
    /// At a number.
    At(BigRational),
    /// Nowhere above.
    Above,
}

/// One end of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
struct End {
    place: Place,
    /// Whether the number there belongs to the range.
    closed: bool,
}

/// All numbers between two ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Range {
    low: End,
    high: End,
}

impl End {
    fn at(value: BigRational, closed: bool) -> Self {
        Self { place: Place::At(value), closed }
    }

    fn nowhere(place: Place) -> Self {
        Self { place, closed: false }
    }

    fn order(&self) -> Ordering {
        match &self.place {
            Place::Below => Ordering::Less,
            Place::At(value) => value.cmp(&BigRational::zero()),
            Place::Above => Ordering::Greater,
        }
    }

    fn negated(&self) -> Self {
        let place = match &self.place {
            Place::Below => Place::Above,
            Place::At(value) => Place::At(-value),
            Place::Above => Place::Below,
        };
        Self { place, closed: self.closed }
    }

    /// The sum of two ends on the same side.
    fn plus(&self, other: &Self) -> Self {
        match (&self.place, &other.place) {
            (Place::At(a), Place::At(b)) => Self::at(a + b, self.closed && other.closed),
            (Place::At(_), nowhere) | (nowhere, _) => Self::nowhere(nowhere.clone()),
        }
    }

    /// The product of two ends. Zero times anything is zero, and is met where that zero is.
    fn times(&self, other: &Self) -> Self {
        match (self.order(), other.order()) {
            (Ordering::Equal, Ordering::Equal) => Self::at(BigRational::zero(), self.closed || other.closed),
            (Ordering::Equal, _) => self.clone(),
            (_, Ordering::Equal) => other.clone(),
            (a, b) => match (&self.place, &other.place) {
                (Place::At(x), Place::At(y)) => Self::at(x * y, self.closed && other.closed),
                _ => Self::nowhere(if a == b { Place::Above } else { Place::Below }),
            },
        }
    }

    fn raised(&self, exponent: u32) -> Self {
        (1..exponent).fold(self.clone(), |power, _| power.times(self))
    }

    /// The lower one; of two at one place the closed one.
    fn lower(self, other: Self) -> Self {
        let before = self.place.cmp(&other.place).then(other.closed.cmp(&self.closed)).is_le();
        if before { self } else { other }
    }

    /// The higher one; of two at one place the closed one.
    fn higher(self, other: Self) -> Self {
        let after = self.place.cmp(&other.place).then(self.closed.cmp(&other.closed)).is_ge();
        if after { self } else { other }
    }
}

impl Range {
    /// What is known of an atom: its sign, and of polynomials those of its differences from numbers.
    pub(super) fn of(atom: Atom, sign: Sign, known: &[(Polynomial, Sign)]) -> Self {
        let of_fact = |(known, sign): &(Polynomial, Sign)| {
            let coefficients = known.coefficients(atom);
            let [rest, slope] = coefficients.as_slice() else { return None };
            let (rest, slope) = (rest.as_constant()?, slope.as_constant()?);
            let offset = Self::of_sign(sign.times(Sign::of(&slope)));
            Some(offset.plus(&Self::number(-rest / slope)))
        };
        known.iter().filter_map(of_fact).fold(Self::of_sign(sign), |range, fact| range.and(fact))
    }

    fn of_sign(sign: Sign) -> Self {
        let zero = End::at(BigRational::zero(), sign.zero);
        Self {
            low: if sign.negative { End::nowhere(Place::Below) } else { zero.clone() },
            high: if sign.positive { End::nowhere(Place::Above) } else { zero },
        }
    }

    /// One number.
    pub(super) fn number(value: BigRational) -> Self {
        let end = End::at(value, true);
        Self { low: end.clone(), high: end }
    }

    /// The signs of its numbers.
    pub(super) fn sign(&self) -> Sign {
        let (low, high) = (self.low.order(), self.high.order());
        let up_to_zero = low.is_lt() || low.is_eq() && self.low.closed;
        let down_to_zero = high.is_gt() || high.is_eq() && self.high.closed;
        Sign { negative: low.is_lt(), zero: up_to_zero && down_to_zero, positive: high.is_gt() }
    }

    /// Whether it has an end besides zero, which its sign does not tell.
    pub(super) fn is_more_than_a_sign(&self) -> bool {
        [&self.low, &self.high].into_iter().any(|end| matches!(&end.place, Place::At(value) if !value.is_zero()))
    }

    /// How far its ends are apart, if it has two.
    pub(super) fn width(&self) -> Option<BigRational> {
        match (&self.low.place, &self.high.place) {
            (Place::At(low), Place::At(high)) => Some(high - low),
            _ => None,
        }
    }

    /// A number in its middle; one step inside where it has one end.
    pub(super) fn middle(&self) -> BigRational {
        let one = || BigRational::from_integer(1.into());
        match (&self.low.place, &self.high.place) {
            (Place::At(low), Place::At(high)) => (low + high) / (one() + one()),
            (Place::At(low), _) => low + one(),
            (_, Place::At(high)) => high - one(),
            _ => BigRational::zero(),
        }
    }

    /// What is in both.
    fn and(self, other: Self) -> Self {
        let nearer = |a: End, b: End, order: Ordering| match a.place.cmp(&b.place) {
            Ordering::Equal => End { closed: a.closed && b.closed, ..a },
            found if found == order => a,
            _ => b,
        };
        let low = nearer(self.low, other.low, Ordering::Greater);
        Self { low, high: nearer(self.high, other.high, Ordering::Less) }
    }

    /// The two halves of a range that has a middle.
    pub(super) fn halves(&self) -> [Self; 2] {
        let middle = End::at(self.middle(), true);
        [Self { low: self.low.clone(), high: middle.clone() }, Self { low: middle, high: self.high.clone() }]
    }

    /// All sums.
    pub(super) fn plus(&self, other: &Self) -> Self {
        Self { low: self.low.plus(&other.low), high: self.high.plus(&other.high) }
    }

    /// All products: they lie between products of ends.
    pub(super) fn times(&self, other: &Self) -> Self {
        let [a, b] = [&self.low, &self.high].map(|end| [end.times(&other.low), end.times(&other.high)]);
        let ([a, b], [c, d]) = (a, b);
        let low = a.clone().lower(b.clone()).lower(c.clone().lower(d.clone()));
        Self { low, high: a.higher(b).higher(c.higher(d)) }
    }

    /// All powers: those of an even exponent are powers of magnitudes.
    pub(super) fn power(&self, exponent: u32) -> Self {
        let base = if exponent.is_multiple_of(2) { self.magnitude() } else { self.clone() };
        Self { low: base.low.raised(exponent), high: base.high.raised(exponent) }
    }

    fn magnitude(&self) -> Self {
        let negated = || Self { low: self.high.negated(), high: self.low.negated() };
        let sign = self.sign();
        match (sign.negative, sign.positive) {
            (false, _) => self.clone(),
            (true, false) => negated(),
            (true, true) => {
                Self { low: End::at(BigRational::zero(), true), high: self.high.clone().higher(negated().high) }
            }
        }
    }
}
