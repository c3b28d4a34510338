//! Roots of numbers and of polynomials in balls: by Newton's iteration, whose result is then bounded from what it leaves.

use core::cmp::Ordering;
use core::num::NonZero;

use super::limbs::Limbs;
use super::radius::Radius;
use super::separation::Root;
use super::{Ball, Kind};
use crate::root::{Term, scaled_root};

/// Steps that lead from the digits of `f64` to all of `L` words, each of which doubles them, and one for good measure.
fn steps(words: usize) -> u32 {
    (64 * words / 40).max(1).ilog2() + 2
}

impl<const L: usize> Ball<'_, L> {
    /// The real root of this degree; `start` gives that of an `f64`.
    pub(crate) fn root(&self, degree: u32, start: fn(f64) -> f64) -> Self {
        let number = self.decisions.next();
        let separation = || self.separation?.root(Root { number, degree: NonZero::new(degree)? });
        let without = |kind| Self::without_value(kind, self.decisions);
        let odd = degree % 2 == 1;
        match (self.kind, self.sign()) {
            (Kind::Number, Some(Ordering::Greater)) => {
                let (root, radius) = positive(self.middle, self.radius, degree, start);
                self.of((root, None), radius, separation())
            }
            (Kind::Number, Some(Ordering::Equal)) => self.clone(),
            (Kind::Number, Some(Ordering::Less)) if odd => self.negated().root(degree, start).negated(),
            // it increases: all of it lies between the roots of the largest magnitude and of its negative
            (Kind::Number, None) if odd => self.of((Limbs::ZERO, None), self.size().root(degree), separation()),
            (Kind::Number, Some(Ordering::Less)) | (Kind::Nothing, _) => without(Kind::Nothing),
            _ => without(Kind::Unknown),
        }
    }
}

/// The root of a number, positive and farther from zero than its error, and the error of that root.
///
/// With s the root of f, of degree d, and x a positive number, `|x - s| = |f - x^d|/(x^(d-1) + x^(d-2) s + .. + s^(d-1))`,
/// which is at most `|f - x^d|/x^(d-1)`; and the root of what is e away from f is at most e/s^(d-1) away from s.
fn positive<const L: usize>(middle: Limbs<L>, error: Radius, degree: u32, start: fn(f64) -> f64) -> (Limbs<L>, Radius) {
    let part = middle.exponent().div_euclid(degree.into());
    let radicand = middle.scaled(-i64::from(degree) * part);
    let mut root = Limbs::from_f64(start(radicand.to_f64()));
    for _ in 0..steps(L) {
        let (left, _) = residual(radicand, root, degree);
        if left.is_zero() {
            break;
        }
        let slope = (1..degree).fold(Limbs::from_integer(false, degree.into(), 0), |slope, _| slope.times(root).0);
        (root, _) = root.plus(left.over(slope).0);
        // a step leaves the square of what it takes off: with half of the digits right before, all are
        if left.exponent() < -(32 * L as i64) {
            break;
        }
    }
    let (left, cut) = residual(radicand, root, degree);
    let by_slope = |error: Radius| (1..degree).fold(error, |error, _| error.over(root.leading(), root.exponent()));
    let off = by_slope(Radius::new(left.leading(), left.exponent()).plus(cut));
    let scale = Radius::power_of_two;
    let carried = by_slope(error.times(scale(-i64::from(degree) * part)));
    (root.scaled(part), off.plus(carried).times(scale(part)))
}

/// `radicand - root^degree`, and what was cut off of it.
fn residual<const L: usize>(radicand: Limbs<L>, root: Limbs<L>, degree: u32) -> (Limbs<L>, Radius) {
    let size = Radius::new(root.leading(), root.exponent());
    let lost = |cut: Option<i64>| cut.map_or(Radius::ZERO, Radius::power_of_two);
    let (power, cut) = (1..degree).fold((root, Radius::ZERO), |(power, cut), _| {
        let (product, more) = power.times(root);
        (product, cut.times(size).plus(lost(more)))
    });
    let (left, more) = radicand.plus(power.negated());
    (left, cut.plus(lost(more)))
}

/// The one positive root of c0 + c1 x + .. + cn x^n; see [`positive_root`](crate::positive_root()).
pub(super) fn positive_root<'a, const L: usize>(context: &Ball<'a, L>, coefficients: &[Ball<'a, L>]) -> Ball<'a, L> {
    let without = |kind| Ball::without_value(kind, context.decisions);
    if coefficients.iter().any(|c| c.kind == Kind::Nothing) {
        return without(Kind::Nothing);
    }
    if coefficients.iter().any(|c| c.sign().is_none()) {
        return without(Kind::Unknown);
    }
    let term = |c: &Ball<L>| {
        let exponent = c.middle.exponent() - 1;
        (!c.middle.is_zero()).then(|| Term { negative: c.middle.is_negative(), exponent })
    };
    let moved = |c: &Ball<L>, by: i64| c.middle.scaled(by).to_f64();
    let Some((start, bound)) = scaled_root(coefficients, term, moved) else { return without(Kind::Nothing) };
    let start = Limbs::from_f64(start).scaled(bound);
    enclosed(context, coefficients, start).unwrap_or_else(|| without(Kind::Unknown))
}

/// The root near a start: the polynomial has opposite signs at both ends of the ball.
fn enclosed<'a, const L: usize>(
    context: &Ball<'a, L>,
    coefficients: &[Ball<'a, L>],
    start: Limbs<L>,
) -> Option<Ball<'a, L>> {
    let exact = |middle| Ball { middle, ..Ball::new(0.0, context.decisions) }.without_separation();
    let mut root = exact(start);
    for _ in 0..steps(L) {
        let (value, slope) = horner(coefficients, &root);
        let next = root.plus(&value.over(&slope).negated());
        root = exact(if next.kind == Kind::Number { next.middle } else { root.middle });
    }
    let (value, slope) = horner(coefficients, &root);
    let step = value.over(&slope);
    if step.kind != Kind::Number {
        return None;
    }
    // twice the largest step that is left, but not less than some units in the last place
    let units = Radius::power_of_two(root.middle.exponent() - 64 * L as i64 + 8);
    let reach = step.size().plus(units).times(Radius::power_of_two(1));
    let distance = exact(reach.upper());
    let sign_at = |x: Ball<'a, L>| {
        let x = exact(x.middle);
        (x.sign() == Some(Ordering::Greater)).then(|| horner(coefficients, &x).0.sign())?
    };
    let below = sign_at(root.plus(&distance.negated()))?;
    let above = sign_at(root.plus(&distance))?;
    let found = (below, above) == (Ordering::Less, Ordering::Greater);
    // the ends are rounded themselves
    let number = context.decisions.next();
    found.then(|| Ball { radius: reach.plus(units), number, ..root.without_separation() })
}

/// The polynomial and its derivative at `x`.
fn horner<'a, const L: usize>(coefficients: &[Ball<'a, L>], x: &Ball<'a, L>) -> (Ball<'a, L>, Ball<'a, L>) {
    let zero = || Ball::new(0.0, x.decisions);
    coefficients.iter().rev().fold((zero(), zero()), |(value, slope), c| {
        let next = slope.times(x).plus(&value);
        (value.times(x).plus(c), next)
    })
}
