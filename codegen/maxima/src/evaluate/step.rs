//! Functions whose values are integers, and comparisons, at numbers that are rounded.

use std::cmp::Ordering;

use rug::Float;

use super::notes::Notes;

/// The function of this name.
pub(super) fn named(name: &str) -> Option<fn(Float) -> Float> {
    Some(match name {
        "floor" | "entier" => Float::floor,
        "ceiling" => Float::ceil,
        "round" => Float::round_even,
        "truncate" => Float::trunc,
        _ => return None,
    })
}

/// Its value. Where it is asked for, a number that half of the bits do not tell from a multiple of 1/2 is taken for that, and
/// this is noted: what is nearer at every precision is that number.
pub(super) fn value(notes: &Notes, function: fn(Float) -> Float, argument: Float) -> Float {
    if !notes.takes_near_for_equal {
        return function(argument);
    }
    let told = argument.get_exp().unwrap_or(0).max(0) - (argument.prec() / 2).cast_signed();
    if told > -2 {
        notes.lost_fraction.set(true);
        return function(argument);
    }
    let place = (argument.clone() * 2u32).round() / 2u32;
    let distance = Float::with_val(argument.prec(), &argument - &place);
    let is_near = distance.get_exp().is_none_or(|exponent| exponent <= told);
    if is_near {
        notes.is_near_step.set(true);
    }
    function(if is_near { place } else { argument })
}

/// Which number is larger; `None` of NaN. Where it is asked for, numbers that half of the bits do not tell apart, or that only noise
/// does, are taken for equal, and this is noted: what is nearer at every precision is equal.
pub(super) fn order(notes: &Notes, left: &Float, right: &Float) -> Option<Ordering> {
    let order = left.partial_cmp(right)?;
    let difference = Float::with_val(left.prec(), left - right);
    let (Some(difference), Some(size)) = (difference.get_exp(), left.get_exp().max(right.get_exp())) else {
        return Some(order);
    };
    let half = i64::from(left.prec() / 2);
    let is_near = i64::from(difference) <= notes.noise.max(i64::from(size) - half);
    if notes.takes_near_for_equal && is_near {
        notes.is_near_step.set(true);
        return Some(Ordering::Equal);
    }
    Some(order)
}
