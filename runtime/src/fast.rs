//! Calls whose results carry bounds of their own errors: `fast`, its batch row, and `with_bound`.
//!
//! The program runs in [`Bounded`] numbers. Where these cannot tell that a result keeps the promise, or whether a condition holds,
//! the call is made again: the default call of a kernel whose bounds are proved, else one in certified balls.

use core::cell::Cell;

use closedform_arith::error_model::bounded::PROMISE;
use closedform_arith::error_model::{CERTIFIED_ULP, UNIT};
use closedform_arith::{Bounded, Precision, tier};

use crate::info::{Info, ResultInfo};
use crate::program::Program;
use crate::shape::{all, answered, ordinary, raise, value, values, where_inside};

/// The results with a relative error of at most [`PROMISE`]; NaN outside the domain.
#[inline(always)]
pub fn fast<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    let escalate = Cell::new(0);
    let results = first_tier_fast::<P, N, K, M>(inputs, &escalate);
    if escalate.get() != 0 { refined::<P, N, K, M>(inputs) } else { results }
}

/// What [`fast`] returns, unless `escalate` is raised.
#[inline(always)]
pub fn first_tier_fast<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> [f64; M] {
    if const { P::FAST.ordinary == 0 } {
        bounded::<P, N, K, M, true, f64>(inputs, escalate, |number| number.keeping(PROMISE), f64::NAN)
    } else {
        bounded::<P, N, K, M, false, f64>(inputs, escalate, |number| number.keeping(PROMISE), f64::NAN)
    }
}

/// The results as `end` reads them, `outside` out of the domain, unless `escalate` is raised. Values are computed in any case: a
/// branch would keep batch loops from vectorising.
#[inline(always)]
fn bounded<P, const N: usize, const K: usize, const M: usize, const WATCHED: bool, T: Copy>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
    end: impl for<'a> Fn(Bounded<'a, WATCHED>) -> T,
    outside: T,
) -> [T; M]
where
    P: Program<N, K, M>,
{
    let fine = if WATCHED { all(inputs.map(f64::is_finite)) } else { ordinary(P::FAST.ordinary, inputs) };
    let (of_domain, of_results) = (Cell::new(!fine), Cell::new(false));
    let domain = P::domain(&numbers::<P, N, K, M, WATCHED>(inputs, &of_domain));
    let results = P::evaluate(&numbers::<P, N, K, M, WATCHED>(inputs, &of_results)).map(end);
    raise(escalate, domain, of_domain.get(), of_results.get());
    where_inside(results, domain, outside)
}

/// The inputs, with the signs that they have in the domain: outside of it no result is looked at, and the conditions that tell signs
/// compare inputs with numbers, which takes no sign for granted.
#[inline(always)]
fn numbers<'a, P, const N: usize, const K: usize, const M: usize, const WATCHED: bool>(
    inputs: &[f64; N],
    escalate: &'a Cell<bool>,
) -> [Bounded<'a, WATCHED>; N]
where
    P: Program<N, K, M>,
{
    core::array::from_fn(|input| Bounded::new(inputs[input], P::FAST.signs[input], escalate))
}

/// What [`fast`] returns where its first tier escalates.
#[cold]
#[inline(never)]
pub fn refined<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    if const { keeps_promise(P::INFO) } {
        value::<P, N, K, M>(inputs)
    } else {
        values(answered::<P, N, K, M>(inputs, tier::certified))
    }
}

/// Whether the default call keeps the promise of `fast`: every result has a bound, which is small enough.
const fn keeps_promise(info: &Info) -> bool {
    let mut at = 0;
    while at < info.results.len() {
        match info.results[at].bound_ulp {
            Some(bound) if relative(bound) <= PROMISE => at += 1,
            _ => return matches!(info.precision, Precision::Certified),
        }
    }
    true
}

/// The relative error that a bound in ulp allows.
const fn relative(ulp: f64) -> f64 {
    2.0 * UNIT * ulp
}

/// The results, and a bound of the absolute error of each; NaN outside the domain.
pub fn with_bound<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> ([f64; M], [f64; M]) {
    let escalate = Cell::new(0);
    let end = |number: Bounded<'_, true>| (number.value(), number.bound());
    let results = bounded::<P, N, K, M, true, (f64, f64)>(inputs, &escalate, end, (f64::NAN, f64::NAN));
    let inside = results.iter().all(|(value, bound)| value.is_nan() & bound.is_nan() | bound.is_finite());
    if escalate.get() == 0 && inside {
        return (results.map(|result| result.0), results.map(|result| result.1));
    }
    let values = refined::<P, N, K, M>(inputs);
    let mut results = P::INFO.results.iter();
    let errors = values.map(|value| off(value, results.next().map_or(CERTIFIED_ULP, refined_ulp::<P, N, K, M>)));
    (values, errors)
}

/// What a result of [`refined`] may be off by, in ulp.
fn refined_ulp<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(result: &ResultInfo) -> f64 {
    match result.bound_ulp {
        Some(ulp) if const { keeps_promise(P::INFO) } => ulp,
        _ => CERTIFIED_ULP,
    }
}

/// What a value with an error of so many ulp, of the exact value, may be off by.
fn off(value: f64, ulp: f64) -> f64 {
    if value.is_infinite() {
        f64::INFINITY
    } else {
        relative(ulp) * (1.0 + 1e-9) * value.abs() + ulp * f64::from_bits(2)
    }
}
