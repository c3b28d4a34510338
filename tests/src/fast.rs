//! What calls promise that bound their own errors: `fast`, its batch, and `with_bound`.

use closedform::{FAST_PROMISE, Kernel};
use rug::Float;

use crate::check::Judge;
use crate::failure::replay;
use crate::inputs::Points;
use crate::shapes;

/// Demands of each point that `fast` keeps its promise where the domain holds and is NaN elsewhere, and that the certified error
/// of `with_bound` is no smaller than the true one; the worst relative error.
///
/// # Errors
///
/// The first point where it is not so.
pub fn check(judge: &Judge, points: &Points) -> Result<f64, String> {
    let mut worst = 0.0_f64;
    for inputs in &points.list {
        let [fast, values, errors] = calls(judge, inputs);
        let told = |what: String| format!("{what}\n  from {}\n  {}", points.origin, replay(judge.kernel.info, inputs));
        if !judge.space.admits(inputs) {
            if [&fast, &values, &errors].iter().any(|list| list.iter().any(|number| !number.is_nan())) {
                return Err(told(format!("outside the domain: {fast:?}, {values:?} +- {errors:?}")));
            }
            continue;
        }
        for result in 0..fast.len() {
            let exact = judge.exact(result, inputs);
            let (share, kept) = promise_kept(fast[result], &exact);
            let bounded = within(values[result], errors[result], &exact);
            if !kept || !bounded {
                let (fast, value, error) = (fast[result], values[result], errors[result]);
                return Err(told(format!(
                    "{exact:.30}: fast {fast:e} off by {share:e}, with_bound {value:e} +- {error:e}"
                )));
            }
            worst = worst.max(if share.is_finite() { share } else { 0.0 });
        }
    }
    Ok(worst)
}

fn calls(judge: &Judge, inputs: &[f64]) -> [Vec<f64>; 3] {
    let mut lists = [(); 3].map(|()| vec![0.0; judge.kernel.info.results.len()]);
    let [fast, values, errors] = &mut lists;
    judge.kernel.fast(inputs, fast).expect("as many inputs and results as the kernel has");
    judge.kernel.with_bound(inputs, values, errors).expect("as many inputs and results as the kernel has");
    lists
}

/// The relative error, and whether it is within the promise; where `f64` cannot hold the value, it is what rounding makes of it.
fn promise_kept(value: f64, exact: &Float) -> (f64, bool) {
    if !value.is_finite() {
        return (f64::INFINITY, value == exact.to_f64());
    }
    let off = Float::with_val(exact.prec() + 64, exact - value).abs();
    let size = exact.clone().abs();
    // below the normal numbers a result is as good as the default call's
    let lost = if size < f64::MIN_POSITIVE { 4.0 * f64::from_bits(1) } else { 0.0 };
    let kept = off <= size.clone() * FAST_PROMISE + lost;
    (if off.is_zero() { 0.0 } else { (off / size).to_f64() }, kept)
}

fn within(value: f64, error: f64, exact: &Float) -> bool {
    if error.is_infinite() {
        return value.is_infinite();
    }
    Float::with_val(exact.prec() + 64, exact - value).abs() <= error
}

/// Demands of a batch of all points that it has the bits of single `fast` calls.
///
/// # Errors
///
/// The first point where it has not.
pub fn check_batch(judge: &Judge, points: &Points) -> Result<(), String> {
    shapes::check_rows(judge, points, Kernel::fast_batch, |inputs| {
        let [alone, ..] = calls(judge, inputs);
        alone
    })
}
