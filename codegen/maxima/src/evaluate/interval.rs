//! `Interval`: two MPFR numbers with a real number between them, and functions of it rounded outwards.

use std::cmp::Ordering;

use rug::float::{Constant, Round};
use rug::ops::{AssignRound, CompleteRound, Pow};
use rug::{Float, Integer};

/// A closed interval; an end may be infinite, and none is NaN.
#[derive(Clone, Debug)]
pub(super) struct Interval {
    low: Float,
    high: Float,
}

/// Why there is no interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unknown {
    /// At this precision; at a higher one there may be.
    Undecided,
    /// At every precision.
    Unsupported,
}

pub(super) type Result<T> = std::result::Result<T, Unknown>;

/// Numbers below two to the minus of this are zero for everybody who asks for doubles.
const NOTHING: i32 = 1 << 20;

impl Interval {
    /// What is rounded down and up, to so many bits.
    pub(super) fn rounded<T>(precision: u32, value: T) -> Result<Self>
    where
        T: Copy,
        Float: AssignRound<T, Round = Round, Ordering = Ordering>,
    {
        let [low, high] = [Round::Down, Round::Up].map(|round| Float::with_val_round(precision, value, round).0);
        Self::of(low, high)
    }

    /// An interval with these ends.
    fn of(low: Float, high: Float) -> Result<Self> {
        if low.is_nan() || high.is_nan() || low > high { Err(Unknown::Undecided) } else { Ok(Self { low, high }) }
    }

    /// Ends by a function that never decreases.
    fn increasing<'a, T>(&'a self, function: impl Fn(&'a Float) -> T) -> Result<Self>
    where
        T: CompleteRound<Completed = Float, Prec = u32, Round = Round, Ordering = Ordering>,
    {
        let precision = self.low.prec();
        let low = function(&self.low).complete_round(precision, Round::Down).0;
        let high = function(&self.high).complete_round(precision, Round::Up).0;
        Self::of(low, high)
    }

    pub(super) fn pi(precision: u32) -> Result<Self> {
        Self::rounded(precision, Constant::Pi)
    }

    /// The number in the middle, if so many bits of it are those of all numbers of the interval; zero if all of them are.
    pub(super) fn value(&self, bits: u32) -> Option<Float> {
        if self.low.is_zero() && self.high.is_zero() {
            return Some(self.low.clone());
        }
        let precision = self.low.prec();
        let exponent = |end: &Float| if end.is_finite() { Some(end.get_exp().unwrap_or(i32::MIN)) } else { None };
        let (low, high) = (exponent(&self.low)?, exponent(&self.high)?);
        if low.max(high) < -NOTHING {
            return Some(Float::new(precision));
        }
        let width = Float::with_val_round(precision, &self.high - &self.low, Round::Up).0;
        let told = self.sign() != Some(Ordering::Equal)
            && self.sign().is_some()
            && width.get_exp().is_none_or(|width| i64::from(width) < i64::from(low.min(high)) - i64::from(bits));
        told.then(|| Float::with_val(precision, &self.low + &self.high) / 2u32)
    }

    /// The sign that all numbers of the interval have.
    pub(super) fn sign(&self) -> Option<Ordering> {
        let (low, high) = (self.low.cmp0()?, self.high.cmp0()?);
        (low == high).then_some(low)
    }

    /// Whether a number of the interval has a larger exponent.
    pub(super) fn is_beyond(&self, exponent: i32) -> bool {
        [&self.low, &self.high]
            .into_iter()
            .any(|end| end.is_infinite() || end.get_exp().is_some_and(|end| end > exponent))
    }

    /// Which is larger; `None` where they overlap.
    pub(super) fn order(&self, other: &Self) -> Option<Ordering> {
        match (self.high.partial_cmp(&other.low)?, self.low.partial_cmp(&other.high)?) {
            (Ordering::Less, _) => Some(Ordering::Less),
            (_, Ordering::Greater) => Some(Ordering::Greater),
            (Ordering::Equal, Ordering::Equal) => Some(Ordering::Equal),
            _ => None,
        }
    }

    pub(super) fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    pub(super) fn add(&self, other: &Self) -> Result<Self> {
        let precision = self.low.prec();
        let low = Float::with_val_round(precision, &self.low + &other.low, Round::Down).0;
        let high = Float::with_val_round(precision, &self.high + &other.high, Round::Up).0;
        Self::of(low, high)
    }

    pub(super) fn sub(&self, other: &Self) -> Result<Self> {
        self.add(&other.clone().neg())
    }

    pub(super) fn mul(&self, other: &Self) -> Result<Self> {
        self.extremes(other, |a, b, precision, round| {
            // an infinite end stands for numbers, zero times each of which is zero
            if a.is_zero() || b.is_zero() {
                return Float::new(precision);
            }
            Float::with_val_round(precision, a * b, round).0
        })
    }

    pub(super) fn div(&self, other: &Self) -> Result<Self> {
        match other.sign() {
            Some(Ordering::Less | Ordering::Greater) => {
                self.extremes(other, |a, b, precision, round| Float::with_val_round(precision, a / b, round).0)
            }
            _ => Err(Unknown::Undecided),
        }
    }

    /// Of an operation that is monotone in each of both numbers: its least and its greatest value at the ends.
    fn extremes(&self, other: &Self, operation: impl Fn(&Float, &Float, u32, Round) -> Float) -> Result<Self> {
        let precision = self.low.prec();
        let ends = [&self.low, &self.high].into_iter().flat_map(|a| [(a, &other.low), (a, &other.high)]);
        let at = |round| ends.clone().map(move |(a, b)| (a, b, round)).map(|(a, b, r)| operation(a, b, precision, r));
        if at(Round::Down).any(|value| value.is_nan()) {
            return Err(Unknown::Undecided);
        }
        let low = at(Round::Down).reduce(|least, next| least.min(&next)).ok_or(Unknown::Undecided)?;
        let high = at(Round::Up).reduce(|most, next| most.max(&next)).ok_or(Unknown::Undecided)?;
        Self::of(low, high)
    }

    /// The magnitude.
    pub(super) fn abs(self) -> Self {
        match (self.low.is_sign_negative(), self.high.is_sign_negative()) {
            (false, _) => self,
            (true, true) => self.neg(),
            (true, false) => {
                let high = (-self.low).max(&self.high);
                Self { low: Float::new(high.prec()), high }
            }
        }
    }

    /// Without the numbers below `least`, at which something real is known not to be.
    fn at_least(self, least: i32) -> Result<Self> {
        if self.high < least {
            return Err(Unknown::Undecided);
        }
        let low = if self.low < least { Float::with_val(self.low.prec(), least) } else { self.low };
        Self::of(low, self.high)
    }

    /// A root of this degree: of an even one, of the numbers that are not negative.
    pub(super) fn root(self, degree: u32) -> Result<Self> {
        let radicand = if degree.is_multiple_of(2) { self.at_least(0)? } else { self };
        radicand.increasing(|end| end.root_ref(degree))
    }

    /// A whole power.
    pub(super) fn power(self, exponent: &Integer) -> Result<Self> {
        if exponent.is_negative() {
            let one = Self::rounded(self.low.prec(), 1)?;
            return one.div(&self.power(&Integer::from(-exponent))?);
        }
        let base = if exponent.is_even() { self.abs() } else { self };
        base.increasing(|end| end.pow(exponent))
    }

    /// A power that is no number in the text, of a positive number.
    pub(super) fn real_power(self, exponent: &Self) -> Result<Self> {
        exponent.mul(&self.function("log")?)?.function("exp")
    }

    /// The larger of two numbers.
    pub(super) fn max(self, other: &Self) -> Self {
        Self { low: self.low.max(&other.low), high: self.high.max(&other.high) }
    }

    /// A function whose values are integers, where all numbers of the interval have the same.
    pub(super) fn step(&self, function: fn(Float) -> Float) -> Result<Self> {
        let (low, high) = (function(self.low.clone()), function(self.high.clone()));
        if low == high { Self::of(low, high) } else { Err(Unknown::Undecided) }
    }

    /// The angle of a point.
    pub(super) fn angle(y: &Self, x: &Self) -> Result<Self> {
        let precision = x.low.prec();
        let pi = || Self::pi(precision);
        let quarter = || pi()?.div(&Self::rounded(precision, 2)?);
        match (y.sign(), x.sign()) {
            (_, Some(Ordering::Greater)) => y.div(x)?.function("atan"),
            (Some(Ordering::Greater), _) => quarter()?.sub(&x.div(y)?.function("atan")?),
            (Some(Ordering::Less), _) => quarter()?.neg().sub(&x.div(y)?.function("atan")?),
            (Some(Ordering::Equal), Some(Ordering::Less)) => pi(),
            _ => Err(Unknown::Undecided),
        }
    }

    /// A function of one argument, by name.
    pub(super) fn function(self, name: &str) -> Result<Self> {
        match name {
            "sqrt" => self.root(2),
            "abs" => Ok(self.abs()),
            "exp" => self.increasing(Float::exp_ref),
            "log" if self.low > 0 => self.increasing(Float::ln_ref),
            "log" => Err(Unknown::Undecided),
            "sin" => self.wave(|middle, precision, round| middle.sin_ref().complete_round(precision, round).0),
            "cos" => self.wave(|middle, precision, round| middle.cos_ref().complete_round(precision, round).0),
            "tan" => self.clone().function("sin")?.div(&self.function("cos")?),
            "asin" => self.within_one()?.increasing(Float::asin_ref),
            "acos" => {
                let quarter = Self::pi(self.low.prec())?.div(&Self::rounded(self.low.prec(), 2)?)?;
                quarter.sub(&self.function("asin")?)
            }
            "atan" => self.increasing(Float::atan_ref),
            "sinh" => self.increasing(Float::sinh_ref),
            "cosh" => self.abs().increasing(Float::cosh_ref),
            "tanh" => self.increasing(Float::tanh_ref),
            "asinh" => self.increasing(Float::asinh_ref),
            "acosh" => self.at_least(1)?.increasing(Float::acosh_ref),
            "atanh" if self.low > -1 && self.high < 1 => self.increasing(Float::atanh_ref),
            "atanh" => Err(Unknown::Undecided),
            "signum" => {
                let sign = self.sign().ok_or(Unknown::Undecided)?;
                Self::rounded(self.low.prec(), sign as i32)
            }
            _ => Err(Unknown::Unsupported),
        }
    }

    /// Without the numbers beyond one, which have no arcsine.
    fn within_one(self) -> Result<Self> {
        Ok(self.at_least(-1)?.neg().at_least(-1)?.neg())
    }

    /// Sine or cosine, which nowhere change faster than their argument: that of the middle, and as much beside it.
    fn wave(&self, function: impl Fn(&Float, u32, Round) -> Float) -> Result<Self> {
        let precision = self.low.prec();
        if !self.low.is_finite() || !self.high.is_finite() {
            return Err(Unknown::Undecided);
        }
        let middle = Float::with_val(precision, &self.low + &self.high) / 2u32;
        // the middle itself is rounded: what is beside it is at most the whole width
        let beside = Float::with_val_round(precision, &self.high - &self.low, Round::Up).0;
        let (low, high) = (function(&middle, precision, Round::Down), function(&middle, precision, Round::Up));
        let low = Float::with_val_round(precision, low - &beside, Round::Down).0;
        let high = Float::with_val_round(precision, high + &beside, Round::Up).0;
        Self::of(low, high)?.within_one()
    }
}

#[cfg(test)]
mod tests;
