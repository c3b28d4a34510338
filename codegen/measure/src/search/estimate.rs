//! A fast estimate of exact results: the kernel's own program in an arithmetic finer than its own.

use std::cell::Cell;

use closedform_arith::{DoubleDouble, FilteredDoubleDouble, Mpfr};
use closedform_syntax::{Kernel, evaluate};
use rug::Float;

/// A result in double-double, its compensated expressions exactly, as `faithful` computes it; `None` where a step leaves
/// the range, so that nothing is known of it. Good enough to find inputs worth a look, not to judge them.
pub(super) fn in_double_double(kernel: &Kernel, result: usize, point: &[f64]) -> Option<DoubleDouble> {
    let left = Cell::new(false);
    let inputs: Vec<_> = point.iter().map(|value| FilteredDoubleDouble::<true>::new(*value, &left)).collect();
    let exact = evaluate(kernel, &inputs).get(result)?.value();
    (!left.get()).then_some(exact)
}

/// The leading 106 bits of a result in MPFR: what a kernel that computes in double-double itself is compared with.
pub(super) fn in_mpfr(kernel: &Kernel, result: usize, point: &[f64], bits: u32) -> Option<DoubleDouble> {
    let inputs: Vec<_> = point.iter().map(|value| Mpfr::new(bits, *value)).collect();
    evaluate(kernel, &inputs).get(result).map(|exact| leading(&exact.0))
}

fn leading(value: &Float) -> DoubleDouble {
    let high = value.to_f64();
    DoubleDouble::two_sum(high, Float::with_val(value.prec(), value - high).to_f64())
}

/// The distance of `got` from `exact` in units of the last place of `exact`; of zero, anything else is infinitely far.
pub(super) fn distance(got: f64, exact: DoubleDouble) -> f64 {
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

    fn kernel(body: &str) -> Kernel {
        let source = format!("#[kernel]\npub fn f(x: f64, y: f64) -> f64 {{ {body} }}");
        closedform_syntax::parse_file(&source).unwrap().remove(0)
    }

    #[test]
    fn an_expression_that_double_double_cannot_settle_is_exact() {
        let kernel = kernel("compensated!(x * x * x - y * y * y)");
        let (x, y) = (1.0 + 2.0f64.powi(-50), 1.0 + 2.0f64.powi(-51));
        for (x, y) in [(x, y), (x, x), (x, x.next_down()), (1.5, 0.3)] {
            let exact = in_double_double(&kernel, 0, &[x, y]).unwrap();
            let cube = |x: f64| Float::with_val(400, x) * x * x;
            let expected = cube(x) - cube(y);
            let error = Float::with_val(400, &expected - exact.round()) - exact.low();
            assert!(error.abs() <= expected.abs() * 2.0f64.powi(-100), "{x} {y}");
        }
    }

    #[test]
    fn nothing_is_known_where_a_step_leaves_the_range() {
        let kernel = kernel("compensated!(x * y - 1.0) / y");
        let known = |x: f64, y: f64| in_double_double(&kernel, 0, &[x, y]).is_some();
        assert_eq!(
            [known(2.0, 3.0), known(0.0, 3.0), known(1e-100, 1e-250), known(1.0, 1e200)],
            [true, true, false, false]
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
            let (estimate, judged) = (distance(got, DoubleDouble::two_sum(high, low)), ulp_error(got, &exact));
            assert!((estimate - judged).abs() < 1e-9, "{got} {high} {low}: {estimate} {judged}");
        }
    }
}
