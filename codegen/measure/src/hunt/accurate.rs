//! A fast estimate of exact results: the kernel's own program in double-double, and its slices exactly.

use std::cell::Cell;
use std::cmp::Ordering;

use closedform::Wide;
use closedform_syntax::{Arithmetic, Slice, SliceArithmetic};
use rug::Float;

/// Bits in which a slice is summed that double-double cannot settle: enough for products of five doubles of like size.
const SLICE_BITS: u32 = 512;

/// What double-double leaves off the leading part of the circle constant.
const PI_LOW: f64 = 1.224_646_799_147_353_2e-16;

/// Between these magnitudes, 2^-450 and 2^450, a step of numbers in range loses no digits.
const RANGE: (f64, f64) = (f64::from_bits((1023 - 450) << 52), f64::from_bits((1023 + 450) << 52));

/// Double-double arithmetic. A result is right to some 2^-100 unless a step leaves the range, which is noted: good enough
/// to find inputs worth a look, not to judge them.
#[derive(Default)]
pub(super) struct Accurate {
    left: Cell<bool>,
}

impl Accurate {
    /// Whether a step has left the range, so that nothing is known of the result.
    pub(super) fn left(&self) -> bool {
        self.left.get()
    }

    /// The same size, noted if it is out of range and no zero.
    fn ranged(&self, size: f64) -> f64 {
        let inside = size == 0.0 || (size.abs() >= RANGE.0 && size.abs() <= RANGE.1);
        self.left.set(self.left.get() || !inside);
        size
    }

    fn step(&self, value: Wide) -> Wide {
        self.ranged(value.round());
        value
    }
}

/// A part of a slice, and the sum of the magnitudes of its terms.
pub(super) struct Part {
    value: Wide,
    size: f64,
}

impl Part {
    fn new(value: Wide, size: f64) -> Self {
        Part { value, size }
    }
}

impl SliceArithmetic for Accurate {
    type Value = Wide;
    type Wide = Part;

    fn neg(&self, a: &Wide) -> Wide {
        -*a
    }

    fn two_sum(&self, a: &Wide, b: &Wide) -> Part {
        let (a, b) = (a.round(), b.round());
        Part::new(Wide::two_sum(a, b), a.abs() + b.abs())
    }

    fn two_product(&self, a: &Wide, b: &Wide) -> Part {
        let (a, b) = (a.round(), b.round());
        Part::new(Wide::two_product(a, b), self.ranged(a * b).abs())
    }

    fn wide_neg(&self, a: &Part) -> Part {
        Part::new(-a.value, a.size)
    }

    fn wide_add_exact(&self, a: &Part, b: &Wide) -> Part {
        Part::new(a.value + b.round(), a.size + b.round().abs())
    }

    fn wide_add(&self, a: &Part, b: &Part) -> Part {
        Part::new(a.value + b.value, a.size + b.size)
    }

    fn wide_mul_exact(&self, a: &Part, b: &Wide) -> Part {
        Part::new(a.value * b.round(), self.ranged(a.size * b.round().abs()))
    }

    fn wide_mul(&self, a: &Part, b: &Part) -> Part {
        Part::new(a.value * b.value, self.ranged(a.size * b.size))
    }

    fn compensated(&self, a: &Part, slice: &Slice, operands: &[Wide]) -> Wide {
        let settled = a.value.round().abs() > slice.threshold * a.size;
        self.step(if settled { a.value } else { split(&exactly(&slice.terms, operands)) })
    }

    fn residual(&self, a: &Part) -> Wide {
        a.value
    }
}

/// The sum of the terms, read as `closedform::Real::compensated` says.
fn exactly(terms: &[u8], operands: &[Wide]) -> Float {
    let mut sum = Float::new(SLICE_BITS);
    let mut rest = terms;
    while let Some((head, tail)) = rest.split_first() {
        let (factors, next) = tail.split_at(usize::from(head & 0x7f).min(tail.len()));
        let product = factors
            .iter()
            .filter_map(|factor| operands.get(usize::from(*factor)))
            .fold(Float::with_val(SLICE_BITS, 1), |product, factor| product * factor.round());
        sum = if head & 0x80 == 0 { sum + product } else { sum - product };
        rest = next;
    }
    sum
}

/// The leading 106 bits.
pub(super) fn split(value: &Float) -> Wide {
    let high = value.to_f64();
    Wide::two_sum(high, Float::with_val(SLICE_BITS, value - high).to_f64())
}

impl Arithmetic for Accurate {
    fn literal(&self, value: f64) -> Wide {
        value.into()
    }

    fn pi(&self) -> Wide {
        Wide::two_sum(std::f64::consts::PI, PI_LOW)
    }

    fn add(&self, a: &Wide, b: &Wide) -> Wide {
        self.step(*a + *b)
    }

    fn sub(&self, a: &Wide, b: &Wide) -> Wide {
        self.step(*a - *b)
    }

    fn mul(&self, a: &Wide, b: &Wide) -> Wide {
        self.step(*a * *b)
    }

    fn div(&self, a: &Wide, b: &Wide) -> Wide {
        self.step(*a / *b)
    }

    fn sqrt(&self, a: &Wide) -> Wide {
        self.step(a.sqrt())
    }

    fn abs(&self, a: &Wide) -> Wide {
        if a.round() < 0.0 { -*a } else { *a }
    }

    fn compare(&self, a: &Wide, b: &Wide) -> Option<Ordering> {
        let order = a.round().partial_cmp(&b.round())?;
        Some(order.then(a.low().partial_cmp(&b.low())?))
    }

    fn is_finite(&self, a: &Wide) -> bool {
        a.round().is_finite()
    }

    /// To the digits of a double: the iterate, which a `residual!` corrects.
    fn positive_root(&self, coefficients: &[Wide]) -> Wide {
        let coefficients: Vec<f64> = coefficients.iter().map(|coefficient| coefficient.round()).collect();
        closedform::positive_root(&coefficients).into()
    }
}

/// The distance of `got` from `exact` in units of the last place of `exact`; of zero, anything else is infinitely far.
pub(super) fn distance(got: f64, exact: Wide) -> f64 {
    let (high, low) = (exact.round(), exact.low());
    if got == high && low == 0.0 {
        return 0.0;
    }
    if got.is_nan() || high == 0.0 {
        return f64::INFINITY;
    }
    // A power of two from below is in the binade below.
    let below = high.to_bits() & ((1 << 52) - 1) == 0 && low != 0.0 && (low < 0.0) == (high > 0.0);
    let unit = (high.abs().next_up() - high.abs()) * if below { 0.5 } else { 1.0 };
    (((got - high) - low) / unit).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::ulp_error;
    use closedform_syntax::evaluate;

    #[test]
    fn a_slice_that_double_double_cannot_settle_is_exact() {
        let source = "#[kernel]\npub fn f(x: f64, y: f64) -> f64 { compensated!(x * x * x - y * y * y) }";
        let kernel = closedform_syntax::parse_file(source).unwrap().remove(0);
        let (x, y) = (1.0 + 2.0f64.powi(-50), 1.0 + 2.0f64.powi(-51));
        for (x, y) in [(x, y), (x, x), (x, x.next_down()), (1.5, 0.3)] {
            let exact = evaluate(&kernel, &Accurate::default(), &[x.into(), y.into()]).remove(0);
            let cube = |x: f64| Float::with_val(400, x) * x * x;
            let expected = cube(x) - cube(y);
            let error = Float::with_val(400, &expected - exact.round()) - exact.low();
            assert!(error.abs() <= expected.abs() * 2.0f64.powi(-100), "{x} {y}");
        }
    }

    #[test]
    fn what_leaves_the_range_is_noted() {
        let source = "#[kernel]\npub fn f(x: f64, y: f64) -> f64 { compensated!(x * y - 1.0) / y }";
        let kernel = closedform_syntax::parse_file(source).unwrap().remove(0);
        let left = |x: f64, y: f64| {
            let arithmetic = Accurate::default();
            evaluate(&kernel, &arithmetic, &[x.into(), y.into()]);
            arithmetic.left()
        };
        assert_eq!(
            [left(2.0, 3.0), left(0.0, 3.0), left(1e-100, 1e-100), left(1.0, 1e200)],
            [false, false, true, true]
        );
    }

    #[test]
    fn distances_are_those_of_the_judge() {
        for (got, high, low) in [
            (1.0, 1.0, -1e-17),
            (1.0, 1.0, 1e-17),
            (1.0f64.next_down(), 1.0, -1e-17),
            (-1.0, -1.0, 1e-17),
            (-1.0, -1.0, -1e-17),
            (3.0f64.next_up(), 3.0, 1e-16),
        ] {
            let exact = Float::with_val(200, high) + low;
            let (estimate, judged) = (distance(got, Wide::two_sum(high, low)), ulp_error(got, &exact));
            assert!((estimate - judged).abs() < 1e-9, "{got} {high} {low}: {estimate} {judged}");
        }
    }
}
