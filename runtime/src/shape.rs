//! The shapes of a call that are the same for every program: default, checked, faithful, single precision, batch row.
//!
//! The first tier of a call tests little and has no branch, so that batch loops vectorise. Where it escalates the row
//! is [decided](tier) from the beginning, in one arithmetic after another. A kernel without ordinary inputs has no such tier.

use core::cell::Cell;
use core::marker::PhantomData;

use closedform_arith::tier::{self, Rounded, Steps};
use closedform_arith::{FUSED, Filtered, FilteredDoubleDouble, Precision, Real, Signs};

use crate::error::{DomainError, LengthError, RangeError, ValueError};
use crate::info::{Info, ResultInfo};
use crate::program::Program;

/// The condition that comes before all others.
const FINITE: &str = "every input is finite";

/// The results in `f64`, computed in the precision of the kernel; NaN outside the domain.
#[inline(always)]
pub fn value<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    let escalate = Cell::new(0);
    let results = first_tier::<P, N, K, M, FUSED>(inputs, &escalate);
    if escalate.get() != 0 { decided::<P, N, K, M>(inputs) } else { results }
}

/// [`value`] as a function of its own: for shapes that gain nothing from the steps of the kernel among theirs, which would be
/// compiled for each of them.
pub(crate) fn value_apart<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> [f64; M] {
    match first_tier_apart::<P, N, K, M>(inputs) {
        Some((results, domain)) => where_inside::<P, N, K, M>(results, domain),
        None => decided::<P, N, K, M>(inputs),
    }
}

/// Results and domain as one function of each kernel; `None` where the first tier escalates, or there is none.
#[inline(never)]
fn first_tier_apart<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Option<([f64; M], [bool; K])> {
    if P::INFO.ordinary == 0 {
        return None;
    }
    let escalate = Cell::new(0);
    let found = in_first_tier::<P, N, K, M, FUSED>(inputs, &escalate);
    (escalate.get() == 0).then_some(found)
}

/// What [`value`] returns where the first tier escalates.
pub fn decided<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    values(answer::<P, N, K, M>(inputs))
}

/// What [`value`] returns, unless `escalate` is raised.
#[inline(always)]
pub fn first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> [f64; M] {
    if P::INFO.ordinary == 0 {
        return decided::<P, N, K, M>(inputs);
    }
    let (results, domain) = in_first_tier::<P, N, K, M, FUSED>(inputs, escalate);
    where_inside::<P, N, K, M>(results, domain)
}

/// The results where all conditions hold, else NaN.
#[inline(always)]
fn where_inside<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    results: [f64; M],
    domain: [bool; K],
) -> [f64; M] {
    let inside = all(domain);
    P::each_result(results, |result| if inside { result } else { f64::NAN })
}

/// Results and domain in the precision of the kernel, unless `escalate` is raised.
#[inline(always)]
fn in_first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> ([f64; M], [bool; K]) {
    match P::INFO.precision {
        Precision::Double => in_f64::<P, N, K, M, FUSED>(inputs, escalate),
        // a certified kernel has no first tier
        Precision::DoubleDouble | Precision::Certified => in_double_double::<P, N, K, M, FUSED>(inputs, escalate),
    }
}

/// Results and domain in `f64`, unless `escalate` is raised. Values are computed in any case: a branch would keep batch loops
/// from vectorising.
#[inline(always)]
fn in_f64<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> ([f64; M], [bool; K]) {
    let (of_domain, of_results) = (Cell::new(!ordinary(P::INFO.ordinary, [Signs::ANY; N], inputs)), Cell::new(false));
    let domain = P::domain(&P::each_input(*inputs, |value| Filtered::<false, FUSED>::new(value, &of_domain)));
    let results = P::evaluate(&P::each_input(*inputs, |value| Filtered::<false, FUSED>::new(value, &of_results)));
    let results = P::each_result(results, Filtered::value);
    raise(escalate, domain, of_domain.get(), of_results.get());
    (results, domain)
}

/// Results and domain in double-double, unless `escalate` is raised.
#[inline(always)]
fn in_double_double<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize, const FUSED: bool>(
    inputs: &[f64; N],
    escalate: &Cell<u64>,
) -> ([f64; M], [bool; K]) {
    let (of_domain, of_results) = (Cell::new(!ordinary(P::INFO.ordinary, [Signs::ANY; N], inputs)), Cell::new(false));
    let domain =
        P::domain(&P::each_input(*inputs, |value| FilteredDoubleDouble::<false, FUSED>::new(value, &of_domain)));
    let results =
        P::evaluate(&P::each_input(*inputs, |value| FilteredDoubleDouble::<false, FUSED>::new(value, &of_results)));
    let results = P::each_result(results, FilteredDoubleDouble::round);
    raise(escalate, domain, of_domain.get(), of_results.get());
    (results, domain)
}

/// Raises `escalate` for that of the domain, and that of the results where they are asked for. An integer is what compilers
/// see through when they vectorise.
#[inline(always)]
fn raise<const K: usize>(escalate: &Cell<u64>, domain: [bool; K], of_domain: bool, of_results: bool) {
    escalate.set(escalate.get() | u64::from(of_domain | (all(domain) & of_results)));
}

/// Whether every input has its sign, and is 0, if that may be, or of a magnitude from 2^-`exponent` to 2^`exponent`. It is the sum
/// that is tested not to be larger.
#[inline(always)]
pub(crate) fn ordinary<const N: usize>(exponent: u32, signs: [Signs; N], inputs: &[f64; N]) -> bool {
    let exponent = u64::from(exponent);
    let (least, most) = (f64::from_bits((1023 - exponent) << 52), f64::from_bits((1023 + exponent) << 52));
    let (mut smallest, mut sum) = (most, 0.0);
    for (input, signs) in inputs.iter().zip(signs) {
        let size = signs.magnitude(*input);
        // the number before it, and NaN before zero, which no comparison takes for smaller
        let tested = if signs.zero { f64::from_bits(size.to_bits().wrapping_sub(1)) } else { size };
        smallest = if tested < smallest { tested } else { smallest };
        sum += size;
    }
    (sum <= most) & (smallest >= least)
}

#[inline(always)]
pub(crate) fn all<const K: usize>(domain: [bool; K]) -> bool {
    domain.iter().fold(true, |all, holds| all & holds)
}

/// A compiled program at a point.
pub(crate) struct Compiled<'a, P, const N: usize, const K: usize, const M: usize> {
    inputs: &'a [f64; N],
    program: PhantomData<P>,
}

impl<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize> Steps for Compiled<'_, P, N, K, M> {
    type Results<T> = [T; M];

    #[inline(always)]
    fn violated<R: Real>(&self, number: impl Fn(f64) -> R) -> Option<usize> {
        first_violated(P::domain(&self.inputs.map(number)))
    }

    #[inline(always)]
    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> [T; M] {
        P::evaluate(&self.inputs.map(number)).map(end)
    }
}

#[inline(always)]
fn first_violated<const K: usize>(domain: [bool; K]) -> Option<usize> {
    domain.iter().position(|holds| !holds)
}

/// The results, or the condition that the inputs violate, in the precision of the kernel.
#[cold]
#[inline(never)]
fn answer<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[Rounded; M], &'static str> {
    if P::INFO.precision == Precision::Double {
        return answered::<P, N, K, M>(inputs, tier::default);
    }
    finer_answer::<P, N, K, M>(inputs)
}

#[inline(always)]
pub(crate) fn answered<'a, P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &'a [f64; N],
    tiers: fn(&Compiled<'a, P, N, K, M>) -> Result<[Rounded; M], usize>,
) -> Result<[Rounded; M], &'static str> {
    if !inputs.iter().all(|input| input.is_finite()) {
        return Err(FINITE);
    }
    tiers(&Compiled { inputs, program: PhantomData }).map_err(|position| condition(P::INFO, position))
}

/// The numbers of an answer; NaN where it has none.
pub(crate) fn values<const M: usize>(answer: Result<[Rounded; M], &'static str>) -> [f64; M] {
    answer.map_or([f64::NAN; M], |results| results.map(|result| result.value))
}

/// The results with an error of less than one ulp; NaN outside the domain.
pub fn faithful<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f64; N]) -> [f64; M] {
    match faithful_first_tier::<P, N, K, M>(inputs) {
        Some((results, domain)) => where_inside::<P, N, K, M>(results, domain),
        None => values(faithful_answer::<P, N, K, M>(inputs)),
    }
}

/// Results and domain in double-double, which for most kernels is not the first tier of a default call.
#[inline(always)]
fn faithful_first_tier<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Option<([f64; M], [bool; K])> {
    if P::INFO.precision != Precision::Double || P::INFO.ordinary == 0 {
        return first_tier_apart::<P, N, K, M>(inputs);
    }
    let escalate = Cell::new(0);
    let found = in_double_double::<P, N, K, M, FUSED>(inputs, &escalate);
    (escalate.get() == 0).then_some(found)
}

/// The same where the first tier escalates.
#[cold]
#[inline(never)]
fn faithful_answer<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[Rounded; M], &'static str> {
    finer_answer::<P, N, K, M>(inputs)
}

/// The results with an error of less than one ulp. The precision is asked for in a `const` block, so that balls are
/// compiled for certified kernels only.
#[inline(always)]
fn finer_answer<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[Rounded; M], &'static str> {
    if const { matches!(P::INFO.precision, Precision::Certified) } {
        answered::<P, N, K, M>(inputs, tier::certified)
    } else {
        answered::<P, N, K, M>(inputs, tier::faithful)
    }
}

/// The results in `f64`, or why there are none: the first condition that the inputs violate, or the first result that
/// `f64` cannot hold.
pub fn checked<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[f64; M], ValueError> {
    let Some((results, domain)) = first_tier_apart::<P, N, K, M>(inputs) else {
        return checked_when_decided::<P, N, K, M>(inputs);
    };
    match first_violated(domain) {
        Some(position) => Err(DomainError::new(P::INFO, condition(P::INFO, position), inputs).into()),
        None => Ok(results),
    }
}

/// The same where the first tier escalates.
#[cold]
#[inline(never)]
fn checked_when_decided<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(
    inputs: &[f64; N],
) -> Result<[f64; M], ValueError> {
    let refused = |condition| DomainError::new(P::INFO, condition, inputs);
    let results = answer::<P, N, K, M>(inputs).map_err(refused)?;
    let lost = |(result, info): (&Rounded, &ResultInfo)| RangeError::new(P::INFO, info.name, *result, inputs);
    match results.iter().zip(P::INFO.results).find_map(lost) {
        Some(error) => Err(error.into()),
        None => Ok(results.map(|result| result.value)),
    }
}

/// The results in single precision: evaluated in `f64` and rounded once.
pub fn single<P: Program<N, K, M>, const N: usize, const K: usize, const M: usize>(inputs: &[f32; N]) -> [f32; M] {
    value_apart::<P, N, K, M>(&inputs.map(f64::from)).map(|result| result as f32)
}

/// That the slice `name` is as long as the others.
pub fn same_length(kernel: &'static str, name: &'static str, expected: usize, found: usize) -> Result<(), LengthError> {
    if expected == found { Ok(()) } else { Err(LengthError { kernel, name, expected, found }) }
}

/// The text of a condition, by position.
fn condition(info: &Info, position: usize) -> &'static str {
    info.domain.get(position).copied().unwrap_or_default()
}
