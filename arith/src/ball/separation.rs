//! How small a value can be that is not zero: the separation bound that decides about exact zeros.
//!
//! A value made from dyadic numbers by `+ - * /` and real roots is 2^k U/L with algebraic integers U, L whose conjugates
//! are bounded. If it is not zero, it is at least 2^k/(u^(D-1) l), where u and l bound the conjugates of U and L and D is
//! the product of the degrees of the roots (Burnikel, Funke, Mehlhorn, Schirra, Schmitt: A separation bound for real algebraic
//! expressions, Algorithmica 55, 2009; with powers of two taken out as by Pion and Yap: Constructive root bound for k-ary
//! rational input numbers, SoCG 2003).

use core::num::NonZero;

/// What is known of the algebraic number that a value is: k, the logarithms of u and l to base 2, rounded up, and the
/// roots that made it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Separation {
    twos: i64,
    upper: i64,
    lower: i64,
    roots: Roots,
}

/// The most roots in one value: of more, the bound is far below what the largest floats tell from zero.
const MOST_ROOTS: usize = 7;

/// A root in a value: which of the program it is, from 1, and its degree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Root {
    pub(super) number: u32,
    pub(super) degree: NonZero<u32>,
}

/// A set of roots.
#[derive(Clone, Copy, Debug)]
struct Roots([Option<Root>; MOST_ROOTS]);

impl Roots {
    const NONE: Self = Roots([None; MOST_ROOTS]);

    /// `None` where there is no room for another one.
    fn with(mut self, root: Root) -> Option<Self> {
        if !self.0.contains(&Some(root)) {
            *self.0.iter_mut().find(|place| place.is_none())? = Some(root);
        }
        Some(self)
    }

    fn joined(self, other: Self) -> Option<Self> {
        match (self.0.first(), other.0.first()) {
            (_, Some(None)) => Some(self),
            (Some(None), _) => Some(other),
            _ => other.0.into_iter().flatten().try_fold(self, Self::with),
        }
    }

    /// The degree of what they generate, at most.
    fn degree(self) -> i64 {
        self.0.iter().flatten().map(|root| i64::from(root.degree.get())).product()
    }
}

/// Values are decided about only if no number in their bounds is larger; far beyond what any tier holds.
const LARGEST: i64 = 1 << 40;

impl Separation {
    /// Of an `f64` with this significand and exponent.
    pub(super) fn of_dyadic(significand: u64, exponent: i64) -> Self {
        let zeros = significand.trailing_zeros().min(63);
        let bits = i64::from(64 - significand.leading_zeros()) - i64::from(zeros);
        Separation { twos: exponent + i64::from(zeros), upper: bits.max(0), lower: 0, roots: Roots::NONE }
    }

    /// Of an integer of at most so many bits.
    pub(super) fn of_integer(bits: i64) -> Self {
        Separation { twos: 0, upper: bits.max(0), lower: 0, roots: Roots::NONE }
    }

    pub(super) fn plus(self, other: Self) -> Option<Self> {
        let twos = self.twos.min(other.twos);
        let one = self.upper + (self.twos - twos) + other.lower;
        let two = other.upper + (other.twos - twos) + self.lower;
        let roots = self.roots.joined(other.roots)?;
        Self { twos, upper: one.max(two) + 1, lower: self.lower + other.lower, roots }.kept()
    }

    pub(super) fn times(self, other: Self) -> Option<Self> {
        let upper = self.upper + other.upper;
        let lower = self.lower + other.lower;
        Self { twos: self.twos + other.twos, upper, lower, roots: self.roots.joined(other.roots)? }.kept()
    }

    pub(super) fn over(self, other: Self) -> Option<Self> {
        let upper = self.upper + other.lower;
        let lower = self.lower + other.upper;
        Self { twos: self.twos - other.twos, upper, lower, roots: self.roots.joined(other.roots)? }.kept()
    }

    /// Of a root. With d its degree, it is the root of U L^(d-1), by L; or U by the root of U^(d-1) L: either is one of
    /// algebraic integers.
    pub(super) fn root(self, root: Root) -> Option<Self> {
        let degree = i64::from(root.degree.get());
        let left = self.twos.rem_euclid(degree);
        let inner = self.upper + left;
        let part = |once: i64, others: i64| (once + (degree - 1) * others + degree - 1).div_euclid(degree);
        let (upper, lower) =
            if inner >= self.lower { (part(inner, self.lower), self.lower) } else { (inner, part(self.lower, inner)) };
        Self { twos: (self.twos - left) / degree, upper, lower, roots: self.roots.with(root)? }.kept()
    }

    /// The exponent of a power of two below every such value that is not zero.
    pub(super) fn least(self) -> Option<i64> {
        let below = self.upper.checked_mul(self.roots.degree() - 1)?.checked_add(self.lower)?;
        self.twos.checked_sub(below)
    }

    fn kept(self) -> Option<Self> {
        let large = [self.twos.abs(), self.upper, self.lower].into_iter().any(|number| number > LARGEST);
        (!large).then_some(self)
    }
}
