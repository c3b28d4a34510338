//! The one positive root of a polynomial with one change of sign, by Newton falling monotonically onto it.
//!
//! Let the nonzero coefficients of p = c0 + c1 x + .. + cn x^n be negative up to some power and positive above it. By
//! Descartes' rule p has exactly one positive root r, and so have, or have not, its derivatives below r: p rises and is
//! convex on [r, oo), and Newton from any bound above r falls onto r.
//!
//! The bound is Hong's: 2 max over negative c_j of min over positive c_m, m > j, of |c_j / c_m|^(1/(m-j)). Since at r
//! the positive terms outweigh each negative one, it is at most 2 n r; in whole powers of two, as taken here, at most
//! 16 n r. Integer arithmetic on exponents makes it exact: scaling the unknown by a power of two scales bound, iterates
//! and root by that power, bit for bit.
//!
//! With p = (x - r) q all coefficients of q are positive, so p' <= q (1 + (n-1)(x-r)/x) and one step leaves at most
//! the fraction t/(1+t), t = (n-1)(x-r)/x, of x - r: at most 1 - 1/n of it at first, and its square in the end.
//!
//! The root is well conditioned: r p'(r) is at least the sum of the positive terms at r. So the fall stops within a few
//! ulp, and one last step with p evaluated in double-double makes it the rounded root but for a last doubt.

use core::cmp::Ordering;

use crate::double_double::DoubleDouble;
use crate::float::{exponent, scale};
use crate::limits::MAX_DEGREE;

const MAX_TERMS: usize = MAX_DEGREE + 1;

/// The one positive root of c0 + c1 x + .. + cn x^n, `coefficients` being c0 to cn.
///
/// Coefficients other than zero must change sign once, from negative (low powers) to positive (high). NaN when they do
/// not (then there is no positive root, or more than one, or the sign is the wrong way round), when one is infinite or
/// NaN, and beyond degree [`MAX_DEGREE`]. Zeros are allowed everywhere: a vanishing c0 leaves the root of what is left
/// after division by x, a vanishing cn that of the lower degree. A root beyond the range of `f64` becomes zero or
/// infinite.
pub fn positive_root(coefficients: &[f64]) -> f64 {
    root_of(coefficients, |c| *c)
}

/// The same, of what `value` reads.
pub(crate) fn root_of<T>(coefficients: &[T], value: impl Fn(&T) -> f64) -> f64 {
    if coefficients.len() > MAX_TERMS || !coefficients.iter().all(|c| value(c).is_finite()) {
        return f64::NAN;
    }
    let term = |c: f64| (c != 0.0).then(|| Term { negative: c < 0.0, exponent: exponent(c).into() });
    let root = scaled_root(coefficients, |c| term(value(c)), |c, by| scale(value(c), by as i32));
    root.map_or(f64::NAN, |(root, bound)| scale(root, bound as i32))
}

/// The root in y = x / 2^bound, 0 < y < 1, and that bound; `None` unless the signs are right. `moved` multiplies a
/// coefficient by a power of two and rounds it.
pub(crate) fn scaled_root<T>(
    coefficients: &[T],
    term: impl Fn(&T) -> Option<Term>,
    moved: impl Fn(&T, i64) -> f64,
) -> Option<(f64, i64)> {
    let terms = terms(coefficients, term);
    let bound = bound(&terms)?;
    let scaled = scaled(coefficients, &terms, bound, moved);
    let polynomial = scaled.get(..coefficients.len()).unwrap_or(&scaled);
    Some((fall(polynomial), bound))
}

/// The polynomial in y, its largest coefficient scaled to [1, 2): nothing overflows, and what underflows is beyond the
/// last digit of the sum.
fn scaled<T>(
    coefficients: &[T],
    terms: &[Option<Term>; MAX_TERMS],
    bound: i64,
    moved: impl Fn(&T, i64) -> f64,
) -> [f64; MAX_TERMS] {
    let shifts: [i64; MAX_TERMS] = core::array::from_fn(|j| bound * j as i64);
    let tallest = terms.iter().zip(shifts).filter_map(|(term, shift)| Some(term.as_ref()?.exponent + shift)).max();
    let mut scaled = [0.0; MAX_TERMS];
    for ((slot, c), shift) in scaled.iter_mut().zip(coefficients).zip(shifts) {
        *slot = moved(c, shift - tallest.unwrap_or(0));
    }
    scaled
}

/// Falls from y = 1 onto the root of a scaled polynomial.
fn fall(polynomial: &[f64]) -> f64 {
    let mut y = 1.0;
    for _ in 0..steps(polynomial.len()) {
        let (value, slope) = horner(polynomial, y);
        let next = y - value / slope;
        // At the root rounding ends the descent; a NaN ends it too.
        if next.partial_cmp(&y) != Some(Ordering::Less) {
            break;
        }
        y = next;
    }
    let (_, slope) = horner(polynomial, y);
    y - wide_horner(polynomial, y) / slope
}

/// The polynomial and its derivative at `y`.
fn horner(polynomial: &[f64], y: f64) -> (f64, f64) {
    polynomial.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * y + c, slope * y + value))
}

/// The polynomial at `y`, evaluated in double-double and rounded once.
fn wide_horner(polynomial: &[f64], y: f64) -> f64 {
    polynomial.iter().rev().fold(DoubleDouble::from(0.0), |value, &c| value * y + c).round()
}

/// Steps that always suffice for a polynomial of `count` terms.
///
/// From 16 n r, n ln(32 n^2) steps lead below r (1 + 1/(2n)), where each step squares t <= 1/2: six more reach 2^-64.
pub(crate) fn steps(count: usize) -> usize {
    count * (4 + 2 * count.checked_ilog2().unwrap_or(0) as usize) + 10
}

/// Sign and exponent of a coefficient: all that the bound needs to know.
pub(crate) struct Term {
    pub(crate) negative: bool,
    /// Of the leading bit: 2^exponent <= |c| < 2^(exponent + 1).
    pub(crate) exponent: i64,
}

/// The terms of a polynomial, `None` for coefficients that are zero or missing.
pub(crate) fn terms<T>(coefficients: &[T], term: impl Fn(&T) -> Option<Term>) -> [Option<Term>; MAX_TERMS] {
    core::array::from_fn(|j| coefficients.get(j).and_then(&term))
}

/// The exponent of a power of two above the one positive root; `None` unless there is one change of sign, from
/// negative to positive.
pub(crate) fn bound(terms: &[Option<Term>; MAX_TERMS]) -> Option<i64> {
    let of_sign = |negative| {
        let power = move |(j, term): (usize, &'_ Option<Term>)| {
            let term = term.as_ref().filter(|term| term.negative == negative)?;
            Some((j as i64, term.exponent))
        };
        terms.iter().enumerate().filter_map(power)
    };
    let highest_negative = of_sign(true).map(|(j, _)| j).max()?;
    let lowest_positive = of_sign(false).map(|(m, _)| m).min()?;
    if lowest_positive < highest_negative {
        return None;
    }
    let ratios = |(j, low): (i64, i64)| of_sign(false).map(move |(m, high)| ceil_div(low - high + 1, m - j)).min();
    of_sign(true).filter_map(ratios).max().map(|ratio| ratio + 1)
}

/// The quotient rounded up; of a positive divisor.
fn ceil_div(a: i64, b: i64) -> i64 {
    // The maximum is `b`: it lets the compiler see that no division panics.
    -(-a).div_euclid(b.max(1))
}
