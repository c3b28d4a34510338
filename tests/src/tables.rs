//! What the tables of kernels promise: they decide the domain, and state errors that are never exceeded.

use closedform::{Aim, Certified, Domain, Fate, settle};
use rug::Float;

use crate::check::Judge;
use crate::domain::FINITE;
use crate::failure::{list, replay};
use crate::inputs::Points;

/// Bits to which the oracle is trusted.
const TRUSTED: i32 = 70;

/// Demands of each point that the domain is decided as it should be, and of each result inside that the exact value is
/// no farther than the stated error, which is as small as certified calls promise. The number of results judged.
///
/// # Errors
///
/// The first point where it is not so.
pub fn check(judge: &Judge, points: &Points, aim: Aim) -> Result<usize, String> {
    let info = judge.kernel.info;
    let table = judge.kernel.table().ok_or_else(|| format!("{}: no table", info.name))?;
    let mut judged = 0;
    for inputs in &points.list {
        let told = |what: &str| {
            let replay = replay(info, inputs);
            format!("{}: {what}\n{}  from {}\n  {replay}", info.name, list(info, inputs), points.origin)
        };
        let violated = judge.space.domain().violated(inputs);
        if violated == Some(FINITE) {
            continue;
        }
        let mut results = vec![Certified::default(); info.results.len()];
        let named = match settle(table, inputs, aim, &mut results) {
            Domain::Inside => None,
            Domain::Outside(position) => Some(info.domain[position]),
            Domain::Undecided => return Err(told("the domain is not decided")),
        };
        if named != violated {
            return Err(told(&format!("violates {violated:?}, not {named:?}")));
        }
        for (position, found) in results.iter().enumerate().filter(|_| violated.is_none()) {
            complaint(found, &judge.exact(position, inputs)).map_or(Ok(()), |what| Err(told(&what)))?;
            judged += 1;
        }
    }
    Ok(judged)
}

/// What is wrong with a result.
fn complaint(Certified { rounded, error }: &Certified, exact: &Float) -> Option<String> {
    let value = rounded.value;
    match rounded.fate {
        Fate::Kept | Fate::Underflows => {}
        Fate::Overflows if exact.clone().abs() >= f64::MAX => return None,
        fate => return Some(format!("{fate:?}, the value is {exact:e}")),
    }
    let off = (Float::with_val(exact.prec(), value) - exact).abs();
    let doubt = exact.clone().abs() >> TRUSTED;
    if Float::with_val(exact.prec(), &off - &doubt) > *error {
        return Some(format!("{value:e} is off by {off:e}, more than {error:e}; the value is {exact:e}"));
    }
    // half of a unit in the last place and what certified results are off by besides, rounded up twice: among the
    // subnormal numbers that is seen
    let unit = value.abs().next_up() - value.abs();
    let allowed = 0.51 * unit + 2.0 * f64::from_bits(1);
    (*error > allowed).then(|| format!("an error of {error:e} is stated for {value:e}"))
}
