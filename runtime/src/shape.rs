//! The shapes of a call that are the same for every program: plain, checked, single precision.

use crate::error::{DomainError, LengthError};
use crate::kernel::Program;

/// The condition that comes before all others.
const FINITE: &str = "every input is finite";

/// The results in `f64`; NaN outside the domain.
///
/// Values are computed in any case and then selected: without a branch, batch loops vectorise.
#[inline(always)]
pub fn value<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    let results = P::evaluate(inputs);
    let inside = P::domain(inputs).iter().fold(finite(inputs), |all, holds| all & holds);
    results.map(|result| if inside { result } else { f64::NAN })
}

/// The results in `f64`, or the first condition that the inputs violate.
pub fn checked<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[f64; M], DomainError> {
    match violated::<P, N, K, M>(inputs) {
        None => Ok(P::evaluate(inputs)),
        Some(condition) => Err(DomainError::new(P::INFO, condition, inputs)),
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

fn violated<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Option<&'static str> {
    if !finite(inputs) {
        return Some(FINITE);
    }
    let conditions = P::domain(inputs).into_iter().zip(P::INFO.domain);
    conditions.filter(|(holds, _)| !holds).map(|(_, &condition)| condition).next()
}
