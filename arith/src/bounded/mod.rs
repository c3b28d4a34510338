//! `Bounded`: `f64` that bounds its own error, the arithmetic of `fast` calls.
//!
//! A number x stands for x (1 + d) + n with |d| <= (1 + u)^`count` - 1 and |n| <= `error` (1 + u)^`slack`. What does not depend on
//! the inputs, the two exponents, the possible signs, and whether there is an `error` at all, are constants once a program is
//! inlined: up to the first sum that may cancel nothing is computed besides the value. The book's page on the error model
//! proves each step.

mod real;
mod root;
mod signs;
mod steps;

use core::cell::Cell;
use core::cmp::Ordering;

use crate::error_model::bounded::{COLLAPSED, KEPT, MOST, RELATIVE, ROOM, UNDERFLOW};
pub use signs::Signs;

/// A number with a bound of its error; `escalate` is raised where the bound is lost.
///
/// Not `WATCHED`, it is for inputs at which no step over- or underflows, and a quotient or root asks that the error so far be
/// small: loops over it vectorise. `WATCHED`, it is for all finite inputs, each step is looked at, and a quotient carries its
/// error on.
#[derive(Clone, Copy)]
pub struct Bounded<'a, const WATCHED: bool> {
    value: f64,
    count: u32,
    error: f64,
    slack: u32,
    /// Whether `error` is 0.
    clean: bool,
    signs: Signs,
    escalate: &'a Cell<bool>,
}

/// (1 + u)^`count` - 1, or more; infinite where nothing is proved of so many.
#[inline(always)]
fn relative(count: u32) -> f64 {
    if count > MOST { f64::INFINITY } else { f64::from(count) * RELATIVE }
}

impl<'a, const WATCHED: bool> Bounded<'a, WATCHED> {
    /// An input of one of these signs, and the flag that it raises to escalate.
    #[inline(always)]
    pub fn new(value: f64, signs: Signs, escalate: &'a Cell<bool>) -> Self {
        Bounded { value, count: 0, error: 0.0, slack: 0, clean: true, signs, escalate }
    }

    /// A number with an error, for judges of single steps.
    #[must_use]
    pub fn with_error(value: f64, count: u32, error: f64, signs: Signs, escalate: &'a Cell<bool>) -> Self {
        Bounded { count, error, clean: error == 0.0, ..Self::new(value, signs, escalate) }
    }

    /// The number.
    #[inline(always)]
    pub fn value(self) -> f64 {
        self.value
    }

    /// The number; raises `escalate` unless its relative error is at most `promise`.
    #[inline(always)]
    pub fn keeping(self, promise: f64) -> f64 {
        let left = promise * KEPT - relative(self.count);
        let kept = if self.clean { left >= 0.0 } else { self.size(left) & (self.value.abs() <= f64::MAX) };
        self.raise(!kept);
        self.value
    }

    /// A bound of the absolute error.
    #[inline(always)]
    pub fn bound(self) -> f64 {
        if self.count == 0 && self.clean {
            return 0.0;
        }
        let slack = if self.slack > MOST { f64::INFINITY } else { ROOM };
        let underflow = if self.value == 0.0 && self.clean { 0.0 } else { UNDERFLOW };
        (relative(self.count) * self.value.abs() + self.error + underflow) * slack
    }

    /// Whether `error` is at most this share of the value.
    #[inline(always)]
    fn size(&self, share: f64) -> bool {
        (self.slack <= MOST) & (self.error * ROOM <= share * self.value.abs())
    }

    /// The same number with all its error in `count`; raises `escalate` where it is too large.
    #[inline(always)]
    fn collapsed(&self) -> Self {
        if self.clean {
            return *self;
        }
        self.raise(!self.size(relative_exact(COLLAPSED)));
        Bounded { count: self.count.saturating_add(COLLAPSED), error: 0.0, slack: 0, clean: true, ..*self }
    }

    /// All of the error in one number: `error` and what `count` means.
    #[inline(always)]
    fn absolute(&self) -> (f64, bool) {
        match (self.count, self.clean) {
            (0, _) => (self.error, self.clean),
            (_, true) => (relative(self.count) * self.value.abs(), false),
            (_, false) => (relative(self.count) * self.value.abs() + self.error, false),
        }
    }

    #[inline(always)]
    fn raise(&self, escalate: bool) {
        self.escalate.set(self.escalate.get() | escalate);
    }

    /// Raises `escalate` unless what is watched is `fine`.
    #[inline(always)]
    fn watched(self, fine: bool) -> Self {
        self.raise(WATCHED & !fine);
        self
    }

    /// Raises `escalate` unless the two numbers compare as what they stand for does.
    #[inline(always)]
    fn compare(&self, other: &Self) {
        let signed = |number: &Self| number.clean & (number.count <= MOST);
        let against_zero = (signed(self) & other.signs.is_zero()) | (signed(other) & self.signs.is_zero());
        let ((a, exact), (b, other_exact)) = (self.absolute(), other.absolute());
        if against_zero | (exact & other_exact) {
            return;
        }
        let known = (self.slack <= MOST) & (other.slack <= MOST);
        let difference = (self.value - other.value).abs();
        self.raise(!(known & (difference > (a + b + UNDERFLOW) * ROOM)));
    }
}

/// `count` units: exact, since `count` is a power of two.
#[inline(always)]
fn relative_exact(count: u32) -> f64 {
    f64::from(count) * crate::error_model::UNIT
}

impl<const WATCHED: bool> PartialEq for Bounded<'_, WATCHED> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.compare(other);
        self.value == other.value
    }
}

impl<const WATCHED: bool> PartialOrd for Bounded<'_, WATCHED> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.compare(other);
        self.value.partial_cmp(&other.value)
    }

    #[inline(always)]
    fn lt(&self, other: &Self) -> bool {
        self.compare(other);
        self.value < other.value
    }

    #[inline(always)]
    fn le(&self, other: &Self) -> bool {
        self.compare(other);
        self.value <= other.value
    }

    #[inline(always)]
    fn gt(&self, other: &Self) -> bool {
        self.compare(other);
        self.value > other.value
    }

    #[inline(always)]
    fn ge(&self, other: &Self) -> bool {
        self.compare(other);
        self.value >= other.value
    }
}
