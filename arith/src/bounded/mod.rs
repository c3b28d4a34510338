//! `Bounded`: `f64` that bounds its own error, the arithmetic of `fast` calls.
//!
//! A number x stands for x (1 + d) + n with |d| <= (1 + u)^`count` - 1 and [`ROOM`] |n| <= `error` (1 + u)^`slack`. What does not depend on
//! the inputs, the two exponents, the possible signs, and whether there is an `error` at all, are constants once a program is
//! inlined: up to the first sum that may cancel nothing is computed besides the value. The error is known as a share of x too, of
//! which products and quotients change nothing; compilers leave out what is not asked for. The book's page on the error model
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
/// Not `WATCHED`, it is for inputs at which no step over- or underflows: loops over it vectorise. `WATCHED`, it is for all finite
/// inputs, and each step is looked at.
#[derive(Clone, Copy)]
pub struct Bounded<'a, const WATCHED: bool> {
    value: f64,
    count: u32,
    error: f64,
    slack: u32,
    /// The same n, as a share of x.
    share: Share,
    /// Whether `error` is 0.
    clean: bool,
    signs: Signs,
    /// Whether it is a power of two in the text of the program.
    power_of_two: bool,
    escalate: &'a Cell<bool>,
}

/// An error n of a number x with [`ROOM`] |n| <= |x| `error`/`size` (1 + u)^`slack`, and n = 0 if `error` is.
#[derive(Clone, Copy)]
struct Share {
    error: f64,
    size: f64,
    slack: u32,
}

impl Share {
    const NONE: Self = Share { error: 0.0, size: 1.0, slack: 0 };

    /// The same of a number that this many factors of 1 + u lie between.
    #[inline(always)]
    fn carried(self, factors: u32) -> Self {
        Share { slack: self.slack.saturating_add(factors), ..self }
    }

    /// Whether it is at most this one.
    #[inline(always)]
    fn is_within(self, share: f64) -> bool {
        (self.slack <= MOST) & (self.error <= share * self.size)
    }
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
        let share = Share::NONE;
        Bounded { value, count: 0, error: 0.0, slack: 0, share, clean: true, signs, power_of_two: false, escalate }
    }

    /// A number with an error, for judges of single steps.
    #[must_use]
    pub fn with_error(value: f64, count: u32, error: f64, signs: Signs, escalate: &'a Cell<bool>) -> Self {
        let number = Bounded { count, error: error * ROOM, slack: 1, ..Self::new(value, signs, escalate) };
        if error == 0.0 { number } else { number.with_absolute_error() }
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
        // at ordinary magnitudes nothing overflows
        let finite = !WATCHED | (self.value.abs() <= f64::MAX);
        let kept = if self.clean { left >= 0.0 } else { self.share.is_within(left) & finite };
        self.raise(!kept);
        self.value
    }

    /// A bound of the absolute error.
    #[inline(always)]
    pub fn bound(self) -> f64 {
        if self.count == 0 && self.clean {
            return 0.0;
        }
        if self.slack > MOST {
            return f64::INFINITY;
        }
        let underflow = if self.value == 0.0 && self.clean { 0.0 } else { UNDERFLOW };
        relative(self.count) * self.value.abs() + self.error + underflow
    }

    #[inline(always)]
    fn magnitude(&self) -> f64 {
        self.signs.magnitude(self.value)
    }

    /// The same number, whose error is known as an absolute one.
    #[inline(always)]
    fn with_absolute_error(self) -> Self {
        let share = Share { error: self.error, size: self.magnitude(), slack: self.slack };
        Bounded { share, clean: false, ..self }
    }

    /// The same number with all its error in `count`; raises `escalate` where it is too large.
    #[inline(always)]
    fn collapsed(&self) -> Self {
        if self.clean {
            return *self;
        }
        self.raise(!self.share.is_within(relative_exact(COLLAPSED)));
        let count = self.count.saturating_add(COLLAPSED);
        Bounded { count, error: 0.0, slack: 0, share: Share::NONE, clean: true, ..*self }
    }

    /// All of the error in one number: `error` and what `count` means.
    #[inline(always)]
    fn absolute(&self) -> (f64, bool) {
        match (self.count, self.clean) {
            (0, _) => (self.error, self.clean),
            (_, true) => (relative(self.count) * self.magnitude(), false),
            (_, false) => (relative(self.count) * self.magnitude() + self.error, false),
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
        if other.signs.is_zero() {
            return self.compare_with_zero();
        }
        if self.signs.is_zero() {
            return other.compare_with_zero();
        }
        let ((a, exact), (b, other_exact)) = (self.absolute(), other.absolute());
        if exact & other_exact {
            return;
        }
        let known = (self.slack <= MOST) & (other.slack <= MOST);
        let (difference, error) = ((self.value - other.value).abs(), if WATCHED { a + b + UNDERFLOW } else { a + b });
        self.raise(!(known & (difference > error)));
    }

    /// Whether signs alone tell that it is larger than `other` or equal to it: one of them is zero.
    #[inline(always)]
    fn is_not_below(&self, other: &Self) -> bool {
        (other.signs.is_zero() & !self.signs.negative) | (self.signs.is_zero() & !other.signs.positive)
    }

    /// Whether signs alone tell that it is not `other`.
    #[inline(always)]
    fn is_different(&self, other: &Self) -> bool {
        (other.signs.is_zero() & !self.signs.zero) | (self.signs.is_zero() & !other.signs.zero)
    }

    /// Raises escalate unless the number has the sign of what it stands for: a relative error turns none.
    #[inline(always)]
    fn compare_with_zero(&self) {
        let Share { error, size, slack } = self.share;
        let larger = self.clean | ((slack <= MOST) & (size > error));
        self.raise(!((self.count <= MOST) & larger));
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
        other > self
    }

    #[inline(always)]
    fn le(&self, other: &Self) -> bool {
        other >= self
    }

    #[inline(always)]
    fn gt(&self, other: &Self) -> bool {
        if self.is_not_below(other) & self.is_different(other) {
            return true;
        }
        self.compare(other);
        self.value > other.value
    }

    #[inline(always)]
    fn ge(&self, other: &Self) -> bool {
        if self.is_not_below(other) {
            return true;
        }
        self.compare(other);
        self.value >= other.value
    }
}
