//! The promise of a bound: it holds while no step over- or underflows, or in double-double no result.

use std::cell::Cell;
use std::cmp::Ordering;

use closedform::__private::Soft;
use closedform::Real;
use closedform_syntax::{Arithmetic, Kernel, Precision, Slice, SliceArithmetic, evaluate, violated};

use super::{Compiled, results, run};

/// The magnitudes between which products in double-double are error-free: beyond, an operand cannot be split; below,
/// errors underflow.
const ERROR_FREE: (f64, f64) = (f64::from_bits((1023 - 969) << 52), f64::from_bits((1023 + 996) << 52));

/// Whether the promise of the kernel's bounds covers a point of its domain.
///
/// Where the kernel refuses the point, only the steps that decide so count.
pub fn covers(kernel: &Kernel, point: &[f64]) -> bool {
    match kernel.meta.precision {
        Precision::Double => steps_stay(kernel, point),
        Precision::DoubleDouble => results_stay(kernel, point),
        Precision::Certified => results(kernel, point).map_or(true, |results| results.into_iter().all(stays)),
    }
}

/// Whether no result over- or underflows.
fn results_stay(kernel: &Kernel, point: &[f64]) -> bool {
    let zero = Soft::from_f64(0.0);
    let point: Vec<Soft> = point.iter().map(|value| Soft::from_f64(*value)).collect();
    run(kernel, &Compiled(zero), &point)
        .map_or(true, |results| results.into_iter().all(|result| result == zero || stays(result.to_f64())))
}

/// Whether a result has not overflowed nor lost bits to underflow.
fn stays(result: f64) -> bool {
    result == 0.0 || result.is_nan() || result.is_normal()
}

fn steps_stay(kernel: &Kernel, point: &[f64]) -> bool {
    let watch = Watch::default();
    if violated(kernel, &watch, point).is_none() {
        watch.left.set(false);
        evaluate(kernel, &watch, point);
    }
    !watch.left.get()
}

/// The arithmetic of compiled kernels, which notes when a step leaves what the promise covers.
#[derive(Default)]
struct Watch {
    left: Cell<bool>,
}

/// A number in double-double.
struct Watched {
    value: <f64 as Real>::Wide,
    /// Whether a step behind it lost its theorem. A `compensated!` slice makes up for that, a `residual!` does not.
    left: bool,
}

impl Watch {
    fn note(&self, left: bool) {
        self.left.set(self.left.get() || left);
    }

    /// A sum: it may overflow.
    fn sum(&self, value: f64) -> f64 {
        self.note(value.is_infinite());
        value
    }

    /// A product or quotient of nonzero numbers, if `nonzero`.
    fn scaled(&self, value: f64, nonzero: bool) -> f64 {
        self.note(value.is_infinite() || (nonzero && value.abs() < f64::MIN_POSITIVE));
        value
    }
}

impl Watched {
    fn rounded(&self) -> f64 {
        f64::residual(&self.value)
    }

    /// A sum in double-double of parts of which one, if `left`, lost its theorem.
    fn sum(value: <f64 as Real>::Wide, left: bool) -> Self {
        let sum = Watched { value, left };
        Watched { left: left || !sum.rounded().is_finite(), ..sum }
    }

    /// A product of these factors.
    fn product(value: <f64 as Real>::Wide, a: f64, b: f64, left: bool) -> Self {
        let (low, high) = ERROR_FREE;
        let product = Watched::sum(value, left);
        let size = product.rounded().abs();
        let inside = a.abs() <= high && b.abs() <= high && (size >= low || a == 0.0 || b == 0.0);
        Watched { left: product.left || !inside, ..product }
    }
}

impl SliceArithmetic for Watch {
    type Value = f64;
    type Wide = Watched;

    fn neg(&self, a: &f64) -> f64 {
        -a
    }

    fn two_sum(&self, a: &f64, b: &f64) -> Watched {
        Watched::sum(a.two_sum(b), false)
    }

    fn two_product(&self, a: &f64, b: &f64) -> Watched {
        Watched::product(a.two_product(b), *a, *b, false)
    }

    fn wide_neg(&self, a: &Watched) -> Watched {
        Watched { value: f64::wide_neg(&a.value), left: a.left }
    }

    fn wide_add_exact(&self, a: &Watched, b: &f64) -> Watched {
        Watched::sum(f64::wide_add_exact(&a.value, b), a.left)
    }

    fn wide_add(&self, a: &Watched, b: &Watched) -> Watched {
        Watched::sum(f64::wide_add(&a.value, &b.value), a.left || b.left)
    }

    fn wide_mul_exact(&self, a: &Watched, b: &f64) -> Watched {
        Watched::product(f64::wide_mul_exact(&a.value, b), a.rounded(), *b, a.left)
    }

    fn wide_mul(&self, a: &Watched, b: &Watched) -> Watched {
        Watched::product(f64::wide_mul(&a.value, &b.value), a.rounded(), b.rounded(), a.left || b.left)
    }

    fn compensated(&self, a: &Watched, slice: &Slice, operands: &[f64]) -> f64 {
        let operands: Vec<&f64> = operands.iter().collect();
        let value = f64::compensated(&a.value, slice.threshold, &operands, &slice.terms);
        self.scaled(value, value != 0.0)
    }

    fn residual(&self, a: &Watched) -> f64 {
        self.note(a.left);
        a.rounded()
    }
}

impl Arithmetic for Watch {
    fn literal(&self, value: f64) -> f64 {
        value
    }

    fn pi(&self) -> f64 {
        std::f64::consts::PI
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        self.sum(a + b)
    }

    fn sub(&self, a: &f64, b: &f64) -> f64 {
        self.sum(a - b)
    }

    fn mul(&self, a: &f64, b: &f64) -> f64 {
        self.scaled(a * b, *a != 0.0 && *b != 0.0)
    }

    fn div(&self, a: &f64, b: &f64) -> f64 {
        // A division by zero is no overflow but a mistake.
        if *b == 0.0 { a / b } else { self.scaled(a / b, *a != 0.0) }
    }

    fn sqrt(&self, a: &f64) -> f64 {
        a.sqrt()
    }

    fn abs(&self, a: &f64) -> f64 {
        a.abs()
    }

    fn compare(&self, a: &f64, b: &f64) -> Option<Ordering> {
        a.partial_cmp(b)
    }

    fn is_finite(&self, a: &f64) -> bool {
        a.is_finite()
    }

    fn positive_root(&self, coefficients: &[f64]) -> f64 {
        self.scaled(closedform::positive_root(coefficients), true)
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
    }

    #[test]
    fn in_double_double_only_results_may_leave() {
        let covered = |body: &str, point: &[f64]| {
            let source =
                format!("#[kernel(precision = \"double-double\")]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
            covers(&closedform_syntax::parse_file(&source).unwrap()[0], point)
        };
        assert!(covered("sqrt(x * x + y * y)", &[1e300, 1e-300]));
        assert!(covered("x * y - y * x", &[1e300, 1e300]));
        assert!(covered("sqrt(x)", &[-1.0, 1.0]), "a mistake");
        assert!(!covered("x * y", &[1e300, 1e300]));
        assert!(!covered("x * y", &[1e-200, 1e-200]));
        assert!(!covered("x * y", &[1e-155, 1e-155]));
    }

    #[test]
    fn inside_a_slice_they_are() {
        assert!(covered("compensated!(x * y - 1.0)", &[1e-200, 1e-200]));
        assert!(covered("compensated!(x * x - x * y)", &[1e200, 1e200]));
        assert!(!covered("compensated!(x * x - x * y)", &[2e200, 1e200]));
        assert!(!covered("compensated!(x * y)", &[1e-200, 1e-110]));
        assert!(!covered("residual!(x * y - 1.0)", &[1e-200, 1e-200]));
    }

    #[test]
    fn mistakes_are_covered() {
        assert!(covered("1.0 / (x - y)", &[1.0, 1.0]));
        assert!(covered("sqrt(x)", &[-1.0, 1.0]));
    }

    #[test]
    fn cancellation_is_covered() {
        assert!(covered("compensated!(x - y)", &[1.0, 1.0 + f64::EPSILON]));
        assert!(covered("compensated!(x - y)", &[1.0, 1.0]));
        assert!(covered("residual!(x - y)", &[1.0, 1.0]));
    }

    #[test]
    fn a_decision_is_not_held_against_an_accurate_result() {
        assert!(covered("require!(x * x >= 0.0); x + y", &[1e-200, 1.0]));
        assert!(!covered("require!(x * x > 1.0); x + y", &[1e-200, 1.0]));
    }
}
