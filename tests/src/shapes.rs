//! What all shapes of a call promise besides accuracy: NaN and names outside the domain, equal bits, single precision.

use closedform::{CallError, Kernel, LengthError, RangeError, RangeReason};
use rug::Float;

use crate::check::Judge;
use crate::domain::FINITE;
use crate::failure::{list, replay};
use crate::inputs::Points;
use crate::ulp::{self, F32, F64};

/// Demands of each point that it is NaN and refused by name outside the domain, and the same value checked inside.
///
/// # Errors
///
/// The first point where it is not so.
pub fn check_domain(judge: &Judge, points: &Points) -> Result<(), String> {
    points.list.iter().try_for_each(|inputs| {
        let violated = judge.space.domain().violated(inputs);
        let actual = judge.actual(inputs);
        let named = refused(judge.kernel, inputs, &actual)?;
        let consistent = actual.iter().all(|result| result.is_nan() == violated.is_some());
        if named == violated && consistent {
            return Ok(());
        }
        Err(told(judge, inputs, &points.origin, &format!("violates {violated:?}, refused for {named:?}: {actual:?}")))
    })
}

/// Demands that every input refuses to be infinite or NaN.
///
/// # Errors
///
/// The first input that does not.
pub fn check_finite(judge: &Judge, points: &Points) -> Result<(), String> {
    for inputs in &points.list {
        for (input, value) in (0..inputs.len()).flat_map(|input| NOT_FINITE.map(|value| (input, value))) {
            let mut inputs = inputs.clone();
            inputs[input] = value;
            let actual = judge.actual(&inputs);
            let named = refused(judge.kernel, &inputs, &actual)?;
            if named != Some(FINITE) || !actual.iter().all(|result| result.is_nan()) {
                let what = format!("refused for {named:?}: {actual:?}");
                return Err(told(judge, &inputs, &points.origin, &what));
            }
        }
    }
    Ok(())
}

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The condition that `checked` names; inside the domain its results must be `expected`, bit for bit, unless it names one
/// that is lost.
fn refused(kernel: &Kernel, inputs: &[f64], expected: &[f64]) -> Result<Option<&'static str>, String> {
    let mut results = vec![0.0; expected.len()];
    match kernel.checked(inputs, &mut results) {
        Err(CallError::Domain(error)) => Ok(Some(error.condition())),
        Ok(()) if same_bits(&results, expected) => Ok(None),
        Err(CallError::Range(_)) => Ok(None),
        other => Err(format!("{}: checked {other:?} with {results:?}, not {expected:?}", kernel.info.name)),
    }
}

/// Demands of each point inside the domain that `checked` names the first result that `f64` cannot hold, and why.
///
/// # Errors
///
/// The first point where it does not.
pub fn check_range(judge: &Judge, points: &Points) -> Result<(), String> {
    for inputs in &points.list {
        let actual = judge.actual(inputs);
        let mut results = vec![0.0; actual.len()];
        let lost = match judge.kernel.checked(inputs, &mut results) {
            Ok(()) => None,
            Err(CallError::Range(error)) => Some(error),
            Err(other) => return Err(told(judge, inputs, &points.origin, &format!("refused: {other}"))),
        };
        let first = lost.as_ref().map_or(actual.len(), |lost| position(judge, lost));
        for (result, value) in actual.iter().enumerate().take(first + 1) {
            let (exact, lost) = (judge.exact(result, inputs), lost.as_ref().filter(|_| result == first));
            if !fits(*value, &exact, judge.bound(result), lost) {
                let what = format!("{value:?} for {exact:.20}, and checked says {lost:?}");
                return Err(told(judge, inputs, &points.origin, &what));
            }
        }
    }
    Ok(())
}

fn position(judge: &Judge, lost: &RangeError) -> usize {
    let results = judge.kernel.info.results;
    results.iter().position(|result| result.name == lost.result()).expect("a result of the kernel")
}

/// Whether the exact value is as lost as is said: one that is kept has the digits that the bound promises, below the
/// normal numbers too. At the edge of what `f64` holds, rounding decides.
fn fits(value: f64, exact: &Float, bound: f64, lost: Option<&RangeError>) -> bool {
    let magnitude = exact.clone().abs();
    let normal = magnitude >= f64::MIN_POSITIVE * (1.0 - f64::EPSILON);
    let off = Float::with_val(exact.prec() + 64, exact - value).abs();
    match lost {
        None => value.is_finite() && (normal || off <= magnitude * bound * f64::EPSILON),
        Some(lost) if lost.rounded().to_bits() != value.to_bits() => false,
        Some(lost) => match lost.reason() {
            RangeReason::Overflow => value.is_infinite() && exact.to_f64().is_infinite(),
            RangeReason::Underflow => value.abs() <= f64::MIN_POSITIVE && *exact != value,
            _ => false,
        },
    }
}

/// Demands that a batch of all points has the bits of single calls.
///
/// # Errors
///
/// The first point where it has not.
pub fn check_batch(judge: &Judge, points: &Points) -> Result<(), String> {
    check_rows(judge, points, Kernel::batch, |inputs| judge.actual(inputs))
}

/// A batch over columns of inputs and results.
pub type Columns = fn(&Kernel, &[&[f64]], &mut [&mut [f64]]) -> Result<(), LengthError>;

/// Demands that a batch of all points has the bits of the calls `alone`.
///
/// # Errors
///
/// The first point where it has not.
pub fn check_rows(
    judge: &Judge,
    points: &Points,
    batch: Columns,
    alone: impl Fn(&[f64]) -> Vec<f64>,
) -> Result<(), String> {
    let info = judge.kernel.info;
    let columns: Vec<Vec<f64>> =
        (0..info.inputs.len()).map(|input| points.list.iter().map(|point| point[input]).collect()).collect();
    let mut results = vec![vec![0.0; points.list.len()]; info.results.len()];
    let inputs: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let mut slices: Vec<&mut [f64]> = results.iter_mut().map(Vec::as_mut_slice).collect();
    batch(judge.kernel, &inputs, &mut slices).map_err(|error| error.to_string())?;
    for (position, inputs) in points.list.iter().enumerate() {
        let batch: Vec<f64> = results.iter().map(|column| column[position]).collect();
        let actual = alone(inputs);
        if !same_bits(&batch, &actual) {
            return Err(told(judge, inputs, &points.origin, &format!("alone {actual:?}, in a batch {batch:?}")));
        }
    }
    Ok(())
}

/// Equal bits; every NaN is the same.
pub fn same_bits(left: &[f64], right: &[f64]) -> bool {
    let same = |(left, right): (&f64, &f64)| left.to_bits() == right.to_bits() || left.is_nan() && right.is_nan();
    left.len() == right.len() && left.iter().zip(right).all(same)
}

/// Demands of each point, rounded to single precision, that the result is what one rounding of the double makes it; how
/// many points stayed inside the domain.
///
/// # Errors
///
/// The first point where it is not.
pub fn check_single(judge: &Judge, points: &Points) -> Result<usize, String> {
    let mut judged = 0;
    for point in &points.list {
        let singles: Vec<f32> = point.iter().map(|input| *input as f32).collect();
        let inputs: Vec<f64> = singles.iter().map(|input| f64::from(*input)).collect();
        if !judge.space.admits(&inputs) {
            continue;
        }
        judged += 1;
        let mut results = vec![0.0; judge.kernel.info.results.len()];
        judge.kernel.f32(&singles, &mut results).map_err(|error| error.to_string())?;
        for (result, actual) in results.into_iter().enumerate() {
            let exact = judge.exact(result, &inputs);
            let error = ulp::distance(f64::from(actual), &exact, F32);
            // Half a unit for the rounding, and what the double was off: 29 bits more.
            let allowed = 0.5 + judge.bound(result) * 0.5_f64.powi(29);
            if error > allowed {
                let what = format!("{actual:?}, expected {exact:.20}: {error} ulp of single precision");
                return Err(told(judge, &inputs, &points.origin, &what));
            }
        }
    }
    Ok(judged)
}

/// Demands of each point that the faithful results are less than one ulp off; how far the worst one is.
///
/// # Errors
///
/// The first point where they are not.
pub fn check_faithful(judge: &Judge, points: &Points) -> Result<f64, String> {
    let mut worst = 0.0_f64;
    for inputs in &points.list {
        let mut results = vec![0.0; judge.kernel.info.results.len()];
        judge.kernel.faithful(inputs, &mut results).map_err(|error| error.to_string())?;
        for (result, actual) in results.into_iter().enumerate() {
            let exact = judge.exact(result, inputs);
            let error = ulp::distance(actual, &exact, F64);
            if error >= 1.0 {
                let what = format!("faithful {actual:?}, expected {exact:.20}: {error} ulp");
                return Err(told(judge, inputs, &points.origin, &what));
            }
            worst = worst.max(error);
        }
    }
    Ok(worst)
}

fn told(judge: &Judge, inputs: &[f64], origin: &str, what: &str) -> String {
    let info = judge.kernel.info;
    format!("{}: {what}\n{}  from {origin}\n  {}", info.name, list(info, inputs), replay(info, inputs))
}
