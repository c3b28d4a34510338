//! What a kernel answers, interpreted: the tiers of calls run its tree instead of its compiled program.

use closedform_arith::Real;
use closedform_arith::tier::{self, Answer, Fate, Rounded, Steps};
use closedform_syntax::{Kernel, Precision, Violation, evaluate, violated};

/// A kernel at a point.
struct Interpreted<'a> {
    kernel: &'a Kernel,
    point: &'a [f64],
}

impl Interpreted<'_> {
    fn numbers<R: Real>(&self, number: impl Fn(f64) -> R) -> Vec<R> {
        self.point.iter().map(|value| number(*value)).collect()
    }

    fn answer(&self) -> Answer<Self> {
        match self.kernel.meta.precision {
            Precision::Double => tier::default(self),
            Precision::DoubleDouble => tier::faithful(self),
            Precision::Certified => tier::certified(self),
        }
    }
}

impl Steps for Interpreted<'_> {
    type Results<T> = Vec<T>;

    fn violated<R: Real>(&self, number: impl Fn(f64) -> R) -> Option<usize> {
        match violated(self.kernel, &self.numbers(number))? {
            Violation::Require(position) => Some(position),
            // Inputs are finite, and no number in these arithmetics is infinite.
            Violation::NotFinite(_) => None,
        }
    }

    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> Vec<T> {
        evaluate(self.kernel, &self.numbers(number)).into_iter().map(end).collect()
    }
}

fn answer(kernel: &Kernel, point: &[f64]) -> Result<Vec<Rounded>, Violation> {
    if let Some(input) = point.iter().position(|value| !value.is_finite()) {
        return Err(Violation::NotFinite(input));
    }
    Interpreted { kernel, point }.answer().map_err(Violation::Require)
}

/// What the compiled kernel returns, to the bit, or why the point is outside of its domain.
///
/// # Errors
///
/// The first condition that the point violates.
///
/// # Panics
///
/// When the point has not as many coordinates as the kernel has inputs.
pub fn results(kernel: &Kernel, point: &[f64]) -> Result<Vec<f64>, Violation> {
    Ok(answer(kernel, point)?.into_iter().map(|result| result.value).collect())
}

/// Whether the promise of the kernel's bounds covers a point of its domain: no result over- or underflows, and none is
/// undecided, as an exact zero of a certified kernel may be. A kernel that refuses the point, or has no value there, has no
/// excuse.
pub fn covers(kernel: &Kernel, point: &[f64]) -> bool {
    let held = |result: Rounded| !matches!(result.fate, Fate::Overflows | Fate::Underflows | Fate::Undecided);
    answer(kernel, point).map_or(true, |results| results.into_iter().all(held))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernel(attribute: &str, body: &str) -> Kernel {
        let source = format!("#[kernel{attribute}]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
        closedform_syntax::parse_file(&source).unwrap().remove(0)
    }

    #[test]
    fn only_results_may_over_or_underflow() {
        for attribute in ["", "(precision = \"double-double\")"] {
            let covered = |body: &str, x: f64, y: f64| covers(&kernel(attribute, body), &[x, y]);
            assert!(covered("sqrt(x * x + y * y)", 1e300, 1e-300));
            assert!(covered("sqrt(x * x + y * y)", 1e-300, 1e-300));
            assert!(covered("1.0 / (x * y)", 1e-150, 1e-150));
            assert!(covered("x * y", 0.0, 1e-300));
            assert!(covered("compensated!(x * x - x * y)", 1e200, 1e200));
            assert!(!covered("x * y", 1e300, 1e300));
            assert!(!covered("x * y", 1e-200, 1e-200));
            assert!(!covered("x * y", 1e-155, 1e-155));
            assert!(!covered("1.0 / (x * y)", 1e-160, 1e-160));
            assert!(!covered("compensated!(x * x - x * y)", 2e200, 1e200));
            assert!(covered("x - y", 3e-323, 1e-323), "exact");
            assert!(covered("compensated!(x * y)", 2f64.powi(-1000), 2f64.powi(-74)), "exact");
        }
    }

    #[test]
    fn mistakes_are_covered() {
        for (body, x) in [("1.0 / (x - y)", 1.0), ("sqrt(x - 2.0 * y)", 1.0), ("x / (y - y)", 0.0)] {
            let kernel = kernel("", body);
            assert!(covers(&kernel, &[x, 1.0]), "{body}");
            assert!(results(&kernel, &[x, 1.0]).unwrap()[0].is_nan(), "{body}");
        }
    }

    #[test]
    fn steps_that_leave_the_range_are_computed_all_the_same() {
        let value = |body: &str, x: f64, y: f64| results(&kernel("", body), &[x, y]).unwrap()[0];
        for unit in [2f64.powi(700), 2f64.powi(-700), f64::from_bits(1)] {
            assert_eq!(value("sqrt(x * x + y * y)", 3.0 * unit, 4.0 * unit), 5.0 * unit);
        }
        assert_eq!(value("x / (y * y)", 0.0, 1e-163), 0.0);
        assert_eq!(value("x * y / x", 1e200, 1e200), 1e200);
        assert_eq!(value("residual!(x * y - 1.0) / y", 1e-200, 1e-200), -1e200);
    }

    #[test]
    fn a_condition_is_decided_at_every_magnitude() {
        let refused = |condition: &str, x: f64, y: f64| {
            results(&kernel("", &format!("require!({condition}); x")), &[x, y]).is_err()
        };
        assert!(!refused("x * y > 0.0", 1e-200, 1e-200));
        assert!(refused("x * y > 0.0", 1e-200, -1e-200));
        assert!(refused("-(x * y) >= 0.0", 1e-200, 1e-200));
        assert!(refused("compensated!(x * y) >= 0.0", 1e-200, -1e-200));
        assert!(!refused("compensated!(x * x - y) < 0.0", 1e-200, 5e-324));
        assert!(!refused("x * y < x * 1e-300", 1e-300, 1e-301));
    }
}
