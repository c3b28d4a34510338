//! Precision raised until the digits of a value are told, or stop changing.

use std::collections::BTreeMap;

use rug::Float;

use crate::ast::Expr;

use super::enclosure::enclosure;
use super::error::EvalError;
use super::evaluate_noting;
use super::interval::Unknown;
use super::notes::Notes;

/// The highest precision that is tried, in bits.
pub const PRECISION_LIMIT: u32 = 1 << 14;

/// Bits beyond those asked for at the first try.
const GUARD_BITS: u32 = 64;

/// How often in a row a value must be noise before it is taken for zero, and a number near a step before it is taken for one there.
const NOISE_COUNT: u32 = 3;

/// The value of the expression at exactly these inputs, the first `bits` bits of which are right.
///
/// The precision doubles until the value lies between two numbers that share these bits. Where it never does, as where it is zero, or
/// depends on which of two equal numbers is larger, it is what precision after precision agrees on.
///
/// That is, until two results in a row agree to `bits` bits, or until the result is zero: exactly, twice, or nothing but rounding noise
/// that shrinks as the precision grows. A number that is as near to a step of `floor` and the like, or to one that it is compared with,
/// however high the precision, is the number there. The precision then starts the higher, the farther the magnitudes of the inputs lie
/// apart, and those of functions such as `exp` from 1, lest a small number is lost beside a large one at two precisions in a row.
///
/// # Errors
///
/// As `evaluate`; or the digits do not settle up to `PRECISION_LIMIT`.
pub fn evaluate_stable(expression: &Expr, inputs: &BTreeMap<String, f64>, bits: u32) -> Result<Float, EvalError> {
    let exact: BTreeMap<String, Float> =
        inputs.iter().map(|(name, value)| (name.clone(), Float::with_val(f64::MANTISSA_DIGITS, value))).collect();
    match enclosed(expression, &exact, bits) {
        Some(value) => Ok(value),
        None => agreed(expression, &exact, bits),
    }
}

/// The value, if it can be told from all others to so many bits.
fn enclosed(expression: &Expr, inputs: &BTreeMap<String, Float>, bits: u32) -> Option<Float> {
    let mut precision = first_precision(bits, 0);
    while precision <= PRECISION_LIMIT {
        match enclosure(expression, inputs, precision) {
            Ok(interval) => {
                if let Some(value) = interval.value(bits) {
                    return Some(value);
                }
            }
            Err(Unknown::Undecided) => {}
            Err(Unknown::Unsupported) => return None,
        }
        precision *= 2;
    }
    None
}

/// The value on which precision after precision agrees.
fn agreed(expression: &Expr, exact: &BTreeMap<String, Float>, bits: u32) -> Result<Float, EvalError> {
    let (low, high) = exponents(exact);
    let spread = low.abs_diff(high);
    let mut precision = first_precision(bits, spread);
    let evaluated = |precision| Evaluated::of(expression, exact, low, precision);
    let mut first = evaluated(precision);
    let reach = first.notes.reach.get();
    if reach > spread {
        precision = first_precision(bits, reach);
        first = evaluated(precision);
    }
    let (mut noise, mut near) = (count_noise(0, &first, low, precision), u32::from(first.notes.is_near_step.get()));
    let mut previous = first.value;
    while precision < PRECISION_LIMIT {
        precision *= 2;
        let found = evaluated(precision);
        noise = count_noise(noise, &found, low, precision);
        near = if found.notes.is_near_step.get() { near + 1 } else { 0 };
        let is_told = !found.notes.lost_fraction.get() && (near == 0 || near >= NOISE_COUNT);
        let next = found.value;
        match (&previous, &next) {
            (Ok(_), Ok(_)) if !is_told => previous = next,
            (Ok(earlier), Ok(later)) if agree(earlier, later, bits) => return next,
            (_, Ok(_)) if noise >= NOISE_COUNT => return Ok(Float::new(precision)),
            (_, Err(error)) if !error.may_be_rounding() => return next,
            _ => previous = next,
        }
    }
    previous.and_then(|_| Err(EvalError::Unsettled { precision, span: expression.span.clone() }))
}

/// A value at one precision, and what was noted on the way.
struct Evaluated {
    value: Result<Float, EvalError>,
    notes: Notes,
}

impl Evaluated {
    fn of(expression: &Expr, inputs: &BTreeMap<String, Float>, low: i32, precision: u32) -> Self {
        let notes = Notes { takes_near_for_equal: true, noise: noise_border(low, precision), ..Notes::default() };
        let value = evaluate_noting(expression, inputs, precision, &notes);
        Self { value, notes }
    }
}

/// The smallest and the greatest binary exponent among the inputs and 1.
fn exponents(inputs: &BTreeMap<String, Float>) -> (i32, i32) {
    let exponents = inputs.values().filter_map(Float::get_exp);
    exponents.fold((1, 1), |(low, high), exponent| (low.min(exponent), high.max(exponent)))
}

fn first_precision(bits: u32, spread: u32) -> u32 {
    let wanted = bits.saturating_add(GUARD_BITS).saturating_add(4 * spread);
    wanted.clamp(128, PRECISION_LIMIT / 4)
}

/// Whether the values are both zero, or equal to `bits` bits.
fn agree(earlier: &Float, later: &Float, bits: u32) -> bool {
    let difference = Float::with_val(later.prec(), earlier - later);
    match (difference.get_exp(), later.get_exp()) {
        (None, _) => true,
        (Some(difference), Some(value)) => i64::from(difference) < i64::from(value) - i64::from(bits),
        (Some(_), None) => false,
    }
}

/// The binary exponent below which a number is far below the smallest input, as only rounding makes it.
fn noise_border(low: i32, precision: u32) -> i64 {
    i64::from(low) - i64::from(precision / 2)
}

/// The count raised if the value is far below the smallest input, as only rounding makes it; otherwise 0.
fn count_noise(count: u32, found: &Evaluated, low: i32, precision: u32) -> u32 {
    let border = noise_border(low, precision);
    match &found.value {
        Ok(value)
            if !found.notes.lost_fraction.get()
                && value.get_exp().is_none_or(|exponent| i64::from(exponent) < border) =>
        {
            count + 1
        }
        _ => 0,
    }
}
