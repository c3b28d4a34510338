//! The arithmetics one after another, each for the inputs that the one before leaves: what every shape of a call, and the
//! interpreter, falls back on.
//!
//! A tier is left where one of its steps does not keep its promise. The last, [`SoftFloat`], keeps it everywhere, so what comes
//! out is right for all finite inputs: conditions are decided exactly, and only results over- or underflow.
//!
//! A certified kernel has tiers of its own: balls of more and more words, until every condition is decided and
//! every result is right.

use core::cell::Cell;

use crate::ball::{Ball, Decisions};
use crate::filtered::Filtered;
use crate::filtered_double_double::FilteredDoubleDouble;
use crate::real::Real;
pub use crate::rounded::{Fate, Rounded};
use crate::soft_float::SoftFloat;

/// A program at a point, in any arithmetic.
pub trait Steps {
    /// One value a result.
    type Results<T>;

    /// The first condition, by position, that does not hold; all of them are evaluated. `number` reads an input.
    fn violated<R: Real>(&self, number: impl Fn(f64) -> R) -> Option<usize>;

    /// The results, whether or not the inputs lie in the domain, each read by `end`.
    fn results<R: Real, T>(&self, number: impl Fn(f64) -> R, end: impl Fn(R) -> T) -> Self::Results<T>;
}

/// The results, or the position of the first condition that does not hold.
pub type Answer<S> = Result<<S as Steps>::Results<Rounded>, usize>;

/// What a program in `f64` answers to finite inputs.
pub fn default<S: Steps>(steps: &S) -> Answer<S> {
    let escalate = Cell::new(false);
    let number = |value| Filtered::<true>::new(value, &escalate);
    attempt(steps, &escalate, number, |result| result.value()).unwrap_or_else(|| faithful(steps))
}

/// What a program answers to finite inputs with an error of less than one ulp.
pub fn faithful<S: Steps>(steps: &S) -> Answer<S> {
    let escalate = Cell::new(false);
    let number = |value| FilteredDoubleDouble::<true>::new(value, &escalate);
    attempt(steps, &escalate, number, FilteredDoubleDouble::round).unwrap_or_else(|| soft(steps))
}

/// In an arithmetic that neither over- nor underflows.
fn soft<S: Steps>(steps: &S) -> Answer<S> {
    match steps.violated(SoftFloat::from_f64) {
        Some(condition) => Err(condition),
        None => Ok(steps.results(SoftFloat::from_f64, Rounded::of)),
    }
}

/// The answer in an arithmetic, unless it raises `escalate`. Steps behind the results do not count outside the domain.
#[inline(always)]
fn attempt<S: Steps, R: Real>(
    steps: &S,
    escalate: &Cell<bool>,
    number: impl Fn(f64) -> R,
    round: impl Fn(R) -> f64,
) -> Option<Answer<S>> {
    let violated = steps.violated(&number);
    if escalate.get() {
        return None;
    }
    if let Some(condition) = violated {
        return Some(Err(condition));
    }
    let results = steps.results(number, |result| Rounded::kept(round(result)));
    (!escalate.get()).then_some(Ok(results))
}

/// What a certified program answers to finite inputs: each result off by [`CERTIFIED_ULP`](crate::error_model::CERTIFIED_ULP) at most.
pub fn certified<S: Steps>(steps: &S) -> Answer<S> {
    let undecided = || Ok(steps.results(SoftFloat::from_f64, |_| Rounded::UNDECIDED));
    in_balls::<S, 4>(steps)
        .or_else(|| in_balls::<S, 16>(steps))
        .or_else(|| in_balls::<S, 64>(steps))
        .unwrap_or_else(undecided)
}

/// The answer in balls of `L` words; `None` where they are too few.
#[inline(never)]
fn in_balls<S: Steps, const L: usize>(steps: &S) -> Option<Answer<S>> {
    let decisions = Decisions::default();
    let number = |value| Ball::<L>::new(value, &decisions);
    let violated = steps.violated(number);
    if decisions.is_undecided() {
        return None;
    }
    if let Some(condition) = violated {
        return Some(Err(condition));
    }
    let open = Cell::new(false);
    let results = steps.results(number, |ball| {
        let accepted = ball.accepted();
        open.set(open.get() | accepted.is_none());
        accepted.map_or(Rounded::UNDECIDED, |(value, exact)| Rounded::to_nearest(value, exact))
    });
    (!open.get() && !decisions.is_undecided()).then_some(Ok(results))
}
