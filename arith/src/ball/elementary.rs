//! Elementary functions in balls: exponential function, logarithm, and those of the circle.
//!
//! Each is found at the middle of a ball, by a series whose remainder is bounded, in enclosures that bound all roundings; then
//! what the function makes of the radius is added. The error model lists the inequalities.

use core::cmp::Ordering;

use super::enclosure::Enclosure;
use super::limbs::Limbs;
use super::radius::Radius;
use super::{Ball, Decisions, Kind};
use crate::float;
use crate::soft_float::SoftFloat;

/// Arguments of the exponential function are less than 2 to this: the exponent of its value then has room for products.
const LARGEST_EXPONENT: i64 = 40;

impl<'a, const L: usize> Ball<'a, L> {
    /// The ball of a function, by the enclosure of its values; unknown where there is none.
    fn through(&self, function: impl FnOnce(Enclosure<L>) -> Option<Enclosure<L>>) -> Self {
        match self.kind {
            Kind::Number => match function(self.enclosure()) {
                Some(value) => self.enclosed_in(value, None),
                None => Self::without_value(Kind::Unknown, self.decisions),
            },
            kind => Self::without_value(kind, self.decisions),
        }
    }

    fn is_exactly_zero(&self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }

    /// The exponential function.
    pub(crate) fn exp(&self) -> Self {
        if self.is_exactly_zero() {
            return Ball::new(1.0, self.decisions);
        }
        self.through(exp)
    }

    /// The natural logarithm.
    pub(crate) fn ln(&self) -> Self {
        match self.sign() {
            Some(Ordering::Less | Ordering::Equal) => Self::without_value(Kind::Nothing, self.decisions),
            Some(Ordering::Greater) if self.radius.is_zero() && self.middle.is_exactly(1.0) => {
                Ball::new(0.0, self.decisions)
            }
            Some(Ordering::Greater) => self.through(ln),
            None => self.through(|_| None),
        }
    }

    /// The sine.
    pub(crate) fn sin(&self) -> Self {
        if self.is_exactly_zero() { self.clone() } else { self.through(|x| Some(sin_cos(x).0)) }
    }

    /// The cosine.
    pub(crate) fn cos(&self) -> Self {
        if self.is_exactly_zero() { Ball::new(1.0, self.decisions) } else { self.through(|x| Some(sin_cos(x).1)) }
    }

    /// The tangent.
    pub(crate) fn tan(&self) -> Self {
        let quotient = |x| {
            let (sine, cosine) = sin_cos(x);
            sine.over(cosine)
        };
        if self.is_exactly_zero() { self.clone() } else { self.through(quotient) }
    }

    /// The angle of this tangent, between minus and plus a right angle.
    pub(crate) fn atan(&self) -> Self {
        if self.is_exactly_zero() { self.clone() } else { self.through(atan) }
    }

    /// The angle of this sine, by that of its tangent `x/sqrt(1 - x^2)`.
    pub(crate) fn asin(&self) -> Self {
        let right_angle = || self.enclosed_in(Enclosure::pi(-1), None);
        let rest = self.besides(-1.0).times(&self.besides(1.0));
        match rest.sign() {
            Some(Ordering::Greater) => self.over(&rest.root(2, float::sqrt)).atan(),
            Some(Ordering::Equal) if self.middle.is_negative() => right_angle().negated(),
            Some(Ordering::Equal) => right_angle(),
            Some(Ordering::Less) => Self::without_value(Kind::Nothing, self.decisions),
            None => self.without_a_tangent(&rest),
        }
    }

    /// The angle of this cosine, twice that of the tangent `sqrt((1 - x)/(1 + x))`.
    pub(crate) fn acos(&self) -> Self {
        let (below, above) = (self.besides(-1.0), self.besides(1.0));
        match (below.sign(), above.sign()) {
            (Some(Ordering::Less), _) | (_, Some(Ordering::Less)) => Self::without_value(Kind::Nothing, self.decisions),
            (_, Some(Ordering::Equal)) => self.enclosed_in(Enclosure::pi(0), None),
            (Some(_), Some(_)) => {
                let half = below.over(&above).root(2, float::sqrt).atan();
                half.plus(&half)
            }
            _ => self.without_a_tangent(&below.times(&above)),
        }
    }

    /// What stands for the angle where it is open whether the number is one at the end of the domain.
    fn without_a_tangent(&self, rest: &Self) -> Self {
        Self::without_value(if rest.kind == Kind::Nothing { rest.kind } else { Kind::Unknown }, self.decisions)
    }

    /// How far the number is above -1 or, with the other sign, below 1.
    fn besides(&self, one: f64) -> Self {
        let number = if one < 0.0 { self.negated() } else { self.clone() };
        number.plus(&Ball::new(1.0, self.decisions))
    }

    /// A number of 128 bits, as it is.
    pub(crate) fn of_soft(value: SoftFloat, decisions: &'a Decisions) -> Self {
        if value.is_nan() {
            Self::without_value(Kind::Nothing, decisions)
        } else {
            Ball::new(0.0, decisions).found(value)
        }
    }

    /// Its first 128 bits, if they are certain to 2^-120; NaN where there is no value.
    pub(crate) fn to_soft(&self) -> Option<SoftFloat> {
        match self.kind {
            Kind::Nothing => Some(SoftFloat::NAN),
            Kind::Unknown => None,
            Kind::Number => {
                let right = self.radius.is_less_than(self.middle.leading(), self.middle.exponent().saturating_sub(120));
                (self.radius.is_zero() || right).then(|| self.middle.to_soft())
            }
        }
    }
}

/// Steps of a method that takes the digits of `f64` to all of `L` words, each of which makes them five times as many.
fn steps(words: usize) -> u32 {
    let (mut digits, mut steps) = (50, 0);
    while digits < 64 * words {
        (digits, steps) = (5 * digits, steps + 1);
    }
    steps
}

/// |e^(a + d) - e^a| <= e^a |d| (1 + |d|) for |d| <= 1. What is less than e^-(2^40) lies between 0 and 2^-(2^40).
fn exp<const L: usize>(x: Enclosure<L>) -> Option<Enclosure<L>> {
    if x.middle.exponent() > LARGEST_EXPONENT {
        let half = 1_i64 << LARGEST_EXPONENT;
        let is_below = x.middle.is_negative() && x.radius.is_less_than(0.5, 1);
        return is_below.then(|| Enclosure::integer(1, -half).widened(Radius::power_of_two(-half)));
    }
    let value = exp_of(x.middle);
    if x.radius.is_zero() {
        return Some(value);
    }
    let spread = x.radius.plus(x.radius.times(x.radius));
    x.radius.is_less_than(0.5, 1).then(|| value.widened(value.size().times(spread)))
}

/// e^a = 2^k (e^s)^(2^h) with s = (a - k ln 2)/2^h, and e^s by its series: with |s| < 2^-h, what follows the first n terms is less
/// than 2 |s|^n/n!.
fn exp_of<const L: usize>(a: Limbs<L>) -> Enclosure<L> {
    let twos = a.to_f64() * core::f64::consts::LOG2_E;
    let twos = (twos + if twos < 0.0 { -0.5 } else { 0.5 }) as i64;
    let multiple = Enclosure::exact(Limbs::from_integer(twos > 0, twos.unsigned_abs(), 0)).times(Enclosure::ln_2());
    let halvings = [4, 8, 16, 32].into_iter().find(|halvings| halvings * halvings >= 16 * L as i64).unwrap_or(32);
    let s = Enclosure::exact(a).plus(multiple).scaled(-halvings);
    let (mut terms, mut digits) = (0_u64, 0);
    while digits < 64 * L as i64 + halvings {
        terms += 1;
        digits += halvings + floor_log2(terms);
    }
    let one = Enclosure::integer(1, 0);
    let series = (1..terms).rev().fold(one, |sum, term| one.plus(s.times(sum).over_integer(term)));
    let power = series.widened(Radius::power_of_two(1 - digits));
    (0..halvings).fold(power, |power, _| power.times(power)).scaled(twos)
}

/// |ln(a + d) - ln a| <= |d|/(a - |d|) <= 2 |d|/a for |d| < a/2.
fn ln<const L: usize>(x: Enclosure<L>) -> Option<Enclosure<L>> {
    let (value, exponent) = (x.middle.leading(), x.middle.exponent());
    let is_near = x.radius.is_less_than(value, exponent - 1);
    is_near.then(|| ln_of(x.middle))?.map(|ln| ln.widened(x.radius.over(value, exponent - 1)))
}

/// ln a = k ln 2 + z + 2 artanh s with a = 2^k f, f from 3/4 to 3/2, and s = (f - e^z)/(f + e^z). For |s| < 1/2 the series
/// artanh s = s + s^3/3 + .. is off by less than |s|^5/2 after two terms.
fn ln_of<const L: usize>(a: Limbs<L>) -> Option<Enclosure<L>> {
    let twos = a.exponent() - i64::from(a.leading() < 0.75);
    let fraction = Enclosure::exact(a.scaled(-twos));
    let mut z = Enclosure::exact(Limbs::from_f64(libm::log(fraction.middle.to_f64())));
    for _ in 0..steps(L) {
        let power = exp_of(z.middle);
        let s = fraction.plus(power.negated()).over(fraction.plus(power))?;
        s.size().is_less_than(0.5, 0).then_some(())?;
        let (square, size) = (s.times(s), s.size());
        let rest = size.times(size).times(size).times(size).times(size);
        let step = s.plus(s.times(square).over_integer(3)).scaled(1).widened(rest);
        z = Enclosure::exact(z.middle).plus(step);
    }
    let sign = twos < 0;
    Some(z.plus(Enclosure::exact(Limbs::from_integer(sign, twos.unsigned_abs(), 0)).times(Enclosure::ln_2())))
}

/// Sine and cosine: |sin(a + d) - sin a| <= |d|, and both lie between -1 and 1.
fn sin_cos<const L: usize>(x: Enclosure<L>) -> (Enclosure<L>, Enclosure<L>) {
    let anything = Enclosure::exact(Limbs::ZERO).widened(Radius::power_of_two(0));
    match sin_cos_of(x.middle) {
        Some((sine, cosine)) if x.radius.is_less_than(0.5, 1) => (sine.widened(x.radius), cosine.widened(x.radius)),
        _ => (anything, anything),
    }
}

/// Of a = k pi/2 + r with |r| <= 1, by the series of r; `None` of an argument that leaves r too few digits.
fn sin_cos_of<const L: usize>(a: Limbs<L>) -> Option<(Enclosure<L>, Enclosure<L>)> {
    if a.exponent() > 32 * L as i64 {
        return None;
    }
    let right_angle = Enclosure::<L>::pi(-1);
    let half = Limbs::from_integer(a.is_negative(), 1, -1);
    let (turns, quadrant) = a.over(right_angle.middle).0.plus(half).0.whole()?;
    let rest = Enclosure::exact(a).plus(Enclosure::exact(turns).times(right_angle).negated());
    rest.size().is_less_than(0.5, 1).then_some(())?;
    let (sine, cosine) = (sine_of_rest(rest), cosine_of_rest(rest));
    let quadrant = if a.is_negative() { 4 - quadrant } else { quadrant };
    Some(match quadrant % 4 {
        0 => (sine, cosine),
        1 => (cosine, sine.negated()),
        2 => (sine.negated(), cosine.negated()),
        _ => (cosine.negated(), sine),
    })
}

/// The logarithm of a positive integer to base 2, rounded down; without the panic of zero's.
fn floor_log2(n: u64) -> i64 {
    63 - i64::from(n.leading_zeros())
}

/// How many terms of the series of sine and cosine at numbers up to 1 leave less than 2^-digits, and these digits.
fn terms<const L: usize>() -> (u64, i64) {
    let (mut terms, mut digits) = (1_u64, 0);
    while digits < 64 * L as i64 {
        digits += floor_log2(2 * terms - 1) + floor_log2(2 * terms);
        terms += 1;
    }
    (terms, digits)
}

/// r (1 - r^2/(2 3) (1 - r^2/(4 5) (1 - ..))); what follows is less than the first term left out.
fn sine_of_rest<const L: usize>(r: Enclosure<L>) -> Enclosure<L> {
    let (terms, digits) = terms::<L>();
    let (square, one) = (r.times(r), Enclosure::integer(1, 0));
    let next =
        |sum: Enclosure<L>, term: u64| one.plus(square.times(sum).over_integer(2 * term * (2 * term + 1)).negated());
    r.times((1..terms).rev().fold(one, next).widened(Radius::power_of_two(-digits)))
}

/// 1 - r^2/(1 2) (1 - r^2/(3 4) (1 - ..)); what follows is less than the first term left out.
fn cosine_of_rest<const L: usize>(r: Enclosure<L>) -> Enclosure<L> {
    let (terms, digits) = terms::<L>();
    let (square, one) = (r.times(r), Enclosure::integer(1, 0));
    let next =
        |sum: Enclosure<L>, term: u64| one.plus(square.times(sum).over_integer((2 * term - 1) * 2 * term).negated());
    (1..terms).rev().fold(one, next).widened(Radius::power_of_two(-digits))
}

/// |atan(a + d) - atan a| <= |d|, and |atan a| < 2.
fn atan<const L: usize>(x: Enclosure<L>) -> Option<Enclosure<L>> {
    Some(atan_of(x.middle)?.widened(x.radius))
}

/// atan a = z + atan t with t = (a cos z - sin z)/(cos z + a sin z). For |t| < 1/2 the series atan t = t - t^3/3 + .. is off by less
/// than |t|^5 after two terms.
fn atan_of<const L: usize>(a: Limbs<L>) -> Option<Enclosure<L>> {
    let number = Enclosure::exact(a);
    let mut z = Enclosure::exact(Limbs::from_f64(libm::atan(a.to_f64())));
    for _ in 0..steps(L) {
        let (sine, cosine) = sin_cos_of(z.middle)?;
        let t = number.times(cosine).plus(sine.negated()).over(cosine.plus(number.times(sine)))?;
        t.size().is_less_than(0.5, 0).then_some(())?;
        let (square, size) = (t.times(t), t.size());
        let rest = size.times(size).times(size).times(size).times(size);
        let step = t.plus(t.times(square).over_integer(3).negated()).widened(rest);
        z = Enclosure::exact(z.middle).plus(step);
    }
    Some(z)
}
