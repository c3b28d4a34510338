//! The formula as written: the reference, in doubles, than which no kernel may be worse by more than its bound.

use closedform_maxima::evaluate_double;

use crate::check::Judge;
use crate::failure;
use crate::inputs::Points;
use crate::ulp::{self, F64};

/// The value of a result as its reference is written, every operation rounded; none where it has no such form.
pub fn value(judge: &Judge, result: usize, inputs: &[f64]) -> Option<f64> {
    evaluate_double(&judge.oracle.bodies()[result], judge.oracle.names(), inputs)
}

/// Compares the kernel with the formula as written at every point.
///
/// # Errors
///
/// The first point where the kernel is worse by more than its bound.
pub fn check(judge: &Judge, points: &Points) -> Result<(), String> {
    for inputs in &points.list {
        for (result, actual) in judge.actual(inputs).into_iter().enumerate() {
            let Some(written) = value(judge, result, inputs) else { continue };
            let exact = judge.exact(result, inputs);
            let [kernel, written] = [actual, written].map(|value| ulp::distance(value, &exact, F64));
            if kernel > written + judge.bound(result) {
                let info = judge.kernel.info;
                return Err(format!(
                    "{}: `{}` is {kernel:.3} ulp off where the formula as written is {written:.3} ulp off\n{}  {:<10} {}\n  {:<10} {}",
                    info.name,
                    info.results[result].name,
                    failure::list(info, inputs),
                    "from",
                    points.origin,
                    "replay",
                    failure::replay(info, inputs),
                ));
            }
        }
    }
    Ok(())
}
