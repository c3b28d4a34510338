//! The steps of [`Bounded`]: values, and what becomes of their errors.

use super::{Bounded, Share, Signs};
use crate::error_model::bounded::{MOST, UNDERFLOW};
use crate::function::Function;

impl<'a, const WATCHED: bool> Bounded<'a, WATCHED> {
    /// A number that is what it stands for.
    #[inline(always)]
    pub(super) fn exactly(&self, value: f64, signs: Signs) -> Self {
        Self::new(value, signs, self.escalate)
    }

    #[inline(always)]
    pub(super) fn sum(&self, other: &Self) -> Self {
        let value = self.value + other.value;
        let signs = self.signs.sum(other.signs);
        let sum = if self.signs.agree(other.signs) { self.growing(other) } else { self.cancelling(other) };
        let sum = Bounded { value, signs, power_of_two: false, share: Share::NONE, ..sum };
        let sum = if sum.clean { sum } else { sum.with_absolute_error() };
        sum.watched(value.is_finite())
    }

    /// The errors of a sum of terms of one sign.
    #[inline(always)]
    fn growing(&self, other: &Self) -> Self {
        let count = self.count.max(other.count).saturating_add(1);
        let clean = self.clean & other.clean;
        let error = match (self.clean, other.clean) {
            (_, true) => self.error,
            (true, _) => other.error,
            _ => self.error + other.error,
        };
        Bounded { count, error, clean, slack: self.slack.max(other.slack).saturating_add(1), ..*self }
    }

    /// The errors of a sum that may cancel: relative ones become absolute.
    #[inline(always)]
    fn cancelling(&self, other: &Self) -> Self {
        let ((a, exact), (b, other_exact)) = (self.absolute(), other.absolute());
        if exact & other_exact {
            return Bounded { count: 1, error: 0.0, clean: true, slack: 0, ..*self };
        }
        let error = match (exact, other_exact) {
            (true, _) => b,
            (_, true) => a,
            _ => a + b,
        };
        // at ordinary magnitudes no step is so small that its share of an error underflows
        let error = if WATCHED { error + UNDERFLOW } else { error };
        let slack = self.slack.max(other.slack).saturating_add(4);
        Bounded { count: 1, error, clean: false, slack, ..*self }
    }

    #[inline(always)]
    pub(super) fn product(&self, other: &Self) -> Self {
        let value = self.value * other.value;
        let (error, slack) = self.error_of_product(other);
        let exact = self.power_of_two | other.power_of_two;
        let count = self.count.saturating_add(other.count).saturating_add(u32::from(!exact));
        let share = match (self.clean, other.clean) {
            (_, true) => self.share.carried(other.count.saturating_add(1)),
            (true, _) => other.share.carried(self.count.saturating_add(1)),
            _ => Share::NONE,
        };
        let clean = self.clean & other.clean;
        let signs = self.signs.product(other.signs);
        let product = Bounded { value, count, error, slack, share, clean, signs, power_of_two: false, ..*self };
        let product = if self.clean | other.clean { product } else { product.with_absolute_error() };
        product.watched(value.is_normal() | (self.value == 0.0) | (other.value == 0.0))
    }

    #[inline(always)]
    fn error_of_product(&self, other: &Self) -> (f64, u32) {
        match (self.clean, other.clean) {
            (true, true) => (0.0, 0),
            (false, true) => self.error_times(other),
            (true, false) => other.error_times(self),
            (false, false) => {
                let ((left, a), (right, b)) = (self.error_times(other), other.error_times(self));
                let slack = a.max(b).max(self.slack.saturating_add(other.slack)).saturating_add(4);
                (left + right + self.error * other.error, slack)
            }
        }
    }

    /// What this error makes of a product with `factor`.
    #[inline(always)]
    fn error_times(&self, factor: &Self) -> (f64, u32) {
        let error = self.error * factor.signs.magnitude(factor.value);
        if factor.power_of_two & (factor.value.abs() >= 1.0) {
            return (error, self.slack);
        }
        (error + UNDERFLOW, self.slack.saturating_add(factor.count).saturating_add(2))
    }

    #[inline(always)]
    pub(super) fn quotient(&self, other: &Self) -> Self {
        let divisor = other.collapsed();
        let value = self.value / other.value;
        let count = self.count.saturating_add(divisor.count).saturating_add(2);
        let size = divisor.signs.magnitude(divisor.value);
        let error = if self.clean { 0.0 } else { self.error / size + UNDERFLOW };
        let slack = if self.clean { 0 } else { self.slack.saturating_add(divisor.count).saturating_add(3) };
        let share = self.share.carried(divisor.count.saturating_add(2));
        self.raise(other.signs.zero & (other.value == 0.0));
        let signs = self.signs.product(other.signs);
        let quotient = Bounded { value, count, error, slack, share, signs, power_of_two: false, ..*self };
        quotient.watched(value.is_normal() | (self.value == 0.0))
    }

    /// A function: a power of the magnitude of its argument.
    #[inline(always)]
    pub(super) fn called(&self, function: Function) -> Self {
        if !function.is_power() {
            return self.spread(function);
        }
        let argument = if function.is_exact() { *self } else { self.collapsed() };
        self.raise(self.signs.negative & !function.is_defined(self.value));
        let (value, signs) = (function.double(self.value), self.signs.through(function));
        let count = if function.is_exact() { argument.count } else { count_after(function, argument.count) };
        Bounded { value, signs, count, power_of_two: false, ..argument }
    }

    /// A function that is no power: its own error is relative, and what it makes of the argument's is absolute. Where an integer is
    /// certain it is exact.
    fn spread(&self, function: Function) -> Self {
        self.raise(!function.is_defined(self.value));
        let (value, signs) = (function.double(self.value), self.signs.through(function));
        let zero = (value == 0.0) & function.may_vanish(self.value);
        let exact = Bounded { count: own(function), ..self.exactly(value, signs) }.watched(value.is_normal() | zero);
        if self.count == 0 && self.clean {
            return exact;
        }
        let error = function.spread(self.value, value, self.bound());
        if function.has_steps() {
            self.raise(error != 0.0);
            return exact;
        }
        Bounded { error: error + UNDERFLOW, slack: 8, ..exact }.with_absolute_error()
    }
}

/// The count of a power of a number of this count: its share, one for terms of higher order, and the function's own error, which
/// is one more when it is taken relative to what was computed.
#[inline(always)]
fn count_after(function: Function, count: u32) -> u32 {
    let properties = function.properties();
    match properties.exponent {
        Some((p, q)) if count <= MOST && p <= q => (count * p).div_ceil(q) + own(function) + 1,
        _ => u32::MAX,
    }
}

/// The count of a function's own error, which is one more when it is taken relative to what was computed; none of an integer.
#[inline(always)]
fn own(function: Function) -> u32 {
    if function.has_steps() {
        return 0;
    }
    let error = function.properties().error;
    error.numerator.div_ceil(error.denominator) + 1
}

/// What is proved of counts holds for the largest.
const _: () = assert!(MOST <= 1 << 20);

impl Signs {
    /// Those of the value of a function.
    #[inline(always)]
    fn through(self, function: Function) -> Self {
        use core::cmp::Ordering::{self, Equal, Greater, Less};
        let of = |sign: Ordering| function.signs(sign);
        let may_be = |sign| {
            (self.negative & of(Less).contains(&sign))
                | (self.positive & of(Greater).contains(&sign))
                | (self.zero & of(Equal).contains(&sign))
        };
        Signs { negative: may_be(Less), positive: may_be(Greater), zero: may_be(Equal) }
    }
}
