//! The promise of a bound: it holds while no step over- or underflows and no `compensated!` slice cancels too far.

use std::cell::Cell;
use std::cmp::Ordering;

use closedform::{Real, Wide};
use closedform_syntax::{Arithmetic, Kernel, SliceArithmetic, evaluate, violated};

/// How far the terms of a `compensated!` slice may cancel: documented with every bound of a kernel that has one.
const CANCELLATION: f64 = (1_u64 << 40) as f64;

/// The magnitudes between which products are error-free: beyond, an operand cannot be split; below, errors underflow.
const ERROR_FREE: (f64, f64) = (f64::from_bits((1023 - 969) << 52), f64::from_bits((1023 + 996) << 52));

/// Whether the promise of the kernel's bounds covers a point of its domain.
///
/// Where the kernel refuses the point, only the steps that decide so count.
pub fn covers(kernel: &Kernel, point: &[f64]) -> bool {
    let watch = Watch::default();
    let point: Vec<Watched> = point.iter().copied().map(Watched::from).collect();
    if violated(kernel, &watch, &point).is_none() {
        watch.left.set(false);
        evaluate(kernel, &watch, &point);
    }
    !watch.left.get()
}

/// The arithmetic of compiled kernels, which notes when a step leaves what the promise covers.
#[derive(Default)]
struct Watch {
    left: Cell<bool>,
}

/// A number.
#[derive(Clone, Copy)]
struct Watched {
    value: f64,
    /// Whether it is the iterate of a polynomial root, whose residual is meant to cancel.
    iterate: bool,
}

impl From<f64> for Watched {
    fn from(value: f64) -> Self {
        Self { value, iterate: false }
    }
}

/// A number in double-double, with what it is made of.
struct Terms {
    value: Wide,
    /// The sum of the magnitudes of its terms.
    size: f64,
    /// Whether one of its factors is an iterate.
    iterate: bool,
}

impl From<Watched> for Terms {
    fn from(exact: Watched) -> Self {
        Self { value: exact.value.into(), size: exact.value.abs(), iterate: exact.iterate }
    }
}

impl Terms {
    /// Of two parts, joined to `value`.
    fn of(value: Wide, size: fn(f64, f64) -> f64, a: &Self, b: &Self) -> Self {
        Self { value, size: size(a.size, b.size), iterate: a.iterate || b.iterate }
    }
}

impl Watch {
    fn note(&self, left: bool) {
        self.left.set(self.left.get() || left);
    }

    /// A sum: it may overflow.
    fn sum(&self, value: f64) -> Watched {
        self.note(value.is_infinite());
        value.into()
    }

    /// A product or quotient of nonzero numbers, if `nonzero`.
    fn scaled(&self, value: f64, nonzero: bool) -> Watched {
        self.note(value.is_infinite() || (nonzero && value.abs() < f64::MIN_POSITIVE));
        value.into()
    }

    fn wide_sum(&self, value: Wide, a: &Terms, b: &Terms) -> Terms {
        self.sum(value.round());
        Terms::of(value, |a, b| a + b, a, b)
    }

    fn wide_product(&self, value: Wide, a: &Terms, b: &Terms) -> Terms {
        let (low, high) = ERROR_FREE;
        let [left, right, product] = [a.value, b.value, value].map(|wide| wide.round().abs());
        self.scaled(product, left != 0.0 && right != 0.0);
        self.note(left > high || right > high || (product != 0.0 && product < low));
        Terms::of(value, |a, b| a * b, a, b)
    }
}

impl SliceArithmetic for Watch {
    type Value = Watched;
    type Wide = Terms;

    fn neg(&self, a: &Watched) -> Watched {
        Watched { value: -a.value, ..*a }
    }

    fn two_sum(&self, a: &Watched, b: &Watched) -> Terms {
        self.wide_sum(Wide::two_sum(a.value, b.value), &(*a).into(), &(*b).into())
    }

    fn two_product(&self, a: &Watched, b: &Watched) -> Terms {
        self.wide_product(Wide::two_product(a.value, b.value), &(*a).into(), &(*b).into())
    }

    fn wide_neg(&self, a: &Terms) -> Terms {
        Terms { value: -a.value, ..*a }
    }

    fn wide_add_exact(&self, a: &Terms, b: &Watched) -> Terms {
        self.wide_sum(a.value + b.value, a, &(*b).into())
    }

    fn wide_add(&self, a: &Terms, b: &Terms) -> Terms {
        self.wide_sum(a.value + b.value, a, b)
    }

    fn wide_mul_exact(&self, a: &Terms, b: &Watched) -> Terms {
        self.wide_product(a.value * b.value, a, &(*b).into())
    }

    fn wide_mul(&self, a: &Terms, b: &Terms) -> Terms {
        self.wide_product(a.value * b.value, a, b)
    }

    fn round(&self, a: &Terms) -> Watched {
        let value = a.value.round();
        self.note(!a.iterate && a.size > 0.0 && value.abs() * CANCELLATION <= a.size);
        value.into()
    }
}

impl Arithmetic for Watch {
    fn literal(&self, value: f64) -> Watched {
        value.into()
    }

    fn pi(&self) -> Watched {
        std::f64::consts::PI.into()
    }

    fn add(&self, a: &Watched, b: &Watched) -> Watched {
        self.sum(a.value + b.value)
    }

    fn sub(&self, a: &Watched, b: &Watched) -> Watched {
        self.sum(a.value - b.value)
    }

    fn mul(&self, a: &Watched, b: &Watched) -> Watched {
        self.scaled(a.value * b.value, a.value != 0.0 && b.value != 0.0)
    }

    fn div(&self, a: &Watched, b: &Watched) -> Watched {
        // A division by zero is no overflow but a mistake.
        if b.value == 0.0 { (a.value / b.value).into() } else { self.scaled(a.value / b.value, a.value != 0.0) }
    }

    fn sqrt(&self, a: &Watched) -> Watched {
        a.value.sqrt().into()
    }

    fn abs(&self, a: &Watched) -> Watched {
        a.value.abs().into()
    }

    fn compare(&self, a: &Watched, b: &Watched) -> Option<Ordering> {
        a.value.partial_cmp(&b.value)
    }

    fn is_finite(&self, a: &Watched) -> bool {
        a.value.is_finite()
    }

    fn positive_root(&self, coefficients: &[Watched]) -> Watched {
        let coefficients: Vec<f64> = coefficients.iter().map(|coefficient| coefficient.value).collect();
        let root = self.scaled(f64::positive_root(&coefficients), true);
        Watched { iterate: true, ..root }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(body: &str, point: &[f64]) -> bool {
        let source = format!("#[kernel]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
        covers(&closedform_syntax::parse_file(&source).unwrap()[0], point)
    }

    #[test]
    fn overflow_and_underflow_are_not_covered() {
        assert!(covered("x * y", &[1e100, 1e-300]));
        assert!(covered("x * y", &[0.0, 1e-300]));
        assert!(!covered("x * y", &[1e-200, 1e-200]));
        assert!(!covered("x * y", &[1e200, 1e200]));
        assert!(!covered("1.0 / (x * y)", &[1e-160, 1e-160]));
        assert!(!covered("x / y", &[1e-200, 1e200]));
        assert!(!covered("compensated!(x * y - 1.0)", &[1e-150, 1e-150]));
    }

    #[test]
    fn mistakes_are_covered() {
        assert!(covered("1.0 / (x - y)", &[1.0, 1.0]));
        assert!(covered("sqrt(x)", &[-1.0, 1.0]));
    }

    #[test]
    fn slices_may_cancel_so_far() {
        assert!(covered("compensated!(x - y)", &[1.0, 1.0 + 0.5f64.powi(38)]));
        assert!(!covered("compensated!(x - y)", &[1.0, 1.0 + 0.5f64.powi(40)]));
        assert!(!covered("compensated!(x - y)", &[1.0, 1.0]));
        assert!(covered("compensated!(x - y)", &[0.0, 0.0]));
    }

    #[test]
    fn a_residual_is_meant_to_cancel() {
        assert!(covered("let r = positive_root([-x, y]); r - compensated!(y * r - x) / y", &[3.0, 1.0]));
        assert!(!covered("let r = positive_root([-x, y]); r - compensated!(x * x - x * y) / y", &[1.0, 1.0]));
    }

    #[test]
    fn a_decision_that_cancels_is_not_held_against_an_accurate_result() {
        assert!(covered("require!(compensated!(x - y) <= 0.0); x + y", &[1.0, 1.0]));
        assert!(!covered("require!(compensated!(x - y) < 0.0); x + y", &[1.0, 1.0]));
        assert!(covered("require!(x < y); x + y", &[1.0, 1.0]));
    }
}
