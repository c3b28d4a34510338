//! The shapes of a call that are the same for every program: plain, checked, faithful, single precision, batch row.

use core::cell::Cell;

use crate::certified::certified;
use crate::error::{DomainError, LengthError};
use crate::guarded::Guarded;
use crate::info::Precision;
use crate::kernel::Program;
use crate::quick::Quick;
use crate::soft::Soft;

/// The condition that comes before all others.
const FINITE: &str = "every input is finite";

/// What holds where certified arithmetic comes to an end.
const DECIDED: &str = "4,096 bits decide every sign, or that it is zero";

/// What holds where the results of a formula exist.
const HAS_VALUE: &str = "no root is taken of a negative number, and nothing is divided by zero";

/// The results in `f64`, computed in the precision of the kernel; NaN outside the domain.
///
/// Values are computed in any case and then selected: without a branch, batch loops vectorise.
#[inline(always)]
pub fn value<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    if const { !matches!(P::INFO.precision, Precision::Double) } {
        return faithful::<P, N, K, M>(inputs);
    }
    inside(inputs, P::evaluate(inputs), P::domain(inputs))
}

/// What [`value`] returns, unless `doubt` is raised.
#[inline(always)]
pub fn quick<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
    doubt: &Cell<bool>,
) -> [f64; M] {
    if const { matches!(P::INFO.precision, Precision::Certified) } {
        return faithful::<P, N, K, M>(inputs);
    }
    if const { matches!(P::INFO.precision, Precision::DoubleDouble) } {
        let (results, domain) = guarded::<P, N, K, M>(inputs, doubt);
        return inside(inputs, results, domain);
    }
    let numbers = inputs.map(|value| Quick { value, doubt });
    inside(inputs, P::evaluate(&numbers).map(|result| result.value), P::domain(&numbers))
}

/// The results where the inputs are finite and all conditions hold, else NaN.
#[inline(always)]
fn inside<const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
    results: [f64; M],
    domain: [bool; K],
) -> [f64; M] {
    let inside = domain.iter().fold(finite(inputs), |all, holds| all & holds);
    results.map(|result| if inside { result } else { f64::NAN })
}

/// The results with an error of less than one ulp; NaN outside the domain.
///
/// The precision is asked for in a `const` block: what a kernel does not run in is not compiled for it.
pub fn faithful<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    if !finite(inputs) {
        return [f64::NAN; M];
    }
    if const { matches!(P::INFO.precision, Precision::Certified) } {
        return certified::<P, N, K, M>(inputs).map_or([f64::NAN; M], |(results, _)| results);
    }
    let (results, domain) = rounded_once::<P, N, K, M>(inputs);
    if domain.iter().all(|holds| *holds) { results } else { [f64::NAN; M] }
}

/// Results and domain of finite inputs, with an error of less than one ulp.
fn rounded_once<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> ([f64; M], [bool; K]) {
    let left = Cell::new(false);
    let in_double_double = guarded::<P, N, K, M>(inputs, &left);
    if left.get() { soft::<P, N, K, M>(inputs) } else { in_double_double }
}

/// Results and domain in double-double, unless `left` is raised.
#[inline(always)]
fn guarded<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
    left: &Cell<bool>,
) -> ([f64; M], [bool; K]) {
    let numbers = inputs.map(|value| Guarded::new(value, left));
    (P::evaluate(&numbers).map(Guarded::round), P::domain(&numbers))
}

/// Results and domain in an arithmetic that neither over- nor underflows.
#[cold]
#[inline(never)]
fn soft<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> ([f64; M], [bool; K]) {
    let numbers = inputs.map(Soft::from_f64);
    (P::evaluate(&numbers).map(Soft::to_f64), P::domain(&numbers))
}

/// The results in `f64`, or the first condition that the inputs violate.
pub fn checked<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[f64; M], DomainError> {
    let refused = |condition| Err(DomainError::new(P::INFO, condition, inputs));
    if !finite(inputs) {
        return refused(FINITE);
    }
    if const { matches!(P::INFO.precision, Precision::Certified) } {
        let Some((results, domain)) = certified::<P, N, K, M>(inputs) else { return refused(DECIDED) };
        let missing = results.iter().any(|result| result.is_nan()).then_some(HAS_VALUE);
        return violated::<P, N, K, M>(domain).or(missing).map_or(Ok(results), refused);
    }
    match P::INFO.precision {
        Precision::Double => violated::<P, N, K, M>(P::domain(inputs)).map_or_else(|| Ok(P::evaluate(inputs)), refused),
        Precision::DoubleDouble | Precision::Certified => {
            let (results, domain) = rounded_once::<P, N, K, M>(inputs);
            violated::<P, N, K, M>(domain).map_or(Ok(results), refused)
        }
    }
}

/// The results in single precision: evaluated in `f64` and rounded once.
pub fn single<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f32; N]) -> [f32; M] {
    value::<P, N, K, M>(&inputs.map(f64::from)).map(|result| result as f32)
}

/// That the slice `name` is as long as the others.
pub fn same_length(kernel: &'static str, name: &'static str, expected: usize, found: usize) -> Result<(), LengthError> {
    if expected == found { Ok(()) } else { Err(LengthError { kernel, name, expected, found }) }
}

#[inline(always)]
fn finite<const N: usize>(inputs: &[f64; N]) -> bool {
    inputs.iter().fold(true, |all, input| all & input.is_finite())
}

/// The first condition that does not hold.
fn violated<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    domain: [bool; K],
) -> Option<&'static str> {
    let conditions = domain.into_iter().zip(P::INFO.domain);
    conditions.filter(|(holds, _)| !holds).map(|(_, &condition)| condition).next()
}
