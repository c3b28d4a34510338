//! Calls whose results carry bounds of their own errors: `fast`, what its batch is made of, and `with_bound`.
//!
//! The program runs in [`Bounded`] numbers. Where these cannot tell that a result keeps the promise, or whether a condition holds,
//! the call is made again: the default call of a kernel whose bounds are proved, else one in certified balls.

use core::cell::Cell;

use closedform_arith::error_model::bounded::PROMISE;
use closedform_arith::error_model::{CERTIFIED_ULP, UNIT};
use closedform_arith::{Bounded, Precision, tier};

use crate::info::{Info, ResultInfo};
use crate::program::{Fast, Program, positions};
use crate::shape::{all, answered, ordinary, value_apart, values};

/// The results with a relative error of at most [`PROMISE`]; NaN outside the domain.
#[inline(always)]
pub fn fast<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    let found = first_tier::<P, N, K, M>(inputs);
    if found.is_certain() { found.results } else { fast_again::<P, N, K, M>(inputs) }
}

/// What [`fast`] returns, unless `escalate` is raised: that the inputs may be outside the domain is a reason too.
#[inline(always)]
pub fn fast_first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> [f64; M] {
    let found = first_tier::<P, N, K, M>(inputs);
    escalate.set(u64::from(!found.is_certain()));
    found.results
}

/// What [`fast`] returns where there is doubt: NaN where the first tier tells that the inputs are outside.
#[cold]
#[inline(never)]
pub fn fast_again<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    if watched::<P, N, K, M>(inputs).is_outside(admitted(P::FAST, inputs)) {
        [f64::NAN; M]
    } else {
        refined::<P, N, K, M>(inputs)
    }
}

/// What `f64` with bounds of its errors computes.
struct Found<T, const M: usize> {
    results: [T; M],
    /// Whether the conditions hold that the signs of the domain do not imply.
    inside: bool,
    /// Whether the inputs are as small and large as they may be; then those of known signs have them.
    ordinary: bool,
    /// Whether a condition, or a result, is not decided.
    escalates: [bool; 2],
}

impl<T, const M: usize> Found<T, M> {
    #[inline(always)]
    fn is_certain(&self) -> bool {
        self.ordinary & self.inside & !self.escalates[0] & !self.escalates[1]
    }

    #[inline(always)]
    fn is_outside(&self, admitted: bool) -> bool {
        !admitted | (self.ordinary & !self.escalates[0] & !self.inside)
    }
}

/// The results by the first tier of [`fast`].
#[inline(always)]
fn first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> Found<f64, M> {
    if const { P::FAST.ordinary == 0 } {
        bounded::<P, N, K, M, true, f64>(inputs, |number| number.keeping(PROMISE))
    } else {
        bounded::<P, N, K, M, false, f64>(inputs, |number| number.keeping(PROMISE))
    }
}

/// The results as `end` reads them. There is no branch, which would keep batch loops from vectorising.
#[inline(always)]
fn bounded<P, const N: usize, const K: usize, const M: usize, const WATCHED: bool, T: Copy>(
    inputs: &[f64; N],
    end: impl for<'a> Fn(Bounded<'a, WATCHED>) -> T,
) -> Found<T, M>
where
    P: Program<N, K, M>,
{
    let ordinary = if WATCHED {
        all(inputs.map(f64::is_finite)) & admitted(P::FAST, inputs)
    } else {
        ordinary(P::FAST.ordinary, P::FAST.signs, inputs)
    };
    let (of_domain, of_results) = (Cell::new(false), Cell::new(false));
    let inside = all(P::domain(&numbers::<P, N, K, M, WATCHED>(inputs, &of_domain)));
    let results = P::each_result(P::evaluate(&numbers::<P, N, K, M, WATCHED>(inputs, &of_results)), end);
    Found { results, inside, ordinary, escalates: [of_domain.get(), of_results.get()] }
}

/// Whether the inputs have the signs that they have in the domain; if not, a condition that compares an input with a number does
/// not hold, whatever else was computed.
#[inline(always)]
fn admitted<const N: usize>(fast: Fast<N>, inputs: &[f64; N]) -> bool {
    all(core::array::from_fn::<_, N, _>(|input| fast.signs[input].admit(inputs[input])))
}

/// The inputs, with the signs that they have in the domain: where they have others the point is outside, whatever is computed.
#[inline(always)]
fn numbers<'a, P, const N: usize, const K: usize, const M: usize, const WATCHED: bool>(
    inputs: &[f64; N],
    escalate: &'a Cell<bool>,
) -> [Bounded<'a, WATCHED>; N]
where
    P: Program<N, K, M>,
{
    P::each_input(const { positions() }, |input| Bounded::new(inputs[input], P::FAST.signs[input], escalate))
}

/// What [`fast`] returns where its first tier escalates.
fn refined<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    if const { keeps_promise(P::INFO) } {
        value_apart::<P, N, K, M>(inputs)
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

/// Results and their bounds, of any inputs.
#[inline(never)]
fn watched<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Found<(f64, f64), M> {
    bounded::<P, N, K, M, true, (f64, f64)>(inputs, |number| (number.value(), number.bound()))
}

/// The results, and a bound of the absolute error of each; NaN outside the domain.
pub fn with_bound<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> ([f64; M], [f64; M]) {
    let found = watched::<P, N, K, M>(inputs);
    if found.is_outside(admitted(P::FAST, inputs)) {
        return ([f64::NAN; M], [f64::NAN; M]);
    }
    if found.is_certain() && found.results.iter().all(|(_, bound)| bound.is_finite()) {
        return (found.results.map(|result| result.0), found.results.map(|result| result.1));
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
