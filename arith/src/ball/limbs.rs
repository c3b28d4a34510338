//! `Limbs`: floating point of `L` words with an exponent that never runs out, cut off towards zero.
//!
//! Every operation gives the leading bits of the exact result and says whether bits were cut off. What is cut off is less
//! than one [unit](Limbs::unit) of the last place, of the frame in which the operation worked.

use core::cmp::Ordering;

use crate::float;
use crate::soft_float::SoftFloat;

/// The number `0.words * 2^exponent`, words from the least to the most, the leading bit set; or its negative; or zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limbs<const L: usize> {
    negative: bool,
    exponent: i64,
    words: [u64; L],
}

/// A result, and the exponent of a power of two that is larger than what was cut off, if anything was.
pub(super) type Cut<const L: usize> = (Limbs<L>, Option<i64>);

impl<const L: usize> Limbs<L> {
    pub(super) const ZERO: Self = Limbs { negative: false, exponent: 0, words: [0; L] };

    /// Exact, of a finite number.
    pub(super) fn from_f64(x: f64) -> Self {
        let (significand, exponent) = float::significand(x);
        Self::from_integer(x < 0.0, significand, exponent.into())
    }

    /// `integer * 2^exponent`, or its negative.
    pub(super) fn from_integer(negative: bool, integer: u64, exponent: i64) -> Self {
        let mut words = [0; L];
        if let Some(last) = words.last_mut() {
            *last = integer;
        }
        Limbs { negative, exponent: exponent + 64, words }.normalised()
    }

    /// The leading words of a longer fraction, given from the most to the least, and whether more were there.
    pub(super) fn from_fraction(exponent: i64, fraction: &[u64]) -> Cut<L> {
        let mut words = [0; L];
        words.iter_mut().rev().zip(fraction).for_each(|(word, given)| *word = *given);
        let number = Limbs { negative: false, exponent, words };
        (number.normalised(), Some(number.unit()))
    }

    /// A number of 128 bits, and the size of what is lost of it.
    pub(super) fn from_soft(soft: SoftFloat) -> (Self, Option<i64>) {
        let (negative, bits, exponent, cut) = soft.parts();
        let high = Self::from_integer(negative, (bits >> 64) as u64, exponent + 64);
        let (number, lost) = high.plus(Self::from_integer(negative, bits as u64, exponent));
        (number, lost.or(cut.then_some(exponent)))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.words.last().is_none_or(|leading| *leading == 0)
    }

    pub(super) fn is_negative(&self) -> bool {
        self.negative
    }

    /// The magnitude is at least 2^(exponent - 1) and less than 2^exponent; of zero this says nothing.
    pub(super) fn exponent(&self) -> i64 {
        self.exponent
    }

    #[cfg(all(test, feature = "std"))]
    pub(super) fn parts(&self) -> (bool, [u64; L], i64) {
        (self.negative, self.words, self.exponent)
    }

    /// The exponent of one unit in the last place.
    pub(super) fn unit(&self) -> i64 {
        self.exponent - 64 * L as i64
    }

    /// The magnitude's leading part, from 1/2 to 1, rounded to nearest; 0 of zero.
    pub(super) fn leading(&self) -> f64 {
        let word = self.words.last().copied().unwrap_or(0);
        word as f64 / 18_446_744_073_709_551_616.0
    }

    /// The nearest `f64`.
    pub(super) fn to_f64(self) -> f64 {
        self.to_soft().to_f64()
    }

    /// The first 128 bits, and whether there are more.
    pub(super) fn to_soft(self) -> SoftFloat {
        let mut words = self.words.iter().rev().copied();
        let mut next = || u128::from(words.next().unwrap_or(0));
        let bits = next() << 64 | next();
        let cut = words.any(|word| word != 0);
        SoftFloat::new(self.negative, bits, self.exponent - 128, cut)
    }

    /// Whether it is this `f64`.
    pub(super) fn is_exactly(&self, x: f64) -> bool {
        x.is_finite() && {
            let (rest, cut) = self.plus(Self::from_f64(-x));
            rest.is_zero() && cut.is_none()
        }
    }

    pub(super) fn negated(self) -> Self {
        Limbs { negative: !self.negative, ..self }
    }

    pub(super) fn magnitude(self) -> Self {
        Limbs { negative: false, ..self }
    }

    /// The number times 2^by.
    pub(super) fn scaled(self, by: i64) -> Self {
        if self.is_zero() { self } else { Limbs { exponent: self.exponent.saturating_add(by), ..self } }
    }

    pub(super) fn order_of_magnitudes(&self, other: &Self) -> Ordering {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            (false, false) => self.exponent.cmp(&other.exponent).then_with(|| compare(&self.words, &other.words)),
        }
    }

    pub(super) fn order(&self, other: &Self) -> Ordering {
        match (self.is_below_zero(), other.is_below_zero()) {
            (false, false) => self.order_of_magnitudes(other),
            (true, true) => other.order_of_magnitudes(self),
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
        }
    }

    fn is_below_zero(&self) -> bool {
        self.negative && !self.is_zero()
    }

    pub(super) fn plus(self, other: Self) -> Cut<L> {
        if self.is_zero() || other.is_zero() {
            return (if self.is_zero() { other } else { self }, None);
        }
        let ordered = self.order_of_magnitudes(&other) != Ordering::Less;
        let (large, small) = if ordered { (self, other) } else { (other, self) };
        let (shifted, lost) = shifted_down(&small.words, large.exponent.saturating_sub(small.exponent));
        let cut = lost.then(|| large.unit());
        if large.negative != small.negative {
            let words = difference(&large.words, &shifted);
            return (Limbs { words, ..large }.normalised(), cut);
        }
        let (words, carry) = sum(&large.words, &shifted);
        if !carry {
            return (Limbs { words, ..large }, cut);
        }
        let (mut words, lost_more) = shifted_down(&words, 1);
        if let Some(last) = words.last_mut() {
            *last |= 1 << 63;
        }
        let number = Limbs { words, exponent: large.exponent + 1, ..large };
        (number, (lost || lost_more).then(|| number.unit()))
    }

    pub(super) fn times(self, other: Self) -> Cut<L> {
        if self.is_zero() || other.is_zero() {
            return (Self::ZERO, None);
        }
        let (low, high) = product(&self.words, &other.words);
        let number = Limbs {
            negative: self.negative != other.negative,
            exponent: self.exponent.saturating_add(other.exponent),
            words: high,
        };
        let exact = low.iter().all(|word| *word == 0);
        // a product of two numbers from 1/2 to 1 has at most one leading zero, which a bit of the lower half fills
        let first = low.last().map_or(0, |word| word >> 63);
        let mut normal = number.normalised();
        if normal.exponent != number.exponent
            && let Some(word) = normal.words.first_mut()
        {
            *word |= first;
        }
        (normal, (!exact).then(|| number.unit()))
    }

    /// The quotient; `other` is not zero.
    pub(super) fn over(self, other: Self) -> Cut<L> {
        if self.is_zero() || other.is_zero() {
            return (Self::ZERO, None);
        }
        let (whole, words, exact) = quotient(&self.words, &other.words);
        let negative = self.negative != other.negative;
        let exponent = self.exponent.saturating_sub(other.exponent);
        if !whole {
            let number = Limbs { negative, exponent, words };
            return (number, (!exact).then(|| number.unit()));
        }
        let (mut words, lost) = shifted_down(&words, 1);
        if let Some(last) = words.last_mut() {
            *last |= 1 << 63;
        }
        let number = Limbs { negative, exponent: exponent + 1, words };
        (number, (lost || !exact).then(|| number.unit()))
    }

    /// The integer part, and its last two bits; `None` where its units are not among the words.
    pub(super) fn whole(self) -> Option<(Self, u64)> {
        let Ok(bits @ 1..) = usize::try_from(self.exponent) else { return Some((Self::ZERO, 0)) };
        let below = (64 * L).checked_sub(bits)?;
        let mut words = self.words;
        for (at, word) in words.iter_mut().enumerate() {
            let cleared = below.saturating_sub(64 * at).min(64);
            *word = if cleared == 64 { 0 } else { *word >> cleared << cleared };
        }
        let bit = |place: usize| words.get(place / 64).map_or(0, |word| word >> (place % 64) & 1);
        Some((Limbs { words, ..self }, bit(below) + 2 * bit(below + 1)))
    }

    /// Shifted so that the leading bit is set.
    fn normalised(self) -> Self {
        match self.words.last() {
            Some(leading) if leading >> 63 == 1 => self,
            Some(0) => self.moved_up(),
            Some(leading) => self.shifted_up(leading.leading_zeros()),
            None => Self::ZERO,
        }
    }

    /// The same without empty words at its front, shifted so that the leading bit is set.
    fn moved_up(mut self) -> Self {
        let Some(leading) = self.words.iter().rposition(|word| *word != 0) else { return Self::ZERO };
        let empty = L - 1 - leading;
        self.words.copy_within(..L - empty, empty);
        self.words.iter_mut().take(empty).for_each(|word| *word = 0);
        self.exponent -= 64 * empty as i64;
        self.shifted_up(self.words.last().map_or(0, |word| word.leading_zeros()))
    }

    /// Shifted by less than a word; no bit that is set leaves.
    fn shifted_up(mut self, bits: u32) -> Self {
        if bits == 0 {
            return self;
        }
        let mut below = 0;
        for word in &mut self.words {
            (*word, below) = (*word << bits | below, *word >> (64 - bits));
        }
        self.exponent -= i64::from(bits);
        self
    }
}

fn compare<const L: usize>(a: &[u64; L], b: &[u64; L]) -> Ordering {
    a.iter().rev().cmp(b.iter().rev())
}

/// The words shifted down, and whether a bit was lost.
fn shifted_down<const L: usize>(words: &[u64; L], distance: i64) -> ([u64; L], bool) {
    if distance == 0 {
        return (*words, false);
    }
    let empty = usize::try_from(distance / 64).unwrap_or(usize::MAX).min(L);
    let bits = (distance % 64) as u32;
    let mut shifted = [0; L];
    for (index, word) in shifted.iter_mut().enumerate() {
        let at = |offset: usize| words.get(index + empty + offset).copied().unwrap_or(0);
        *word = at(0) >> bits | if bits == 0 { 0 } else { at(1) << (64 - bits) };
    }
    let partly = words.get(empty).is_some_and(|word| bits != 0 && word << (64 - bits) != 0);
    (shifted, partly || words.iter().take(empty).any(|word| *word != 0))
}

/// The sum and its carry.
fn sum<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], bool) {
    let (mut words, mut carry) = ([0; L], false);
    for ((word, a), b) in words.iter_mut().zip(a).zip(b) {
        let (partial, first) = a.overflowing_add(*b);
        let (total, second) = partial.overflowing_add(carry.into());
        (*word, carry) = (total, first | second);
    }
    (words, carry)
}

/// `a - b`, where b is not larger.
fn difference<const L: usize>(a: &[u64; L], b: &[u64; L]) -> [u64; L] {
    let (mut words, mut borrow) = ([0; L], false);
    for ((word, a), b) in words.iter_mut().zip(a).zip(b) {
        let (partial, first) = a.overflowing_sub(*b);
        let (rest, second) = partial.overflowing_sub(borrow.into());
        (*word, borrow) = (rest, first | second);
    }
    words
}

/// The lower and the upper half of a product, row by row: what a row makes final is its lowest word.
fn product<const L: usize>(a: &[u64; L], b: &[u64; L]) -> ([u64; L], [u64; L]) {
    let (mut low, mut high) = ([0; L], [0; L]);
    for (place, &factor) in low.iter_mut().zip(a) {
        // numbers of few bits leave most words empty
        let (row, carry) = if factor == 0 { (high, 0) } else { plus_multiple(&high, b, factor) };
        *place = row.first().copied().unwrap_or(0);
        high = moved_down(&row, carry);
    }
    (low, high)
}

/// `words + b * factor`, and the word above.
#[inline(always)]
fn plus_multiple<const L: usize>(words: &[u64; L], b: &[u64; L], factor: u64) -> ([u64; L], u64) {
    let (mut row, mut carry) = ([0; L], 0_u64);
    for ((place, word), b) in row.iter_mut().zip(words).zip(b) {
        let total = u128::from(factor) * u128::from(*b) + u128::from(*word) + u128::from(carry);
        (*place, carry) = (total as u64, (total >> 64) as u64);
    }
    (row, carry)
}

/// All words one place down, and one that enters.
#[inline(always)]
fn moved_down<const L: usize>(words: &[u64; L], entering: u64) -> [u64; L] {
    let mut moved = *words;
    let mut above = entering;
    moved.iter_mut().rev().for_each(|word| core::mem::swap(word, &mut above));
    moved
}

/// The quotient of two fractions from 1/2 to 1: whether it is 1 or more, what follows the point, and whether nothing is
/// left. Long division, word by word (Knuth, TAOCP 2, 4.3.1, algorithm D).
fn quotient<const L: usize>(a: &[u64; L], b: &[u64; L]) -> (bool, [u64; L], bool) {
    let whole = compare(a, b) != Ordering::Less;
    let mut rest = if whole { difference(a, b) } else { *a };
    let mut digits = [0; L];
    for digit in digits.iter_mut().rev() {
        *digit = next_digit(&mut rest, b);
    }
    (whole, digits, rest.iter().all(|word| *word == 0))
}

/// The integer part of `rest * 2^64 / b`, where the rest is less than b and becomes what is left.
fn next_digit<const L: usize>(rest: &mut [u64; L], b: &[u64; L]) -> u64 {
    let top = |words: &[u64; L]| words.last().copied().unwrap_or(0);
    let second = |words: &[u64; L]| words.iter().rev().nth(1).copied().unwrap_or(0);
    let leading = u128::from(top(rest)) << 64 | u128::from(second(rest));
    // at most two too large, since the leading bit of b is set
    let mut digit = (leading / u128::from(top(b).max(1))).min(u64::MAX.into()) as u64;
    let mut overflow = shifted_up(rest);
    let borrowed = subtract_multiple(rest, b, digit);
    let mut negative = overflow < borrowed;
    overflow = overflow.wrapping_sub(borrowed);
    while negative {
        digit = digit.wrapping_sub(1);
        let (words, carry) = sum(rest, b);
        *rest = words;
        let (next, wrapped) = overflow.overflowing_add(carry.into());
        (overflow, negative) = (next, !wrapped);
    }
    digit
}

/// Moves all words one place up; the one that leaves.
fn shifted_up<const L: usize>(words: &mut [u64; L]) -> u64 {
    words.iter_mut().fold(0, |below, word| core::mem::replace(word, below))
}

/// Subtracts a multiple; what has to be borrowed from the word above.
fn subtract_multiple<const L: usize>(words: &mut [u64; L], b: &[u64; L], factor: u64) -> u64 {
    let mut carry = 0_u64;
    for (word, &b) in words.iter_mut().zip(b) {
        let multiple = u128::from(factor) * u128::from(b) + u128::from(carry);
        let (rest, borrow) = word.overflowing_sub(multiple as u64);
        *word = rest;
        carry = ((multiple >> 64) as u64).wrapping_add(borrow.into());
    }
    carry
}
