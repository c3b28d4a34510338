//! Polynomials of operands with 53 bits, exactly: a sum of products as one long integer.
//!
//! Every finite `f64` is an integer times a power of two, hence so is every product of them, and a sum of such products
//! is one integer in units of the least power. It fits in a fixed number of words for every finite `f64`, so nothing
//! over- or underflows, nothing is rounded, and nothing allocates. Operands with other exponents may lie farther apart:
//! then the terms that are near the largest are summed, and the rest only where these cancel to zero. It is slow, and
//! meant for the rare point at which a polynomial cancels so far that double-double cannot tell its digits.

use crate::limits::{MAX_FACTORS, MAX_TERMS};
use crate::operand::Operand;
use crate::soft_float::SoftFloat;
use crate::terms::{Term, Terms};

/// Bits of a significand.
const SIGNIFICAND: i64 = f64::MANTISSA_DIGITS as i64;

/// Words of a product of significands.
const PRODUCT_WORDS: usize = MAX_FACTORS * SIGNIFICAND as usize / 64 + 1;

/// Words of any sum: exponents of a product span at most 2098 a factor; two more for signs and carries.
const LONGEST: usize = MAX_FACTORS * 2098 / 64 + 3;

/// Words that most sums need: those whose terms are of similar size.
const SHORT: usize = 32;

/// How many bits below the unit of a sum other terms leave its first 128 alone: those, and carries of all terms.
const GAP: i64 = 128 + MAX_TERMS.ilog2() as i64;

/// A sum of products of operands; `None` where terms lie so far apart that their sum is longer than any of `f64`.
#[inline(never)]
pub(crate) fn polynomial(factor: &dyn Fn(u8) -> Option<Operand>, terms: Terms) -> Option<SoftFloat> {
    let mut below = i64::MAX;
    loop {
        let spans = || terms.filter_map(|term| span(factor, term.factors)).filter(|(_, high)| *high < below);
        let Some(highest) = spans().map(|(_, high)| high).max() else { return Some(SoftFloat::ZERO) };
        let all = spans().map(|(low, _)| low).min().unwrap_or(highest);
        let fits = |lowest: i64| usize::try_from((highest - lowest) / 64 + 3).ok().filter(|used| *used <= LONGEST);
        let (lowest, used) = match fits(all) {
            Some(used) => (all, used),
            None => {
                let near = bottom(spans, highest);
                (near, fits(near)?)
            }
        };
        let near = Near { lowest, below };
        let sum = if used <= SHORT {
            Sum([0; SHORT]).of(factor, terms, near, used)
        } else {
            Sum([0; LONGEST]).of(factor, terms, near, used)
        };
        if !sum.is_zero() {
            return Some(sum);
        }
        below = lowest;
    }
}

/// The least exponent of the terms that lie one after another without a gap, from the highest on.
fn bottom<S: Iterator<Item = (i64, i64)>>(spans: impl Fn() -> S, highest: i64) -> i64 {
    let mut bottom = highest;
    while let Some(lower) =
        spans().filter(|(low, high)| *low < bottom && high + GAP >= bottom).map(|(low, _)| low).min()
    {
        bottom = lower;
    }
    bottom
}

/// The terms that are summed: those whose bits lie from `lowest` on, and below the power of two `below`.
#[derive(Clone, Copy)]
struct Near {
    lowest: i64,
    below: i64,
}

/// The exponents of the unit of a product and of a power of two above it; `None` for zero.
fn span(factor: &dyn Fn(u8) -> Option<Operand>, factors: &[u8]) -> Option<(i64, i64)> {
    let mut low = 0_i64;
    for &position in factors {
        let operand = factor(position)?;
        if operand.significand == 0 {
            return None;
        }
        low = low.saturating_add(operand.exponent);
    }
    Some((low, low.saturating_add(SIGNIFICAND * factors.len() as i64)))
}

/// A product of significands, and the exponent of its unit.
struct Product {
    negative: bool,
    words: [u64; PRODUCT_WORDS],
    /// How many words are not zero, the low ones.
    used: usize,
    exponent: i64,
}

impl Product {
    /// `None` for zero.
    fn of(factor: &dyn Fn(u8) -> Option<Operand>, term: Term) -> Option<Self> {
        let mut product = Product { negative: term.negative, words: [0; PRODUCT_WORDS], used: 1, exponent: 0 };
        *product.words.first_mut()? = 1;
        for &position in term.factors {
            let Operand { negative, significand, exponent } = factor(position)?;
            if significand == 0 {
                return None;
            }
            product.negative ^= negative;
            product.exponent = product.exponent.saturating_add(exponent);
            let mut carry = 0;
            for word in product.words.iter_mut().take(product.used) {
                let extended = u128::from(*word) * u128::from(significand) + u128::from(carry);
                *word = extended as u64;
                carry = (extended >> 64) as u64;
            }
            if carry != 0 {
                *product.words.get_mut(product.used)? = carry;
                product.used += 1;
            }
        }
        Some(product)
    }
}

/// A long integer, in two's complement, least word first.
struct Sum<const WORDS: usize>([u64; WORDS]);

impl<const WORDS: usize> Sum<WORDS> {
    /// The sum of the terms that are near each other, in the low `used` words.
    fn of(mut self, factor: &dyn Fn(u8) -> Option<Operand>, terms: Terms, near: Near, used: usize) -> SoftFloat {
        let Near { lowest, below } = near;
        let here = |(low, high)| low >= lowest && high < below;
        let terms = terms.filter(|term| span(factor, term.factors).is_some_and(here));
        let products = terms.filter_map(|term| Product::of(factor, term));
        products.for_each(|product| self.add(&product, product.exponent - lowest, used));
        self.leading(lowest, used)
    }

    /// Adds a product, shifted up.
    fn add(&mut self, product: &Product, shift: i64, used: usize) {
        let (skip, bits) = ((shift / 64) as usize, (shift % 64) as u32);
        let (mut below, mut carry) = (0_u64, false);
        let mut step = |word: &mut u64, next: u64| {
            let shifted = (u128::from(next) << 64 | u128::from(below)) >> (64 - bits);
            below = next;
            let change = |word: u64, by: u64| {
                if product.negative { word.overflowing_sub(by) } else { word.overflowing_add(by) }
            };
            let (first, one) = change(*word, shifted as u64);
            let (second, other) = change(first, carry.into());
            *word = second;
            carry = one | other;
            carry
        };
        let mut words = self.0.iter_mut().take(used).skip(skip);
        for next in product.words.iter().copied().take(product.used) {
            words.next().into_iter().for_each(|word| {
                step(word, next);
            });
        }
        words.try_for_each(|word| step(word, 0).then_some(()));
    }

    /// The leading bits.
    fn leading(&mut self, lowest: i64, used: usize) -> SoftFloat {
        let negative = self.0.get(used.saturating_sub(1)).is_some_and(|word| word >> 63 != 0);
        let mut carry = negative;
        for word in self.0.iter_mut().take(used).filter(|_| negative) {
            (*word, carry) = (!*word).overflowing_add(carry.into());
        }
        let Some(top) = self.0.iter().take(used).rposition(|word| *word != 0) else { return SoftFloat::ZERO };
        let word = |below: usize| top.checked_sub(below).and_then(|at| self.0.get(at)).copied().unwrap_or(0);
        let space = word(0).leading_zeros();
        let upper = u128::from(word(0)) << 64 | u128::from(word(1));
        let below = u128::from(word(2)) << space;
        let bits = upper << space | below >> 64;
        let cut = below as u64 != 0 || self.0.iter().take(top.saturating_sub(2)).any(|word| *word != 0);
        let exponent = lowest + 64 * (top as i64 - 1) - i64::from(space);
        SoftFloat::new(negative, bits, exponent, cut)
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use crate::exact::*;

    /// `x*y - z*w`
    const DIFFERENCE: &[u8] = &[2, 0, 1, 0x82, 2, 3];

    fn sum(operands: &[f64], terms: &[u8]) -> f64 {
        if !operands.iter().all(|operand| operand.is_finite()) {
            return f64::NAN;
        }
        let operand = |position: u8| Operand::of(operands[usize::from(position)]);
        polynomial(&operand, Terms::of(terms)).map_or(f64::NAN, SoftFloat::to_f64)
    }

    fn difference(operands: [f64; 4]) -> f64 {
        sum(&operands, DIFFERENCE)
    }

    #[test]
    fn what_cancels_is_exact() {
        let next = 1.0 + f64::EPSILON;
        assert_eq!(difference([next, next, 1.0 + 2.0 * f64::EPSILON, 1.0]), f64::EPSILON * f64::EPSILON);
        assert_eq!(difference([3.0, 5.0, 15.0, 1.0]), 0.0);
        assert_eq!(difference([3.0, 5.0, 16.0, 1.0]), -1.0);
    }

    #[test]
    fn nothing_over_or_underflows_on_the_way() {
        assert_eq!(difference([f64::MAX, f64::MAX, f64::MAX, f64::MAX]), 0.0);
        assert_eq!(difference([f64::MAX, 0.5, f64::MAX, 0.25]), f64::MAX / 4.0);
        assert_eq!(difference([f64::MAX, 2.0, 0.0, 1.0]), f64::INFINITY);
        let tiny = f64::from_bits(1);
        assert_eq!(difference([tiny, 1.0, tiny, 2.0]), -tiny);
        assert_eq!(difference([tiny, 0.5, 0.0, 0.0]), 0.0);
        assert_eq!(difference([tiny, 0.75, 0.0, 0.0]), tiny);
        // the small product survives where the large ones cancel
        assert_eq!(sum(&[1e300, 1e-300], &[2, 0, 0, 0x82, 0, 0, 1, 1]), 1e-300);
    }

    #[test]
    fn what_is_not_finite_has_no_value() {
        assert!(difference([f64::INFINITY, 1.0, 1.0, 1.0]).is_nan());
        assert!(difference([1.0, f64::NAN, 1.0, 1.0]).is_nan());
    }

    #[test]
    fn every_product_fits() {
        let terms: [u8; 17] = core::array::from_fn(|i| if i == 0 { 16 } else { 0 });
        for (operand, value) in
            [(f64::MAX, f64::INFINITY), (f64::from_bits(1), 0.0), (-2.0, 65536.0), (0.5, 2f64.powi(-16))]
        {
            assert_eq!(sum(&[operand], &terms), value);
        }
    }
}
